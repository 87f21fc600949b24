//! Bounds that are proved, tried on the data that are worst at many levels.

use super::{names, supposed};
use crate::random_papers::draft::{Bound, Draft, Instance, Shape};
use crate::random_papers::naive::{Curve, LocalRules, Net, Q, int};

/// How many levels are looked at.
const LEVELS: u32 = 24;

/// How many residue classes are followed from level to level.
const FOLLOWED: usize = 3;

pub fn holds(draft: &Draft, bound: &Bound) -> Result<(), String> {
    let [instance] = &bound.instances[..] else {
        return Err("it is about several instances: ".to_owned());
    };
    if !supposed(draft, bound, instance) {
        return Ok(());
    }
    match &instance.shape {
        Shape::Curve(curve) => {
            let curve = curve.with_offset(bound.offset);
            for (level, value) in found(&curve, bound) {
                within(draft, bound, instance, level, &value, &[int(1)])?;
            }
        }
        Shape::Net(Net(pair)) => {
            // x_{i,j} = a_i + b_j: the differences of one, the steps and distances of both.
            let [one, other] =
                pair.each_ref().map(|curve| found(&curve.with_offset(bound.offset), bound));
            for ((level, first), (_, second)) in one.into_iter().zip(other) {
                let (zero, unit) = (int(0), int(1));
                let both = if bound.quantity == "difference" {
                    first.clone().max(second.clone())
                } else {
                    &first + &second
                };
                within(draft, bound, instance, level, &both, &[unit.clone(), unit.clone()])?;
                within(draft, bound, instance, level, &first, &[unit.clone(), zero.clone()])?;
                within(draft, bound, instance, level, &second, &[zero, unit])?;
            }
        }
        Shape::LocalRules(ring, earlier) => {
            let earlier = match earlier {
                None => None,
                Some(earlier) => {
                    Some(earlier.ordered_as(ring).ok_or("the interpolant has other points: ")?)
                }
            };
            let heights = ring.heights();
            for level in bound.from..bound.from + LEVELS {
                let rows = match bound.quantity {
                    "difference" => ring.differences(level),
                    "step" => ring.steps(level, earlier.as_ref()),
                    _ => away(ring, level),
                };
                let mut value = LocalRules::greatest(&rows, &heights);
                if bound.quantity == "distance" {
                    value -=
                        ring.remainder(level + LEVELS, &heights).ok_or("no limit is near: ")?;
                }
                within(draft, bound, instance, level, &value, &[int(1)])?;
            }
        }
    }
    Ok(())
}

/// The points of a level less those of a much later one.
fn away(ring: &LocalRules, level: u32) -> Vec<Vec<Q>> {
    let (now, later) = (ring.rows(level), ring.rows(level + LEVELS));
    now.iter().zip(&later).map(|(now, later)| LocalRules::less(now, later)).collect()
}

fn within(
    draft: &Draft,
    bound: &Bound,
    instance: &Instance,
    level: u32,
    value: &Q,
    spreads: &[Q],
) -> Result<(), String> {
    let by = names(draft, instance, spreads, ("k", int(level.into()))).value(&bound.by);
    let by = by.ok_or_else(|| format!("the bound has no value: at level {level}"))?;
    if *value > by {
        return Err(format!("some data exceed it: {value} > {by} at level {level}"));
    }
    Ok(())
}

/// Of each level a value that the quantity attains, or exceeds, for the spread 1: exact at the first
/// levels, and later that of the parts of the places that were worst before.
fn found(curve: &Curve, bound: &Bound) -> Vec<(u32, Q)> {
    let arity = curve.arity();
    // A distance is compared at points of a later level, and the rest is subtracted.
    let finer = |level: u32| match bound.quantity {
        "difference" => level,
        "step" => level + 1,
        _ => level + 4,
    };
    let rest = |level: u32| match bound.quantity {
        "distance" => curve.remainder(finer(level)),
        _ => Some(int(0)),
    };
    let value = |level: u32, place: i64| match bound.quantity {
        "difference" => curve.difference(level, place),
        _ => curve.apart(level, finer(level), place),
    };
    let mut places: Vec<i64> = vec![0];
    let mut found = Vec::new();
    for level in 0..bound.from + LEVELS {
        let before = if level == 0 { 0 } else { finer(level - 1) };
        let parts = arity.pow(finer(level) - before);
        let mut known: Vec<(Q, i64)> = places
            .iter()
            .flat_map(|place| (0..parts).map(move |part| place * parts + part))
            .map(|place| (value(level, place), place))
            .collect();
        known.sort();
        known.reverse();
        // The first levels are looked at everywhere.
        let all = arity.pow(finer(level)) <= 128;
        places =
            known.iter().map(|(_, place)| *place).take(if all { 128 } else { FOLLOWED }).collect();
        if level >= bound.from {
            let Some(rest) = rest(level) else { return Vec::new() };
            found.push((level, &known[0].0 - rest));
        }
    }
    found
}
