//! The ring between two levels as polynomials.

use super::ball::Ball;
use super::bernstein::{Form, on_triangle};
use super::lattice::{Part, Place};
use super::net::{Net, Point};
use crate::numbers::linear;
use crate::numbers::{Q, int};
use crate::text::{Checked, Stop};
use num_traits::Zero;
use std::collections::BTreeMap;

/// A piece of the ring.
pub struct Piece {
    /// Where its u = v = 0 is, on the lattice of the refined points.
    pub corner: Place,
    /// 1, or −1 where u and v run backwards.
    pub direction: i32,
    /// p and q.
    pub coordinates: [Form; 2],
}

/// The Bézier points of a polynomial of a uniform B-spline, by its control points.
const QUADRATIC: [&[i64]; 3] = [&[1, 1, 0], &[0, 2, 0], &[0, 1, 1]];
const CUBIC: [&[i64]; 4] = [&[1, 4, 1, 0], &[0, 4, 2, 0], &[0, 2, 4, 0], &[0, 1, 4, 1]];

/// The pieces of sector 0, by the refined points.
pub fn pieces(fine: &Net) -> Checked<Vec<Piece>> {
    let (start, end) = (fine.start, 2 * fine.start);
    let mut corners: Vec<(Place, i32)> = Vec::new();
    if fine.part == Part::BoxSpline {
        for sum in start..end {
            corners.extend((0..=sum).map(|b| ((sum - b, b), 1)));
        }
        for sum in start + 1..=end {
            corners.extend((1..sum).map(|b| ((sum - b, b), -1)));
        }
    } else {
        for side in start..end {
            corners.extend((0..=side).map(|b| ((side, b), 1)));
            corners.extend((0..side).rev().map(|a| ((a, side), 1)));
        }
    }
    let piece = |(corner, direction): (Place, i32)| -> Checked<Piece> {
        let form = |which: usize| match fine.part {
            Part::BoxSpline => triangle(fine, corner, direction, which),
            Part::Bicubic => square(fine, corner, which, &CUBIC),
            Part::Biquadratic => square(fine, corner, which, &QUADRATIC),
        };
        Ok(Piece { corner, direction, coordinates: [form(0)?, form(1)?] })
    };
    corners.into_iter().map(piece).collect()
}

/// Σ w_i x_i / Σ w_i.
fn mean(weights: &[i64], values: &[Ball]) -> Ball {
    let whole = int(weights.iter().sum());
    Ball::combined(values.iter().zip(weights.iter().map(|w| int(*w) / &whole)))
}

fn square(fine: &Net, (a, b): Place, which: usize, weights: &[&[i64]]) -> Checked<Form> {
    let steps = || (-1..).take(weights.len());
    let value = |u: i32, v: i32| fine.at((a + u, b + v)).map(|point: Point| point[which].clone());
    let mut rows: Vec<Vec<Ball>> = Vec::new();
    for u in steps() {
        rows.push(steps().map(|v| value(u, v)).collect::<Checked<Vec<Ball>>>()?);
    }
    // Along v, and then along u.
    for _ in 0..2 {
        let along = |row: &Vec<Ball>| weights.iter().map(|w| mean(w, row)).collect::<Vec<Ball>>();
        let rows_along: Vec<Vec<Ball>> = rows.iter().map(along).collect();
        rows = Form { triangle: false, rows: rows_along }.exchanged().rows;
    }
    Ok(Form { triangle: false, rows })
}

/// The box spline at the place (a, b)/4, as weights of the control points: it is 1/2 at its middle, and 1/12 at the six
/// places next to it.
fn value_at((a, b): Place) -> BTreeMap<Place, Q> {
    let around = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
    let mut weights: BTreeMap<Place, Q> = BTreeMap::from([((a, b), int(1) / int(2))]);
    weights.extend(around.map(|(u, v)| ((a + u, b + v), int(1) / int(12))));
    for _ in 0..2 {
        let mut coarse: BTreeMap<Place, Q> = BTreeMap::new();
        for (place, weight) in weights {
            for (old, share) in Part::BoxSpline.rule(place) {
                *coarse.entry(old).or_insert_with(Q::zero) += share * &weight;
            }
        }
        weights = coarse;
    }
    weights
}

/// The polynomial of degree 4 on a triangle that has the values of the surface at the places (i, j)/4.
fn triangle(fine: &Net, (a, b): Place, direction: i32, which: usize) -> Checked<Form> {
    let places: Vec<(usize, usize)> =
        (0..5).flat_map(|i| (0..5 - i).map(move |j| (i, j))).collect();
    let small = |i: usize| i32::try_from(i).unwrap_or(0);
    let quarter = |i: usize| int(i64::from(small(i))) / int(4);
    let mut values = Vec::new();
    for &(i, j) in &places {
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        for ((u, v), weight) in value_at((small(i), small(j))) {
            let [p, q] = fine.at((a + direction * u, b + direction * v))?;
            points.push(if which == 0 { p } else { q });
            weights.push(weight);
        }
        values.push(Ball::combined(points.iter().zip(weights)));
    }
    // One coefficient after the other is a combination of the values.
    let mut rows: Vec<Vec<Ball>> = vec![Vec::new(); 5];
    for (at, &(k, _)) in places.iter().enumerate() {
        // Σ w_p basis_l(p) is 1 for the coefficient at hand, and 0 for the others.
        let equation = |(other, &of): (usize, &(usize, usize))| -> Vec<Q> {
            let right = int(i64::from(other == at));
            let basis = |&(i, j): &(usize, usize)| on_triangle(4, of, &quarter(i), &quarter(j));
            places.iter().map(basis).chain([right]).collect()
        };
        let equations = places.iter().enumerate().map(equation).collect();
        let weights = linear::solve(equations).ok_or(Stop::Undefined("an interpolation"))?;
        rows[k].push(Ball::combined(values.iter().zip(weights)));
    }
    Ok(Form { triangle: true, rows })
}
