//! The numbers and vectors that the pieces of a surface are computed in.

use crate::exact::{RealCyclotomic, Scalar};
use crate::float::nearest;
use crate::mesh::Point;

/// A linear combination: weights of numbered points.
pub(super) type Row<W> = Vec<(u32, W)>;

/// A kind of number that weights are taken to.
pub(super) trait Number: Scalar {
    /// This weight, or the nearest number of this kind.
    fn of(weight: &RealCyclotomic) -> Self;
    /// Whether it is 0.
    fn vanishes(&self) -> bool;
}

impl Number for f64 {
    fn of(weight: &RealCyclotomic) -> f64 {
        nearest(weight)
    }
    fn vanishes(&self) -> bool {
        *self == 0.0
    }
}

impl Number for RealCyclotomic {
    fn of(weight: &RealCyclotomic) -> RealCyclotomic {
        weight.clone()
    }
    fn vanishes(&self) -> bool {
        self.sign() == 0
    }
}

/// What is combined: points, or functionals of points.
pub(super) trait Vector: Clone {
    /// The weights.
    type Weight: Number;
    /// Σ w·p over the row.
    fn combination(row: &Row<Self::Weight>, points: &[Self]) -> Self;
    /// self − other.
    fn minus(&self, other: &Self) -> Self;
    /// self + other·factor.
    fn plus_times(&self, other: &Self, factor: &Self::Weight) -> Self;
}

/// Points in f64.
impl Vector for Point<f64> {
    type Weight = f64;
    fn combination(row: &Row<f64>, points: &[Self]) -> Self {
        let mut sum = [0.0; 3];
        for (index, weight) in row {
            let point = &points[*index as usize];
            sum[0] += weight * point[0];
            sum[1] += weight * point[1];
            sum[2] += weight * point[2];
        }
        sum
    }
    fn minus(&self, other: &Self) -> Self {
        [self[0] - other[0], self[1] - other[1], self[2] - other[2]]
    }
    fn plus_times(&self, other: &Self, factor: &f64) -> Self {
        [0, 1, 2].map(|i| self[i] + factor * other[i])
    }
}

/// Exact points.
impl Vector for Point<RealCyclotomic> {
    type Weight = RealCyclotomic;
    fn combination(row: &Row<RealCyclotomic>, points: &[Self]) -> Self {
        let mut sum: Self = std::array::from_fn(|_| RealCyclotomic::zero());
        for (index, weight) in row {
            for (total, x) in sum.iter_mut().zip(&points[*index as usize]) {
                total.accumulate(&weight.times(x));
            }
        }
        sum
    }
    fn minus(&self, other: &Self) -> Self {
        std::array::from_fn(|i| Scalar::minus(&self[i], &other[i]))
    }
    fn plus_times(&self, other: &Self, factor: &RealCyclotomic) -> Self {
        std::array::from_fn(|i| self[i].plus(&other[i].times(factor)))
    }
}

/// Functionals in f64: the coefficients of all points of a neighbourhood.
impl Vector for Vec<f64> {
    type Weight = f64;
    fn combination(row: &Row<f64>, points: &[Self]) -> Self {
        let mut sum = vec![0.0; points.first().map_or(0, Vec::len)];
        for (index, weight) in row {
            for (total, x) in sum.iter_mut().zip(&points[*index as usize]) {
                *total += weight * x;
            }
        }
        sum
    }
    fn minus(&self, other: &Self) -> Self {
        self.iter().zip(other).map(|(x, y)| x - y).collect()
    }
    fn plus_times(&self, other: &Self, factor: &f64) -> Self {
        self.iter().zip(other).map(|(x, y)| x + factor * y).collect()
    }
}

/// All these combinations.
pub(super) fn combinations<'a, V: Vector>(
    rows: impl IntoIterator<Item = &'a Row<V::Weight>>,
    points: &[V],
) -> Vec<V>
where
    V::Weight: 'a,
{
    rows.into_iter().map(|row| V::combination(row, points)).collect()
}
