//! The numbers and vectors that the pieces of a surface are computed in.

use crate::exact::{RealCyclotomic, Scalar};
use crate::float::nearest;
use crate::mesh::Point;

/// A linear combination: weights of numbered points.
pub(crate) type Row<W> = Vec<(u32, W)>;

/// The number of a point in a row.
pub(crate) fn index(point: usize) -> u32 {
    u32::try_from(point).unwrap_or(u32::MAX)
}

/// A kind of number that weights are taken to.
pub(crate) trait Number: Scalar {
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
pub(crate) trait Vector: Clone {
    /// The weights.
    type Weight: Scalar;
    /// Σ w·p over the row.
    fn combination(row: &Row<Self::Weight>, points: &[Self]) -> Self;
    /// self − other.
    fn minus(&self, other: &Self) -> Self;
    /// self + other·factor.
    fn plus_times(&self, other: &Self, factor: &Self::Weight) -> Self;
}

/// Points.
impl<S: Scalar> Vector for Point<S> {
    type Weight = S;
    fn combination(row: &Row<S>, points: &[Self]) -> Self {
        let mut sum = [S::zero(), S::zero(), S::zero()];
        for (index, weight) in row {
            for (total, x) in sum.iter_mut().zip(&points[*index as usize]) {
                total.accumulate(&weight.times(x));
            }
        }
        sum
    }
    // Differences are taken in the innermost loops of other modules.
    #[inline]
    fn minus(&self, other: &Self) -> Self {
        [self[0].minus(&other[0]), self[1].minus(&other[1]), self[2].minus(&other[2])]
    }
    fn plus_times(&self, other: &Self, factor: &S) -> Self {
        [0, 1, 2].map(|i| self[i].plus(&other[i].times(factor)))
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
pub(crate) fn combinations<'a, V: Vector>(
    rows: impl IntoIterator<Item = &'a Row<V::Weight>>,
    points: &[V],
) -> Vec<V>
where
    V::Weight: 'a,
{
    rows.into_iter().map(|row| V::combination(row, points)).collect()
}

/// Their mean.
pub(crate) fn mean(points: &[Point<f64>]) -> Point<f64> {
    let count = f64::from(u32::try_from(points.len()).unwrap_or(u32::MAX));
    [0, 1, 2].map(|i| points.iter().map(|point| point[i]).sum::<f64>() / count)
}

/// |p − q|².
pub(crate) fn squared(p: &Point<f64>, q: &Point<f64>) -> f64 {
    let [x, y, z] = [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    x * x + y * y + z * z
}
