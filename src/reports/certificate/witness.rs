//! Control data in certificates.

use super::block::{Block, closed};
use crate::audit::{Attained, Control, Place, Unshiftable};
use crate::exact::RealCyclotomic;
use crate::limit::{ExtremalPolygon, Overshoot, ProofOfGreatest};
use std::fmt::Display;

/// Numbers with blanks between them.
pub(super) fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| closed(&item)).collect::<Vec<String>>().join(" ")
}

/// The line of a polygon.
fn polygon(block: &mut Block, polygon: &ExtremalPolygon) {
    points(block, polygon.first, &polygon.points);
}

fn points(block: &mut Block, first: i64, points: &[i64]) {
    block.line(format!("polygon {first} {}", list(points)));
}

/// Writes the lines of a net, as two polygons if its points are sums a_i + b_j.
///
/// For a `difference` along one index, the net may be constant along the other. The constant
/// polygon is then written as 0, 1: both have the spread 1, and the difference stays the same.
fn net(block: &mut Block, first: [i64; 2], rows: &[Vec<i64>], difference: bool) {
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
fn ring(block: &mut Block, points: &[i64], weights: &[RealCyclotomic]) {
    block.line(format!("ring {}", list(points)));
    if !weights.is_empty() {
        block.line(format!("weights {}", list(weights)));
    }
}

/// Writes the lines of control data and of the place where they attain a value; of a ring, with the
/// weights of its limit where these are needed.
///
/// If the distance vanishes for all data, the data found are 0 everywhere and have no spread. They
/// are replaced by data that have one.
pub(super) fn attained(block: &mut Block, found: &Attained, weights: &[RealCyclotomic]) {
    let flat = |points: &[i64]| points.iter().all(|x| *x == 0);
    match &found.control {
        Control::Polygon(points) => {
            let mut points = points.clone();
            if flat(&points.points) {
                points.points.push(1);
            }
            polygon(block, &points);
        }
        Control::Net { first, rows } => {
            let mut rows = rows.clone();
            if flat(&rows.concat()) {
                for row in &mut rows {
                    row.push(1);
                }
            }
            net(block, *first, &rows, matches!(found.place, Place::Along(..)));
        }
        Control::Points(points) => {
            let mut heights: Vec<i64> = points.iter().map(|(_, height)| *height).collect();
            if flat(&heights) {
                heights[0] = 1;
            }
            ring(block, &heights, weights);
        }
    }
    let place = match &found.place {
        Place::Parameter(t) => t.to_string(),
        Place::Parameters([s, t]) => format!("{s} {t}"),
        Place::Point(i) | Place::Difference(i) => i.to_string(),
        Place::Points([i, j]) => format!("{i} {j}"),
        Place::Along([i, j], axis) => format!("{i} {j} {}", axis + 1),
        Place::Named(name) => name.clone(),
        Place::Edge([a, b]) => format!("{a} {b}"),
    };
    block.line(format!("at {place}"));
}

/// The lines of data that exceed a bound in every shift, from the line `level` on.
pub(super) fn unshiftable(block: &mut Block, data: &Unshiftable) {
    let Unshiftable { level, overshoot, bound, .. } = data;
    let Overshoot { polygons, later, shown, .. } = overshoot;
    block.line(format!("level {level}"));
    for points in polygons {
        polygon(block, points);
    }
    match shown {
        ProofOfGreatest::Points => {}
        ProofOfGreatest::AtMost(levels) => {
            block.line(format!("limit at-most {later} {}", list(levels)));
        }
        ProofOfGreatest::AtLeast(places) => {
            block.line(format!("limit at-least {later} {}", list(places)));
        }
    }
    block.line(format!("sides {} {}", overshoot.gap(), closed(bound)));
}
