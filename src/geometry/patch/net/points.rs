//! Grids of points, and combinations of their rows and columns.

use super::super::number::{Row, Vector as _};
use crate::exact::Scalar;
use crate::mesh::{Point, combination};

/// Combinations of the rows of a grid.
pub(super) fn across<'a, S: Scalar + 'a>(
    rows: impl IntoIterator<Item = &'a Row<S>>,
    points: &[Point<S>],
    columns: usize,
) -> Vec<Point<S>> {
    let row = |row: &'a Row<S>| {
        let column =
            move |j: usize| row.iter().map(move |(i, w)| (w, &points[j + *i as usize * columns]));
        (0..columns).map(move |j| combination(column(j)))
    };
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
        all.extend(rows.iter().map(|row| Point::combination(row, &points[first..])));
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
