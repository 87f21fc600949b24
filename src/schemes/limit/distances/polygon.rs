//! Control polygons, stored as their differences.

use super::cell::Cell;
use crate::exact::{CommonDenominator, Integer, Rational};
use std::ops::Range;

/// A control polygon of numbers x_0, …, x_{m−1}. A polygon of points has one such polygon
/// for each coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ControlPolygon {
    /// Δ_i = x_{i+1} − x_i.
    differences: Vec<Rational>,
    closed: bool,
}

impl ControlPolygon {
    /// The closed polygon with x_{m+i} = x_i: the limit is a closed curve.
    #[must_use]
    pub fn closed(points: &[Rational]) -> ControlPolygon {
        let next = points.iter().cycle().skip(1);
        let differences = points.iter().zip(next).map(|(x, y)| y - x).collect();
        ControlPolygon { differences, closed: true }
    }

    /// The open polygon, without further points. All levels are compared with the limit between
    /// the parameters of [`determined`](crate::limit::determined).
    #[must_use]
    pub fn open(points: &[Rational]) -> ControlPolygon {
        let differences = points.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
        ControlPolygon { differences, closed: false }
    }

    /// max|Δ_i|; 0 for a single point.
    #[must_use]
    pub fn spread(&self) -> Rational {
        self.differences.iter().map(Rational::abs).max().unwrap_or_else(Rational::zero)
    }

    /// Δ_i, with i mod m for a closed polygon. An open one goes on in a line beyond its ends.
    pub(super) fn difference(&self, i: i64) -> Rational {
        let count = i64::try_from(self.differences.len()).unwrap_or(i64::MAX).max(1);
        let at = if self.closed { i.rem_euclid(count) } else { i.clamp(0, count - 1) };
        let difference = usize::try_from(at).ok().and_then(|at| self.differences.get(at));
        difference.cloned().unwrap_or_else(Rational::zero)
    }

    /// How many points there are.
    pub(super) fn count(&self) -> usize {
        self.differences.len() + usize::from(!self.closed)
    }

    /// Whether the last point is followed by the first.
    pub(super) fn is_closed(&self) -> bool {
        self.closed
    }

    /// The cells with these numbers i and the differences Δ_{i+first}, …, Δ_{i+first+size−1}; i mod m
    /// for a closed polygon.
    pub(super) fn cells(&self, numbers: Range<i64>, first: i64, size: usize) -> Vec<Cell> {
        let common = CommonDenominator::of(std::slice::from_ref(&self.differences));
        let column = common.numerators.concat();
        let count = i64::try_from(column.len()).unwrap_or(i64::MAX);
        let at = |i: i64| if self.closed { i.rem_euclid(count) } else { i.clamp(0, count - 1) };
        let row = |i: i64| vec![column[usize::try_from(at(i)).expect("not negative")].clone()];
        let cell = |i: i64| {
            let rows = (i + first..).take(size).map(row).collect();
            let index = if self.closed { i.rem_euclid(count) } else { i };
            Cell::root(Integer::from(index), rows, common.denominator.clone())
        };
        numbers.map(cell).collect()
    }
}

/// The control polygons over which the supremum of the distance is taken.
pub(crate) struct Polygons<'a> {
    /// The cells of level 0.
    pub(super) roots: Vec<Cell>,
    /// For an open polygon the parameters between which it determines the limit.
    pub(super) range: Option<[Rational; 2]>,
    /// The polygon, if it is a single one.
    pub(super) only: Option<&'a ControlPolygon>,
}
