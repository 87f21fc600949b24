//! The exact norms of the powers of one operator, by extreme rows.

use super::exact_rows::ExactRows;
use super::levels::Levels;
use super::step::Steps;
use crate::bound::budget::Budget;
use crate::bound::power::PowerNorm;
use crate::exact::CommonDenominator;
use crate::scheme::Rules;

/// ‖R^c‖ for several c. The levels are computed once.
#[derive(Clone, Debug)]
pub(crate) struct ExtremeSearch {
    levels: Levels,
    exact: ExactRows,
}

impl ExtremeSearch {
    /// `None` if a coefficient, times the common denominator, is above 2^53.
    pub(crate) fn new(rules: &Rules) -> Option<ExtremeSearch> {
        let CommonDenominator { denominator, numerators } = CommonDenominator::of(rules.rows());
        let exact = ExactRows::new(&numerators, denominator, rules.offset());
        let levels = Levels::new(Steps::new(&exact.matrices)?);
        Some(ExtremeSearch { levels, exact })
    }

    /// ‖R^c‖ and a class that attains it, for c ≥ 1. `None` when a cap is met, the work does not suffice,
    /// the budget is stopped,
    /// or the rows that were dropped leave it open.
    ///
    /// The class is the least one, unless for some m < c two rows of R^m are equal or opposite.
    pub(crate) fn norm(
        &mut self,
        levels: u32,
        work: &mut u64,
        budget: &Budget,
    ) -> Option<PowerNorm> {
        let count = levels as usize;
        while self.levels.done().len() < count {
            if budget.is_stopped() {
                return None;
            }
            self.levels.advance(work)?;
        }
        let level = &self.levels.done()[count - 1];
        if !level.proven {
            return None;
        }
        self.exact.longest(&self.levels.done()[..count], &level.longest)
    }
}
