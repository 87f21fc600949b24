//! Grids of points, and combinations of their rows and columns.

use super::rules::Row;
use crate::exact::Scalar;
use crate::mesh::Point;

/// Σ w·p over the row, of the points that are `step` apart from `first` on.
fn combination<S: Scalar>(
    row: &Row<S>,
    points: &[Point<S>],
    first: usize,
    step: usize,
) -> Point<S> {
    let mut sum = [S::zero(), S::zero(), S::zero()];
    for (at, weight) in row {
        let point = &points[first + *at as usize * step];
        for (sum, x) in sum.iter_mut().zip(point) {
            sum.accumulate(&weight.times(x));
        }
    }
    sum
}

/// Combinations of the rows of a grid.
pub(super) fn across<'a, S: Scalar + 'a>(
    rows: impl IntoIterator<Item = &'a Row<S>>,
    points: &[Point<S>],
    columns: usize,
) -> Vec<Point<S>> {
    let row = |row: &'a Row<S>| (0..columns).map(move |j| combination(row, points, j, columns));
    rows.into_iter().flat_map(row).collect()
}

/// Combinations along the rows of a grid.
pub(super) fn along<S: Scalar>(
    rows: &[Row<S>],
    points: &[Point<S>],
    columns: usize,
) -> Vec<Point<S>> {
    let mut all = Vec::with_capacity(points.len() / columns * rows.len());
    for first in (0..points.len()).step_by(columns) {
        all.extend(rows.iter().map(|row| combination(row, points, first, 1)));
    }
    all
}

/// Σ_{i,j} u_i v_j p_{i,j} for all pairs of rows u and v, row by row.
pub(super) fn tensor<S: Scalar>(
    [u, v]: [&[Row<S>]; 2],
    points: &[Point<S>],
    columns: usize,
) -> Vec<Point<S>> {
    along(v, &across(u, points, columns), columns)
}

/// p − q.
pub(super) fn minus<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Point<S> {
    [p[0].minus(&q[0]), p[1].minus(&q[1]), p[2].minus(&q[2])]
}
