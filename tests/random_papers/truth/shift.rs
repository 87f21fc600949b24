//! Data that refute a bound in every shift, recomputed.

use crate::random_papers::draft::{Bound, Shape};
use crate::random_papers::naive::{Curve, Net, Q};
use crate::random_papers::program::Block;
use num_traits::{Signed, Zero};

/// The most points of a level.
const MAX_POINTS: i64 = 5_000;

/// The polygons, each with the index of its first point in front.
pub fn polygons(block: &Block) -> Option<Vec<Vec<i64>>> {
    let lines = block.lines();
    let polygons = lines.iter().filter_map(|line| line.strip_prefix("polygon "));
    polygons.map(|text| text.split_whitespace().map(|word| word.parse().ok()).collect()).collect()
}

/// The greatest point of a level; `None` where there are too many.
fn greatest(curve: &Curve, polygon: &[i64], level: u32) -> Option<Q> {
    let width = i64::try_from(curve.rules[0].len()).ok()? + curve.offset.abs();
    let scale = curve.arity().checked_pow(level)?;
    let (first, last) = (polygon[0] - 3 * width, polygon[0] + i64::try_from(polygon.len()).ok()?);
    let (from, to) = (first.checked_mul(scale)?, (last + 3 * width).checked_mul(scale)?);
    let value = |i| Curve::of(&curve.row(level, i), polygon[0], &polygon[1..]);
    (to - from <= MAX_POINTS).then(|| (from..=to).map(value).max())?
}

/// Whether the greatest values of the data are as far apart as the block says, as far as a later
/// level tells; and the bound of the limit is one.
pub fn apart(
    bound: &Bound,
    shape: &Shape,
    level: u32,
    polygons: &[Vec<i64>],
    block: &Block,
    left: &Q,
) -> Result<(), String> {
    let curves: Vec<Curve> = match shape {
        Shape::Curve(curve) => vec![curve.with_offset(bound.offset)],
        Shape::Net(Net(pair)) => pair.iter().map(|curve| curve.with_offset(bound.offset)).collect(),
        Shape::LocalRules(..) => return Err("rings have no shifts: ".to_owned()),
    };
    if curves.len() != polygons.len() {
        return Err("the polygons are not one for each index: ".to_owned());
    }
    let sum = |level: u32| -> Option<Q> {
        curves.iter().zip(polygons).map(|(curve, polygon)| greatest(curve, polygon, level)).sum()
    };
    let Some(now) = sum(level) else { return Ok(()) };
    if bound.quantity == "step" {
        let Some(next) = sum(level + 1) else { return Ok(()) };
        let found = (now - next).abs();
        return if found == *left { Ok(()) } else { Err(format!("the step is {found}: ")) };
    }
    let last = (level..level + 8).take_while(|later| sum(*later).is_some()).last();
    let Some(later) = last else { return Ok(()) };
    let remainder = |curve: &Curve| curve.remainder(later);
    let rest: Option<Q> = curves.iter().map(remainder).sum();
    let rest = rest.ok_or("no limit is near: ")?;
    let near = sum(later).unwrap_or_else(Q::zero);
    let said = block.after("limit").unwrap_or_default();
    let words: Vec<&str> = said.split_whitespace().collect();
    let [side, value, ..] = &words[..] else { return Err("there is no limit: ".to_owned()) };
    let value: Q = value.parse().map_err(|_| "the limit is no number: ")?;
    let (fits, found) = match *side {
        "at-most" => (value >= &near - &rest, &now - &value),
        "at-least" => (value <= &near + &rest, &value - &now),
        _ => return Err("the limit is on no side: ".to_owned()),
    };
    if !fits || found != *left || (now - near).abs() + rest < *left {
        return Err(format!("the limit is not {side} {value}, or {found} not {left}: "));
    }
    Ok(())
}
