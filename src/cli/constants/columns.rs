//! The constants T_c and Λ_c of a mask for c = 1, 2, …, while their progress is shown.

use crate::cli::console::interrupt::{Interrupt, reason, were_stopped};
use crate::cli::console::progress::Progress;
use subcert::bound::{Budget, Order, PowerSearch};
use subcert::cores::together;
use subcert::exact::Rational;
use subcert::scheme::{Mask, Rules};

/// The most steps for the constants of one column.
const MAX_STEPS: u64 = 8_000_000_000;

/// What is asked for.
pub(crate) struct Wanted {
    /// The greatest c.
    pub(crate) levels: u32,
    /// Whether the forward order is wanted, too.
    pub(crate) forward: bool,
    /// Whether progress is shown on a terminal.
    pub(crate) progress: bool,
}

/// T_c and Λ_c in adjoint order, then, if they were asked for, both in forward order; each for c = 1, 2, …, as
/// far as they are in reach; and why some of them are missing.
pub(crate) type Columns = (Vec<Vec<Rational>>, Option<String>);

/// Why the rest of a column is missing.
const OUT_OF_REACH: &str = "not found within the caps on work, by branch and bound, by extreme rows or by a visit of all \
                            rows";

/// The columns of a mask. Each has a thread and a budget of its own, so that how far it gets does not depend
/// on the others. When the user interrupts, all end with what they have.
pub(crate) fn columns(mask: &Mask, difference: &Rules, wanted: &Wanted) -> Columns {
    let orders = [Order::Adjoint, Order::Forward];
    let orders = &orders[..if wanted.forward { 2 } else { 1 }];
    let all = orders.iter().flat_map(|&order| [difference, mask.rules()].map(|one| (one, order)));
    let budgets: Vec<Budget> = (0..2 * orders.len()).map(|_| Budget::new(MAX_STEPS)).collect();
    let progress = Progress::of_steps(&budgets, wanted.progress);
    let interrupt = Interrupt::stops(&budgets);
    let found: Vec<Vec<Rational>> = together(
        all.zip(&budgets)
            .map(|((rules, order), budget)| move || column(rules, order, budget, wanted.levels)),
    );
    let is_whole = found.iter().all(|column| column.len() as u64 == u64::from(wanted.levels));
    let why = if were_stopped() { reason() } else { OUT_OF_REACH.to_owned() };
    drop((interrupt, progress));
    (found, (!is_whole).then_some(why))
}

/// The norms of the powers up to the first that is out of reach.
fn column(rules: &Rules, order: Order, budget: &Budget, levels: u32) -> Vec<Rational> {
    let mut search = PowerSearch::new(rules, order).with_budget(budget.clone()).with_extreme_rows();
    (1..=levels).map_while(|c| Some(search.norm(c).ok()?.value)).collect()
}
