//! Control data in certificates.

use super::block::{Block, closed};
use crate::exact::RealCyclotomic;
use crate::limit::ExtremalPolygon;
use std::fmt::Display;

/// Numbers with blanks between them.
pub(super) fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| closed(&item)).collect::<Vec<String>>().join(" ")
}

/// The line of a polygon.
pub(super) fn polygon(block: &mut Block, polygon: &ExtremalPolygon) {
    points(block, polygon.first, &polygon.points);
}

fn points(block: &mut Block, first: i64, points: &[i64]) {
    block.line(format!("polygon {first} {}", list(points)));
}

/// The lines of a net: of two polygons, if its points are sums a_i + b_j.
///
/// A net that changes along the one index only is looked at for a difference, which
/// may be another one's along the other index: `flat` polygons become 0, 1.
pub(super) fn net(block: &mut Block, first: [i64; 2], rows: &[Vec<i64>], difference: bool) {
    let a: Vec<i64> = rows.iter().map(|row| row[0]).collect();
    let b: Vec<i64> = rows[0].iter().map(|x| x - rows[0][0]).collect();
    let is_sum = |(row, a): (&Vec<i64>, &i64)| row.iter().zip(&b).all(|(x, b)| *x == a + b);
    if rows.iter().zip(&a).all(is_sum) {
        for (first, polygon) in first.into_iter().zip([a, b]) {
            let flat = difference && polygon.windows(2).all(|pair| pair[0] == pair[1]);
            points(block, first, if flat { &[0, 1] } else { &polygon });
        }
        return;
    }
    block.line(format!("net {} {}", first[0], first[1]));
    for row in rows {
        block.line(format!("row {}", list(row)));
    }
}

/// The lines of a ring, with the weights of its limit where these are needed.
pub(super) fn ring(block: &mut Block, points: &[i64], weights: &[RealCyclotomic]) {
    block.line(format!("ring {}", list(points)));
    if !weights.is_empty() {
        block.line(format!("weights {}", list(weights)));
    }
}
