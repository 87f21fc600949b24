//! The points that one piece of a curve depends on, and what an open polygon determines.

use super::error::{LimitError, MAX_WINDOW};
use super::functional::rule_at;
use crate::exact::Rational;
use crate::scheme::Mask;
use std::ops::Range;

/// The points x_{i+first}, …, x_{i+last}, which the curve and the polygons of all levels, with x^k_j at
/// (j + s)/n^k, depend on over the parameters from i to i + 1.
///
/// It holds the points of the polygon there, and with the points of the next level in the windows
/// of the n parts of a cell all points that these are made of (`proofs/THEOREMS.md`, 98).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The first index for i = 0.
    pub first: i64,
    /// The last one.
    pub last: i64,
}

impl Window {
    /// That of a mask and a shift s.
    ///
    /// # Errors
    /// When there are more than [`MAX_WINDOW`] points.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Window;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = parse_scheme("chaikin")?;
    /// let window = Window::of(chaikin.masks()[0], &Rational::new(-1, 2))?;
    /// assert_eq!(window, Window { first: 0, last: 2 });
    /// // Three points determine a parabola.
    /// assert_eq!(window.determined(3)?, 0..1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(mask: &Mask, shift: &Rational) -> Result<Window, LimitError> {
        let integer = |x: Rational| x.floor().to_i64().ok_or(LimitError::Offset(mask.offset()));
        let mut window =
            Window { first: integer(-shift)?, last: -integer(shift - Rational::one())? };
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
    #[must_use]
    pub fn size(self) -> usize {
        usize::try_from(self.last - self.first + 1).unwrap_or(usize::MAX)
    }

    /// How many cells have a window inside `count` points.
    #[must_use]
    pub fn cells(self, count: usize, closed: bool) -> usize {
        if closed { count } else { (count + 1).saturating_sub(self.size()) }
    }

    /// The index of the first cell.
    #[must_use]
    pub fn first_cell(self, closed: bool) -> i64 {
        if closed { 0 } else { -self.first }
    }

    /// The parameters a and b between which `count` points of an open polygon, from x_0 on, determine P^∞ and all P^k:
    /// the cells from i to i + 1 of i = a, …, b − 1.
    ///
    /// # Errors
    /// When the points determine none.
    pub fn determined(self, count: usize) -> Result<Range<i64>, LimitError> {
        let first = self.first_cell(false);
        match i64::try_from(self.cells(count, false)) {
            Ok(cells) if cells > 0 => Ok(first..first.saturating_add(cells)),
            _ => Err(LimitError::TooFew { needed: self.size() }),
        }
    }
}
