//! The supremum of |P^∞ − P^k|, between a value that it takes and a bound.

use super::cell::{Cell, Splitting};
use super::fraction::Fraction;
use super::remainder::{LevelBound, Remainders};
use crate::bound::Share;
use crate::exact::Rational;

/// How many levels below k cells are split.
const MAX_DEEPER: u32 = 96;

/// The greatest value found, and where.
#[derive(Clone, Debug)]
pub(super) struct Best {
    pub(super) value: Rational,
    /// t.
    pub(super) parameter: Rational,
}

/// When a search is done.
pub(super) enum Goal {
    /// When the bound is at most this above the greatest value found.
    Width(Rational),
    /// When the supremum is shown to be at most this, or a greater value is found.
    Threshold(Rational),
}

impl Goal {
    fn settles(&self, bound: &Fraction, best: &Rational) -> bool {
        match self {
            Goal::Width(width) => *bound <= Fraction::from(&(best + width)),
            Goal::Threshold(threshold) => *bound <= Fraction::from(threshold) || best > threshold,
        }
    }
}

/// A search for the supremum of |P^∞ − P^k| over some cells and their parts, depth first
/// and the part with the greatest bound first. A cell whose bound settles the goal is
/// dropped.
///
/// Source: `proofs/THEOREMS.md`, 8 and 88.
pub(super) struct Search<'a> {
    splitting: &'a Splitting,
    remainders: &'a Remainders,
    roots: &'a [Cell],
    level: u32,
    /// Of |P^∞ − P^j|, j = 0, …, k.
    bounds: Vec<LevelBound>,
    /// How many cells may still be looked at.
    cells: u32,
    /// How many steps this may still take.
    share: &'a Share<'a>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        splitting: &'a Splitting,
        remainders: &'a Remainders,
        roots: &'a [Cell],
        level: u32,
        cells: u32,
        share: &'a Share<'a>,
    ) -> Search<'a> {
        let bounds = remainders.levels(level);
        Search { splitting, remainders, roots, level, bounds, cells, share }
    }

    /// Whether more cells may be looked at.
    pub(super) fn goes_on(&self) -> bool {
        self.cells > 0 && self.share.goes_on()
    }

    /// A bound of the supremum without splitting any cell.
    pub(super) fn bound(&self, best: &mut Best) -> Rational {
        let bounded = self.bounded(self.start(), None, best).pop();
        bounded.map_or_else(Rational::zero, |(bound, _)| bound.reduced())
    }

    /// Searches all cells, improves on `best`, and gives a bound of the supremum, which
    /// is within the goal unless a cap was met.
    pub(super) fn run(&mut self, goal: &Goal, best: &mut Best) -> Rational {
        let mut upper = Fraction::from(&best.value);
        let mut stack = self.bounded(self.start(), None, best);
        while let Some((bound, cell)) = stack.pop() {
            let deep = cell.level >= self.level + MAX_DEEPER;
            if deep || goal.settles(&bound, &best.value) || !self.takes(&cell) {
                upper = upper.max(bound);
                continue;
            }
            let parts = self.splitting.split(&cell, self.level);
            stack.extend(self.bounded(parts.into_iter(), Some(&bound), best));
        }
        upper.reduced()
    }

    /// Whether this cell may be split; if not, none may any more.
    fn takes(&mut self, cell: &Cell) -> bool {
        if self.cells > 0 && self.share.take(self.splitting.cost(cell)) {
            self.cells -= 1;
            return true;
        }
        self.cells = 0;
        false
    }

    /// The roots, as cells of a search.
    fn start(&self) -> impl Iterator<Item = Cell> {
        self.roots.iter().map(|root| self.splitting.with_ends(root.clone(), self.level))
    }

    /// The cells with their bounds, the greatest last. No part has a greater bound
    /// than the whole.
    fn bounded(
        &self,
        cells: impl Iterator<Item = Cell>,
        whole: Option<&Fraction>,
        best: &mut Best,
    ) -> Vec<(Fraction, Cell)> {
        let mut bounded: Vec<(Fraction, Cell)> = cells
            .map(|cell| {
                let bound = self.bound_over(&cell, best);
                let bound = whole.filter(|whole| **whole < bound).cloned().unwrap_or(bound);
                (bound, cell)
            })
            .collect();
        bounded.sort_by(|one, other| one.0.cmp(&other.0));
        bounded
    }

    /// A bound of |P^∞ − P^k| over the cell: by the level that remains up to k, and from
    /// k on by the values at its ends, which improve on `best`.
    fn bound_over(&self, cell: &Cell, best: &mut Best) -> Fraction {
        let sizes = self.splitting.sizes(cell);
        let remaining = self.level.checked_sub(cell.level);
        let by_level = remaining.map(|j| self.bounds[j as usize].over(&sizes));
        let by_ends = self.splitting.distances(cell).map(|ends| {
            for (end, value) in (0..).zip(&ends) {
                if *value > Fraction::from(&best.value) {
                    let parameter = self.splitting.parameter(cell, end);
                    *best = Best { value: value.clone().reduced(), parameter };
                }
            }
            self.remainders.between(&ends, self.splitting.end_scale(), &sizes)
        });
        let bounds = by_level.into_iter().chain(by_ends);
        bounds.min().expect("a cell above level k has values at its ends")
    }
}
