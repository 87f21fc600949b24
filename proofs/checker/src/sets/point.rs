//! Points in units, and their distances.

use num_integer::Roots as _;
use std::rc::Rc;

/// A point in units.
pub type Point = Rc<[i128]>;

/// |x|, rounded upwards.
pub fn length(square: i128) -> i128 {
    let root = square.sqrt();
    if root * root < square { root + 1 } else { root }
}

pub fn square(x: &[i128], y: &[i128]) -> i128 {
    x.iter().zip(y).map(|(x, y)| (x - y) * (x - y)).sum()
}

/// max |Δ_i − b|, with b in the middle of the differences.
pub fn bend(points: &[Point]) -> i128 {
    let differences: Vec<Vec<i128>> = points
        .windows(2)
        .map(|pair| pair[0].iter().zip(&*pair[1]).map(|(x, y)| y - x).collect())
        .collect();
    let dimensions = points.first().map_or(0, |point| point.len());
    let middle: Vec<i128> = (0..dimensions)
        .map(|c| {
            let of = || differences.iter().map(|difference| difference[c]);
            i128::midpoint(of().min().unwrap_or(0), of().max().unwrap_or(0))
        })
        .collect();
    length(differences.iter().map(|difference| square(difference, &middle)).max().unwrap_or(0))
}
