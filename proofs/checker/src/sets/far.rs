//! Whether a point of one set is far from all of the other (THEOREMS.md, 167).

use super::near::{Set, cell, is_inside, parts, roots};
use super::net::{Cell, Net, TOLERANCE};
use super::point::{Point, length, square};
use super::ratio::Ratio;
use crate::numbers::Meter;
use crate::text::{DepthChecked as Checked, DepthReason, require};

/// The highest level of cells.
const DEEPEST: u32 = 30;

/// How many levels beyond that of the polygon a point of the limit is taken from, at most.
const MORE_DIGITS: u32 = 14;

/// Checks that a level is not enough: its point, or that of the limit, is farther than the tolerance from the other set.
pub fn check(net: &mut Net, level: u32, set: Set, at: &[Ratio], meter: &Meter) -> Checked<()> {
    match set {
        Set::Polygon => {
            let point = net.at(level, at)?;
            let off = net.slack(level)?;
            require(is_far(net, level, Set::Limit, &point, off, meter)?, DepthReason::NotFar)
        }
        Set::Limit => {
            // The deepest level that the digits of the parameters allow.
            for more in (2..=MORE_DIGITS).step_by(4) {
                let fine = level + more;
                let point = net.at(fine, at)?;
                let own = cell(net, at, fine)?;
                let off = net.slack(fine)? + net.radius(fine, own)?;
                if is_far(net, level, Set::Polygon, &point, off, meter)? {
                    return Ok(());
                }
            }
            Err(DepthReason::NotFar.into())
        }
    }
}

/// Whether a point, which is known up to `off`, is farther than the tolerance from a set: false where it is near, or that
/// is not seen.
fn is_far(
    net: &mut Net,
    level: u32,
    set: Set,
    point: &Point,
    off: i128,
    meter: &Meter,
) -> Checked<bool> {
    let mut stack: Vec<(u32, Cell)> = roots(net).into_iter().map(|cell| (0, cell)).collect();
    while let Some((own, cell)) = stack.pop() {
        meter.spend(8)?;
        if !is_inside(net, own, cell)? {
            continue;
        }
        let exact = set == Set::Polygon && own >= level;
        let (hull, radius) = if exact {
            (net.hull(own, cell, level)?, net.slack(level)?)
        } else {
            (
                net.hull(own, cell, own)?,
                net.slack(own)? + net.slack(level)? + net.radius(own, cell)?,
            )
        };
        let enough = TOLERANCE + off + radius;
        if is_beyond(&hull, point, enough) {
            continue;
        }
        // Of a piece that is small against the tolerance, and near, no part is far.
        let wide = hull.iter().map(|x| square(x, &hull[0])).max().unwrap_or(0);
        if own >= DEEPEST || own > level && length(wide) + radius < TOLERANCE >> 16 {
            return Ok(false);
        }
        stack.extend(parts(net, cell).into_iter().map(|cell| (own + 1, cell)));
    }
    Ok(true)
}

/// Whether all points of the hull are farther than this from a point: by a plane before them.
fn is_beyond(hull: &[Point], point: &Point, enough: i128) -> bool {
    // No two points are so far apart; below it, products have room.
    if enough >= 1 << 62 {
        return false;
    }
    let count = i128::try_from(hull.len()).unwrap_or(1);
    let mean: Vec<i128> =
        (0..point.len()).map(|c| hull.iter().map(|x| x[c]).sum::<i128>() / count).collect();
    let nearest = hull.iter().min_by_key(|x| square(x, point));
    let before = |to: &[i128]| {
        // Less digits, so that products have room: any direction will do.
        let way: Vec<i128> = to.iter().zip(&**point).map(|(x, y)| x - y).collect();
        let greatest = way.iter().map(|x| x.abs()).max().unwrap_or(0);
        let more = (128 - greatest.leading_zeros()).saturating_sub(40);
        let way: Vec<i128> = way.iter().map(|x| x >> more).collect();
        let long = length(way.iter().map(|x| x * x).sum());
        let height = |x: &Point| -> i128 {
            x.iter().zip(&**point).zip(&way).map(|((x, y), way)| (x - y) * way).sum()
        };
        let least = hull.iter().map(height).min().unwrap_or(0);
        long > 0 && least > enough * long
    };
    before(&mean) || nearest.is_some_and(|nearest| before(nearest))
}
