//! The search for the supremum of |P^∞ − P^k|, between an attained value and an upper
//! bound.

use super::cell::{Cell, Splitting};
use super::fraction::Fraction;
use super::polygon::Polygons;
use super::remainder::{LevelBound, Remainders};
use crate::bound::Share;
use crate::exact::Rational;

/// Cells are split down to this number of levels beyond k.
const MAX_DEEPER: u32 = 96;

/// The greatest value found, and its parameter.
#[derive(Clone, Debug)]
pub(crate) struct Best {
    pub(super) value: Rational,
    /// t.
    pub(crate) parameter: Rational,
}

/// The goal of a search.
pub(crate) enum Goal {
    /// The upper bound exceeds the greatest value found by at most this.
    Width(Rational),
    /// The supremum is proved to be at most this, or a greater value is found.
    Threshold(Rational),
}

impl Goal {
    /// The greatest bound that meets the goal, if this is the greatest value found; `None` if every
    /// bound does.
    fn enough(&self, best: &Rational) -> Option<Fraction> {
        match self {
            Goal::Width(width) => Some(Fraction::from(&(best + width))),
            Goal::Threshold(threshold) => (best <= threshold).then(|| Fraction::from(threshold)),
        }
    }
}

/// A search for the supremum of |P^∞ − P^k| over some cells. It goes depth first, and
/// takes the part with the greatest bound first. A cell whose bound meets the goal is not
/// split. Of an open polygon, parts without a parameter of its range are left out, and values at
/// the ends of cells count in the range alone.
///
/// Source: `proofs/THEOREMS.md`, 8 and 88.
pub(crate) struct Search<'a> {
    splitting: &'a Splitting,
    remainders: &'a Remainders,
    roots: &'a [Cell],
    /// The parameters that are searched, if cells go beyond them.
    range: Option<&'a [Rational; 2]>,
    level: u32,
    /// The bounds of |P^∞ − P^j|, j = 0, …, k.
    bounds: Vec<LevelBound>,
    /// The number of cells that may still be split.
    cells: u32,
    /// The steps that the search may still take.
    share: &'a Share<'a>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        splitting: &'a Splitting,
        remainders: &'a Remainders,
        among: &'a Polygons<'a>,
        level: u32,
        cells: u32,
        share: &'a Share<'a>,
    ) -> Search<'a> {
        let bounds = remainders.levels(level);
        let cut = |range: &&[Rational; 2]| {
            splitting.is_shifted() || !range.iter().all(Rational::is_integer)
        };
        let range = among.range.as_ref().filter(cut);
        Search { splitting, remainders, roots: &among.roots, range, level, bounds, cells, share }
    }

    /// Whether more cells may be split.
    fn goes_on(&self) -> bool {
        self.cells > 0 && self.share.goes_on()
    }

    /// An upper bound of the supremum without splitting any cell.
    pub(crate) fn bound(&self, best: &mut Best) -> Rational {
        let bounded = self.bounded(self.start(), None, best).pop();
        bounded.map_or_else(Rational::zero, |(bound, _)| bound.reduced())
    }

    /// Searches all cells and improves `best`. Returns an upper bound of the supremum,
    /// which meets the goal unless a cap was reached.
    pub(crate) fn run(&mut self, goal: &Goal, best: &mut Best) -> Rational {
        let mut upper = Fraction::from(&best.value);
        let mut stack = self.bounded(self.start(), None, best);
        let (mut found, mut enough) = (best.value.clone(), goal.enough(&best.value));
        while let Some((bound, cell)) = stack.pop() {
            if best.value != found {
                (found, enough) = (best.value.clone(), goal.enough(&best.value));
            }
            let deep = cell.level >= self.level + MAX_DEEPER;
            let settled = enough.as_ref().is_none_or(|enough| bound <= *enough);
            if deep || settled || !self.takes(&cell) {
                upper = upper.max(bound);
                continue;
            }
            let parts = self.splitting.split(&cell, self.level).into_iter();
            let inside =
                |part: &Cell| self.range.is_none_or(|range| self.splitting.meets(part, range));
            stack.extend(self.bounded(parts.filter(inside), Some(&bound), best));
        }
        upper.reduced()
    }

    /// Improves an upper bound and `best` until they differ by `width` or a cap is reached. First, coarse searches find good
    /// values; with them the next search splits fewer cells.
    pub(crate) fn narrowed(
        &mut self,
        mut upper: Rational,
        width: &Rational,
        best: &mut Best,
    ) -> Rational {
        let mut step = &upper - &best.value;
        while &upper - &best.value > *width && step > *width && self.goes_on() {
            step = (step / Rational::from(4)).max(width.clone());
            upper = self.run(&Goal::Width(step.clone()), best).min(upper);
        }
        upper
    }

    /// Takes the cost of splitting this cell; if it does not remain, no further cell may
    /// be split.
    fn takes(&mut self, cell: &Cell) -> bool {
        if self.cells > 0 && self.share.take(self.splitting.cost(cell)) {
            self.cells -= 1;
            return true;
        }
        self.cells = 0;
        false
    }

    /// The cells of level 0 at which the search starts.
    fn start(&self) -> impl Iterator<Item = Cell> {
        self.roots.iter().map(|root| self.splitting.with_ends(root.clone(), self.level))
    }

    /// The cells with their bounds, in increasing order of the bounds. The bound of a
    /// part is at most the bound of the `whole` cell.
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

    /// An upper bound of |P^∞ − P^k| on the cell: up to level k by the bound for the
    /// number of levels that remain until k, and from level k on by the values at its
    /// ends; at level k the lesser of both. The values may improve `best`.
    fn bound_over(&self, cell: &Cell, best: &mut Best) -> Fraction {
        let sizes = self.splitting.sizes(cell);
        let remaining = self.level.checked_sub(cell.level);
        let by_level = remaining.map(|j| self.bounds[j as usize].over(&sizes));
        let by_ends = self.splitting.distances(cell).map(|ends| {
            for (end, value) in (0..).zip(&ends) {
                let inside =
                    || self.range.is_none_or(|range| self.splitting.has_end(cell, end, range));
                if *value > Fraction::from(&best.value) && inside() {
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
