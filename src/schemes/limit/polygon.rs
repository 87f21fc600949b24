//! Control polygons, stored as their differences.

use super::cell::Cell;
use super::error::LimitError;
use crate::exact::{CommonDenominator, Integer, Rational};

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

    /// The open polygon, without further points. The limit is taken between those x_i and
    /// x_{i+1} between which the given points determine it.
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

    /// Δ_i, with i mod m for a closed polygon; 0 where there is no such difference.
    pub(super) fn difference(&self, i: i64) -> Rational {
        let count = i64::try_from(self.differences.len()).unwrap_or(i64::MAX).max(1);
        let at = if self.closed { i.rem_euclid(count) } else { i };
        let difference = usize::try_from(at).ok().and_then(|at| self.differences.get(at));
        difference.cloned().unwrap_or_else(Rational::zero)
    }

    /// The cells i for which the differences Δ_{i+first}, …, Δ_{i+first+size−1} exist, where
    /// first ≤ 0.
    pub(super) fn cells(&self, first: i64, size: usize) -> Result<Vec<Cell>, LimitError> {
        let common = CommonDenominator::of(std::slice::from_ref(&self.differences));
        let column: Vec<Vec<Integer>> =
            common.numerators.concat().into_iter().map(|value| vec![value]).collect();
        let count = column.len();
        let starts = if self.closed { count } else { (count + 1).saturating_sub(size) };
        if starts == 0 {
            return Err(LimitError::TooFew { needed: if self.closed { 1 } else { size + 1 } });
        }
        let back = usize::try_from(-first).expect("the window holds Δ_0");
        let cell = |start: usize| {
            let rows = (start..start + size).map(|i| column[i % count].clone()).collect();
            let index = if self.closed { (start + back) % count } else { start + back };
            Cell::root(Integer::from(index), rows, common.denominator.clone())
        };
        Ok((0..starts).map(cell).collect())
    }
}
