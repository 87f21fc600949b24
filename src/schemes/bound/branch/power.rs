//! The norms of the powers of one operator.

use super::growth::Growth;
use super::search_tree::SearchTree;
use super::searched::{Searched, either, unscaled};
use crate::bound::budget::Budget;
use crate::bound::extreme::ExtremeSearch;
use crate::bound::power::{ClassCap, MAX_LEVELS, MAX_WORK, Order, PowerNorm, oriented};
use crate::bound::walked_norm::walked_norm;
use crate::scheme::Rules;

/// The products of words after which a tree is given up for extreme rows.
const SMALL_TREE: u64 = 1 << 24;

/// ‖R^c‖ for several c. Later searches use what earlier ones found about R.
///
/// ```
/// use subcert::bound::{Order, PowerSearch};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("four-point")?;
/// let mut search = PowerSearch::new(&scheme.masks()[0].difference(), Order::Adjoint);
/// let found = search.search(64).expect("the work suffices");
/// // 2^c·T_c tends to 4/3.
/// let rest = Rational::new(4, 3) - &found.norm.value * Rational::from(2).pow(64);
/// assert!(rest.sign() > 0 && rest < Rational::from(4).pow(-63));
/// assert!(found.nodes < 2000);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PowerSearch {
    /// The rules in the given order.
    rules: Rules,
    growth: Growth,
    budget: Budget,
    extreme: Extreme,
    /// Whether the tree was given up for extreme rows.
    given_up: bool,
}

/// The search by extreme rows.
#[derive(Clone, Debug)]
enum Extreme {
    /// It was not asked for.
    Unused,
    /// It does not take these rules.
    Unfit,
    Search(Box<ExtremeSearch>),
}

impl Extreme {
    fn of(rules: &Rules) -> Extreme {
        ExtremeSearch::new(rules).map_or(Extreme::Unfit, |search| Extreme::Search(Box::new(search)))
    }
}

impl PowerSearch {
    /// A search for the powers of the operator of these rules, read in this order.
    #[must_use]
    pub fn new(rules: &Rules, order: Order) -> PowerSearch {
        let rules = oriented(rules, order);
        let [growth] = Growth::of([&rules]);
        PowerSearch {
            rules,
            growth,
            budget: Budget::unlimited(),
            extreme: Extreme::Unused,
            given_up: false,
        }
    }

    /// This search with a budget in products of words, which other computations may
    /// share.
    #[must_use]
    pub fn with_budget(mut self, budget: Budget) -> PowerSearch {
        self.growth.watch(budget.clone());
        PowerSearch { budget, ..self }
    }

    /// This search with extreme rows for [`norm`](PowerSearch::norm), where the tree is large: of the rows of
    /// lower powers only the extreme points of their hull are continued. Certificates have no proof of these
    /// norms.
    ///
    /// Source: `proofs/THEOREMS.md`, 113 to 115.
    #[must_use]
    pub fn with_extreme_rows(mut self) -> PowerSearch {
        self.growth.sharpen();
        PowerSearch { extreme: Extreme::of(&self.rules), ..self }
    }

    /// ‖R^c‖ and the least class that attains it, as
    /// [`power_norm`](crate::bound::power_norm); after
    /// [`with_extreme_rows`](PowerSearch::with_extreme_rows) possibly another class that attains it.
    ///
    /// # Errors
    /// When c is above [`MAX_LEVELS`], or when the search does not end within 2^33 products
    /// and there are more than 2^24 residue classes; or when the budget does not suffice.
    pub fn norm(&mut self, levels: u32) -> Result<PowerNorm, ClassCap> {
        let PowerSearch { rules, growth, budget, extreme, given_up } = self;
        let walk = || walked_norm(rules, levels, Order::Adjoint);
        let watched = budget.clone();
        either([rules], levels, budget, walk, |work| {
            if !(1..=MAX_LEVELS).contains(&levels) {
                return None;
            }
            let Extreme::Search(extreme) = extreme else {
                return Some(found(growth, levels, work)?.norm);
            };
            if !*given_up {
                let mut share = SMALL_TREE.min(*work);
                let whole = share;
                let norm = found(growth, levels, &mut share);
                *work -= whole - share;
                match norm {
                    Some(found) => return Some(found.norm),
                    None => *given_up = true,
                }
            }
            let norm = extreme.norm(levels, work, &watched);
            norm.or_else(|| Some(found(growth, levels, work)?.norm))
        })
    }

    /// ‖R^c‖ and a class that attains it, by extreme rows, however few residue classes there are; the class is
    /// the least one, unless two rows of a lower power are equal or opposite. `None` when a coefficient over
    /// the common denominator is above 2^53, a level has more than 4,096 extreme rows or hardly any others,
    /// the search does not end within 2^33 products and the budget, or c is 0 or above [`MAX_LEVELS`].
    ///
    /// ```
    /// use subcert::bound::{Order, PowerSearch};
    /// use subcert::exact::Rational;
    /// use subcert::scheme::Rules;
    ///
    /// // x'_{2i} = 3/5 x_i, x'_{2i+1} = −7/10 x_i.
    /// let rules = Rules::new(vec![vec![Rational::new(3, 5)], vec![Rational::new(-7, 10)]], 0)?;
    /// let mut search = PowerSearch::new(&rules, Order::Adjoint);
    /// let norm = search.extreme_rows(200).expect("one row of each level is the longest");
    /// assert_eq!(norm.value, Rational::new(7, 10).pow(200));
    /// # Ok::<(), subcert::scheme::RulesError>(())
    /// ```
    pub fn extreme_rows(&mut self, levels: u32) -> Option<PowerNorm> {
        if !(1..=MAX_LEVELS).contains(&levels) {
            return None;
        }
        if matches!(self.extreme, Extreme::Unused) {
            self.extreme = Extreme::of(&self.rules);
        }
        let Extreme::Search(search) = &mut self.extreme else { return None };
        let budget = &self.budget;
        budget.spend(MAX_WORK, |work| search.norm(levels, work, budget))
    }

    /// ‖R^c‖ by branch and bound, however few residue classes there are; `None` when the
    /// search does not end within 2^33 products and the budget, or c is above
    /// [`MAX_LEVELS`].
    pub fn search(&mut self, levels: u32) -> Option<Searched> {
        self.budget.clone().spend(MAX_WORK, |work| found(&mut self.growth, levels, work))
    }

    /// A tree of bounds that proves the value of ‖E^c‖, with the bounds of lower powers that
    /// it uses; `None` as for [`search`](PowerSearch::search). Each node is bounded by its own
    /// rows only, so this tree may be larger than the tree of the search.
    pub fn tree(&mut self, levels: u32) -> Option<SearchTree> {
        let tree = |work: &mut u64| self.growth.tree(levels, work);
        (levels <= MAX_LEVELS).then(|| self.budget.clone().spend(MAX_WORK, tree))?
    }
}

fn found(growth: &mut Growth, levels: u32, work: &mut u64) -> Option<Searched> {
    let found = (levels <= MAX_LEVELS).then(|| growth.greatest(levels, work))??;
    Some(unscaled([growth.operator()], levels, found))
}
