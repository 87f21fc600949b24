//! The points that one piece of a curve depends on.

use crate::exact::Rational;
use crate::limit::{LimitError, MAX_WINDOW, natural_shift};
use crate::scheme::{Mask, Rules};

/// The points x_{i+first}, …, x_{i+last}, which the curve and the polygons of all levels depend on
/// over the cell from i to i + 1, in the natural parameter.
///
/// It holds the points of the polygon there, and with the points of the next level in the windows
/// of the n parts of a cell all points that these are made of (`proofs/THEOREMS.md`, 98).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Window {
    pub(crate) first: i64,
    pub(crate) last: i64,
}

impl Window {
    /// That of a mask.
    pub(crate) fn of(mask: &Mask) -> Result<Window, LimitError> {
        let shift = natural_shift(mask).shift;
        let integer = |x: Rational| x.floor().to_i64().ok_or(LimitError::Offset(mask.offset()));
        let mut window =
            Window { first: integer(-&shift)?, last: -integer(&shift - Rational::one())? };
        let arity = i64::try_from(mask.arity()).unwrap_or(i64::MAX);
        loop {
            if window.size() > MAX_WINDOW {
                return Err(LimitError::Window(window.size()));
            }
            let mut wider = window;
            for row in window.first..window.last + arity {
                for (column, entry) in rule_at(mask.rules(), row) {
                    if !entry.is_zero() {
                        wider.first = wider.first.min(column);
                        wider.last = wider.last.max(column);
                    }
                }
            }
            if wider == window {
                return Ok(window);
            }
            window = wider;
        }
    }

    /// How many points there are.
    pub(crate) fn size(self) -> usize {
        usize::try_from(self.last - self.first + 1).unwrap_or(usize::MAX)
    }

    /// How many cells have a window inside `count` points.
    pub(crate) fn cells(self, count: usize, closed: bool) -> usize {
        if closed { count } else { (count + 1).saturating_sub(self.size()) }
    }

    /// The index of the first cell.
    pub(crate) fn first_cell(self, closed: bool) -> i64 {
        if closed { 0 } else { -self.first }
    }
}

/// The pairs (m, r) of y_i = Σ r x_m.
pub(super) fn rule_at(rules: &Rules, i: i64) -> impl Iterator<Item = (i64, &Rational)> {
    let arity = i64::try_from(rules.arity()).unwrap_or(i64::MAX);
    let rule = usize::try_from(i.rem_euclid(arity)).unwrap_or(0);
    (i.div_euclid(arity) + rules.offset()..).zip(&rules.rows()[rule])
}
