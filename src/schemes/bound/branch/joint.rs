//! Joint suprema: one row index for two operators.

use super::growth::Growth;
use super::problem::{Problem, threads};
use super::search_tree::SearchTree;
use super::searched::{Searched, either, unscaled};
use crate::bound::budget::Budget;
use crate::bound::power::{ClassCap, MAX_LEVELS, MAX_WORK, Order, PowerNorm, oriented};
use crate::bound::walked_norm::walked_joint_norm;
use crate::scheme::Rules;

/// `max_r Σ_s |(R^c)_{r,s}| · Σ_s |(S^c)_{r,s}|` for several c, with the values of
/// [`joint_norm`](super::super::joint_norm). Later searches use what earlier ones found about R
/// and S.
///
/// ```
/// use subcert::bound::{JointSearch, Order};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("four-point")?;
/// let mask = scheme.masks()[0];
/// let mut search = JointSearch::new(&mask.difference(), mask.rules(), Order::Adjoint);
/// assert!(search.search(64).expect("the work suffices").nodes < 2000);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct JointSearch {
    /// The rules in the given order, at offset 0.
    rules: [Rules; 2],
    growths: [Growth; 2],
    budget: Budget,
}

impl JointSearch {
    /// A search for the operators of these rules, read in this order, at offset 0.
    ///
    /// # Panics
    /// When arity or width differ.
    #[must_use]
    pub fn new(first: &Rules, second: &Rules, order: Order) -> JointSearch {
        assert_eq!(first.arity(), second.arity(), "joint suprema need equal arities");
        assert_eq!(first.width(), second.width(), "joint suprema need equal widths");
        let rules = [first, second].map(|rules| oriented(rules, order).with_offset(0));
        let growths = Growth::of(rules.each_ref());
        JointSearch { rules, growths, budget: Budget::unlimited() }
    }

    /// This search with a budget for [`norm`](JointSearch::norm), as in
    /// [`PowerSearch::with_budget`](super::PowerSearch::with_budget).
    #[must_use]
    pub fn with_budget(self, budget: Budget) -> JointSearch {
        JointSearch { budget, ..self }
    }

    /// The greatest product, and the least class that attains it.
    ///
    /// # Errors
    /// As [`PowerSearch::norm`](super::PowerSearch::norm).
    pub fn norm(&mut self, levels: u32) -> Result<PowerNorm, ClassCap> {
        let [first, second] = self.rules.clone();
        let walk = || walked_joint_norm(&first, &second, levels, Order::Adjoint);
        let budget = self.budget.clone();
        either([&first, &second], levels, &budget, walk, |work| {
            Some(self.search_within(levels, work)?.norm)
        })
    }

    /// The greatest product by branch and bound, however few residue classes there are;
    /// `None` as for [`PowerSearch::search`](super::PowerSearch::search).
    pub fn search(&mut self, levels: u32) -> Option<Searched> {
        self.search_within(levels, &mut { MAX_WORK })
    }

    fn search_within(&mut self, levels: u32, work: &mut u64) -> Option<Searched> {
        let problem = self.problem(levels, work)?;
        let found = problem.greatest(work)?;
        Some(unscaled(problem.operators, levels, found))
    }

    /// A tree of bounds that proves the greatest product for the two operators E, as
    /// [`PowerSearch::tree`](super::PowerSearch::tree).
    pub fn tree(&mut self, levels: u32) -> Option<SearchTree> {
        let mut work = MAX_WORK;
        let problem = self.problem(levels, &mut work)?;
        let greatest = problem.greatest(&mut work)?;
        let leaves = problem.leaves(&greatest, &mut work)?;
        Some(Growth::search_tree(self.growths.each_ref(), levels, greatest, leaves))
    }

    fn problem(&mut self, levels: u32, work: &mut u64) -> Option<Problem<'_, 2>> {
        if levels > MAX_LEVELS {
            return None;
        }
        for growth in &mut self.growths {
            growth.prepare(levels, work)?;
        }
        let operators = self.growths.each_ref().map(Growth::operator);
        let reach = self.growths.each_ref().map(Growth::reach);
        Some(Problem { operators, reach, levels, threads: threads(), budget: &self.budget })
    }
}
