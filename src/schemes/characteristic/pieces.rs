//! The characteristic ring in Bézier form.

use super::bernstein::Form;
use super::net::{Lattice, Net, ratio};
use crate::exact::Scalar;

/// Coordinates p and q of a piece, as functions of its (u, v), and its first corner on the lattice of the
/// refined points.
pub(super) struct Piece<R> {
    pub(super) corner: (i32, i32),
    /// 1, or −1 for the middle triangle, whose u and v run backwards.
    pub(super) direction: i32,
    pub(super) coordinates: [Form<R>; 2],
}

/// The Bézier points of a uniform quadratic B-spline on an interval, times 2: row i has the weights of the three points.
pub const QUADRATIC_BEZIER: [[i64; 3]; 3] = [[1, 1, 0], [0, 2, 0], [0, 1, 1]];

/// Those of a cubic one, times 6.
pub const CUBIC_BEZIER: [[i64; 4]; 4] = [[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]];

/// The control points of a triangle of the quartic box spline with the corners (0, 0), (1, 0), (0, 1).
pub const BOX_SPLINE_POINTS: [(i32, i32); 12] = [
    (-1, 0),
    (-1, 1),
    (-1, 2),
    (0, -1),
    (0, 0),
    (0, 1),
    (0, 2),
    (1, -1),
    (1, 0),
    (1, 1),
    (2, -1),
    (2, 0),
];

/// The Bézier points (i, j), i + j ≤ 4, of that triangle in lexicographic order, times 24: each row has the weights of these
/// points. The exponent i belongs to (1, 0), and j to (0, 1).
pub const BOX_SPLINE_BEZIER: [[i64; 12]; 15] = [
    [2, 2, 0, 2, 12, 2, 0, 2, 2, 0, 0, 0],
    [1, 3, 0, 0, 12, 4, 0, 1, 3, 0, 0, 0],
    [0, 4, 0, 0, 8, 8, 0, 0, 4, 0, 0, 0],
    [0, 3, 1, 0, 4, 12, 0, 0, 3, 1, 0, 0],
    [0, 2, 2, 0, 2, 12, 2, 0, 2, 2, 0, 0],
    [0, 1, 0, 1, 12, 3, 0, 3, 4, 0, 0, 0],
    [0, 1, 0, 0, 10, 6, 0, 1, 6, 0, 0, 0],
    [0, 1, 0, 0, 6, 10, 0, 0, 6, 1, 0, 0],
    [0, 1, 0, 0, 3, 12, 1, 0, 4, 3, 0, 0],
    [0, 0, 0, 0, 8, 4, 0, 4, 8, 0, 0, 0],
    [0, 0, 0, 0, 6, 6, 0, 1, 10, 1, 0, 0],
    [0, 0, 0, 0, 4, 8, 0, 0, 8, 4, 0, 0],
    [0, 0, 0, 0, 4, 3, 0, 3, 12, 1, 1, 0],
    [0, 0, 0, 0, 3, 4, 0, 1, 12, 3, 0, 1],
    [0, 0, 0, 0, 2, 2, 0, 2, 12, 2, 2, 2],
];

/// The pieces of sector 0 of the ring between two levels, from the refined points: three, or twelve where it begins at 2.
pub(super) fn pieces<R: Scalar>(fine: &Net<R>) -> Vec<Piece<R>> {
    let layers = fine.start..2 * fine.start;
    let corners: Vec<((i32, i32), i32)> = match fine.lattice {
        Lattice::Triangle => {
            // Upright ones by their distance, and then those between them.
            let upright = layers.clone().flat_map(|a| (0..=a).map(move |b| ((a - b, b), 1)));
            let turned = layers.flat_map(|a| (1..=a).map(move |b| ((a + 1 - b, b), -1)));
            upright.chain(turned).collect()
        }
        _ => layers
            .flat_map(|a| (0..=a).map(move |b| (a, b)).chain((0..a).rev().map(move |b| (b, a))))
            .map(|corner| (corner, 1))
            .collect(),
    };
    let piece = |(corner, direction): ((i32, i32), i32)| {
        let coordinates = [0, 1].map(|which| coordinate(fine, corner, direction, which));
        Piece { corner, direction, coordinates }
    };
    corners.into_iter().map(piece).collect()
}

fn coordinate<R: Scalar>(
    fine: &Net<R>,
    (a, b): (i32, i32),
    direction: i32,
    which: usize,
) -> Form<R> {
    let at = |u: i32, v: i32| fine.at((a + direction * u, b + direction * v))[which].clone();
    let combined = |weights: &[i64], whole: i64, values: &[R]| {
        let terms = weights.iter().zip(values).filter(|(weight, _)| **weight != 0);
        terms.fold(R::zero(), |sum, (weight, x)| sum.plus(&x.times(&ratio(*weight, whole))))
    };
    let tensor = |rows: Vec<&[i64]>, whole: i64| {
        let size = rows.len();
        let steps = || (-1..).take(size);
        let along: Vec<Vec<R>> = steps()
            .map(|u| {
                let values: Vec<R> = steps().map(|v| at(u, v)).collect();
                rows.iter().map(|row| combined(row, whole, &values)).collect()
            })
            .collect();
        let column = |j: usize| along.iter().map(|row| row[j].clone()).collect::<Vec<R>>();
        let columns: Vec<Vec<R>> = (0..size).map(column).collect();
        let row = |weights: &&[i64]| columns.iter().map(|x| combined(weights, whole, x)).collect();
        Form {
            triangle: false,
            degrees: (size - 1, size - 1),
            rows: rows.iter().map(row).collect(),
        }
    };
    match fine.lattice {
        Lattice::Primal => tensor(CUBIC_BEZIER.iter().map(|row| &row[..]).collect(), 6),
        Lattice::Dual => tensor(QUADRATIC_BEZIER.iter().map(|row| &row[..]).collect(), 2),
        Lattice::Triangle => {
            let values: Vec<R> = BOX_SPLINE_POINTS.iter().map(|&(u, v)| at(u, v)).collect();
            let mut all = BOX_SPLINE_BEZIER.iter().map(|weights| combined(weights, 24, &values));
            let rows = (0..5).map(|i| all.by_ref().take(5 - i).collect()).collect();
            Form { triangle: true, degrees: (4, 4), rows }
        }
    }
}
