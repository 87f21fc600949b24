//! Points of space, as combinations of points.

use crate::exact::Scalar;

/// The coordinates x, y and z.
pub type Point<S> = [S; 3];

/// The origin.
pub(super) fn origin<S: Scalar>() -> Point<S> {
    std::array::from_fn(|_| S::zero())
}

/// The sum of these points.
pub(super) fn sum<'a, S: Scalar + 'a>(points: impl IntoIterator<Item = &'a Point<S>>) -> Point<S> {
    points.into_iter().fold(origin(), |mut total, point| {
        for (total, x) in total.iter_mut().zip(point) {
            total.accumulate(x);
        }
        total
    })
}

/// Σ c·p over these pairs.
pub(crate) fn combination<'a, S: Scalar + 'a>(
    terms: impl IntoIterator<Item = (&'a S, &'a Point<S>)>,
) -> Point<S> {
    terms.into_iter().fold(origin(), |mut total, (factor, point)| {
        for (total, x) in total.iter_mut().zip(point) {
            total.accumulate(&factor.times(x));
        }
        total
    })
}

/// p − q.
pub(super) fn difference<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Point<S> {
    std::array::from_fn(|i| p[i].minus(&q[i]))
}

/// p × q.
pub(super) fn cross<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Point<S> {
    let minor = |i: usize, j: usize| p[i].times(&q[j]).minus(&p[j].times(&q[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
