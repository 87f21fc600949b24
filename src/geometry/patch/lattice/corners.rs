//! The corners of the pieces on which two nets are linear, or linear in each coordinate.

use super::levels::{Affine, Place};
use crate::exact::Rational;
use crate::lattice::Between;
use std::collections::BTreeSet;

/// A line a·y = c.
type Line = (Place, Rational);

/// The places in the square low + [0, 1]² where lines meet, along which nets of several levels bend, and sides of the square. `maps` take y to the
/// coordinates of those levels.
pub(super) fn corners(low: &Place, maps: &[&Affine], between: Between) -> Vec<Place> {
    let one = Rational::one();
    let high = low.each_ref().map(|x| x + &one);
    let unit = |i: usize| [0, 1].map(|j| Rational::from(i64::from(i == j)));
    let mut lines: BTreeSet<Line> = [0, 1]
        .into_iter()
        .flat_map(|i| [low, &high].map(|end| (unit(i), end[i].clone())))
        .collect();
    let third = match between {
        Between::Triangles => Some([1, -1]),
        Between::OtherTriangles => Some([1, 1]),
        Between::Boxes => None,
    };
    for map in maps {
        for normal in [[1, 0], [0, 1]].into_iter().chain(third) {
            lines.extend(across(low, &high, map, normal));
        }
    }
    let lines: Vec<Line> = lines.into_iter().collect();
    let inside = |y: &Place| (0..2).all(|i| low[i] <= y[i] && y[i] <= high[i]);
    let mut found = BTreeSet::new();
    for (number, (a, c)) in lines.iter().enumerate() {
        for (b, d) in &lines[..number] {
            let determinant = &a[0] * &b[1] - &a[1] * &b[0];
            if determinant.is_zero() {
                continue;
            }
            let scale = determinant.recip();
            let x = (c * &b[1] - d * &a[1]) * &scale;
            let y = (d * &a[0] - c * &b[0]) * &scale;
            let place = [x, y];
            if inside(&place) {
                found.insert(place);
            }
        }
    }
    found.into_iter().collect()
}

/// The lines ν·(Ay + b) = k through the square, k an integer; the normal has 1 as its first number that is not 0.
fn across(low: &Place, high: &Place, map: &Affine, normal: [i64; 2]) -> Vec<Line> {
    let [first, second] = normal.map(Rational::from);
    let combined = |x: &Rational, y: &Rational| &first * x + &second * y;
    let [upper, lower] = &map.matrix;
    let a = [combined(&upper[0], &lower[0]), combined(&upper[1], &lower[1])];
    let b = combined(&map.constant[0], &map.constant[1]);
    let end = |pick: bool| -> Rational {
        let side = |i: usize| if (a[i].sign() < 0) == pick { &low[i] } else { &high[i] };
        &a[0] * side(0) + &a[1] * side(1) + &b
    };
    let (from, to) = (end(false), end(true));
    let (from, to) = if from <= to { (from, to) } else { (to, from) };
    let Some(lead) = a.iter().find(|x| !x.is_zero()).map(Rational::recip) else {
        return Vec::new();
    };
    let range = from.ceil().to_i64().zip(to.floor().to_i64());
    let (from, to) = range.unwrap_or((1, 0));
    let normal = a.each_ref().map(|x| x * &lead);
    (from..=to).map(|k| (normal.clone(), (Rational::from(k) - &b) * &lead)).collect()
}
