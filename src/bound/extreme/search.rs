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
pub(in crate::bound) struct ExtremeSearch {
    levels: Levels,
    exact: ExactRows,
}

impl ExtremeSearch {
    /// `None` if a coefficient, times the common denominator, is above 2^53.
    pub(in crate::bound) fn new(rules: &Rules) -> Option<ExtremeSearch> {
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
    pub(in crate::bound) fn norm(
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
            self.advance(work)?;
        }
        let level = &self.levels.done()[count - 1];
        let found = level.longest.iter().map(|&at| {
            let word = self.levels.word(count, at);
            let value = self.exact.norm(&self.exact.row(&word), levels);
            PowerNorm { value, class: self.exact.class(&word) }
        });
        let better = |one: &PowerNorm, other: &PowerNorm| {
            one.value.cmp(&other.value).then_with(|| other.class.cmp(&one.class))
        };
        if level.proven { found.max_by(better) } else { None }
    }

    /// Adds a level. Rows that are equal up to rounding are computed exactly.
    fn advance(&mut self, work: &mut u64) -> Option<()> {
        let last = self.levels.done().len();
        let count = self.levels.done().last().map_or(1, |level| level.origins.len());
        let words: Vec<Vec<usize>> = (0..count).map(|at| self.levels.word(last, at)).collect();
        let exact = &mut self.exact;
        self.levels.advance(work, |one, other| exact.same(one, other, &words))?;
        self.exact.advance(&self.levels.done()[last].origins);
        Some(())
    }
}
