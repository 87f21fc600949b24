//! The weights of limits and tangents of rings for all valences from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::blocks::{Block, Rest, are_below, cosine, ends};
use super::function::{Function, Functions};
use super::pair::{Pair, Turns};
use super::polynomial::{H, Polynomial, T};
use super::ring::{NEAR, Ring};
use crate::numbers::int;
use crate::text::Stop;

const DIVERGES: Stop = Stop::Integers("other roots are not shown to be less than 1");
const UNIQUE: Stop = Stop::Integers("the limit weights are not shown to be unique");
const ENTRY: Stop = Stop::Integers("the entry of a tangent is not shown to be real and not 0");

/// Checks that the roots of a polynomial are less than a limit in absolute value.
fn require_below(functions: &Functions<'_>, p: &[Function], limit: &Function) -> Result<(), Stop> {
    if are_below(functions, p, limit, false)? { Ok(()) } else { Err(DIVERGES) }
}

/// The weight of each point of an orbit in the limit.
pub fn limit(functions: &Functions<'_>, ring: &Ring, orbit: usize) -> Result<Function, Stop> {
    let one = Function::int(1);
    let blocks = std::iter::once(Block::Still).chain((1..=NEAR.unsigned_abs()).map(Block::At));
    for block in blocks {
        let rest = Rest::new(functions, ring, block)?;
        require_below(functions, &rest.p, &one)?;
    }
    let later = Rest::new(functions, ring, Block::Later)?;
    for end in ends(functions, &later.p)? {
        require_below(functions, &end, &one)?;
    }
    // A row of adj(1 − M_0) that is not 0 is u with uM_0 = u, and no other is.
    let turns = Turns::new(functions, &Polynomial::int(1));
    let (_, adjugates) = turns.characteristic(&ring.still(functions)?)?;
    let adjugate = turns.adjugate(&adjugates, &one)?;
    let row = adjugate.first().ok_or(UNIQUE)?;
    let mut sum = Function::default();
    for entry in row {
        sum = functions.sum(&sum, 1, &entry.real)?;
    }
    if functions.sign(&sum)? == 0 {
        return Err(UNIQUE);
    }
    let (own, (_, turns)) = row.get(orbit).zip(ring.orbits.get(orbit)).ok_or(UNIQUE)?;
    let points = if *turns { Polynomial::variable(T) } else { Polynomial::int(1) };
    functions.quotient(&own.real, &functions.product(&sum, &points.into())?)
}

/// Re û_a ω^{−j} for an orbit a, or −Im û_a ω^{−j}, where û M_1 = λû.
pub fn tangent(
    functions: &Functions<'_>,
    ring: &Ring,
    lambda: &Function,
    (orbit, j, second): (usize, i64, bool),
) -> Result<Function, Stop> {
    let turning = |(_, turns): &&(String, bool)| *turns;
    if !ring.orbits.get(orbit).is_some_and(|orbit| orbit.1) {
        return Ok(Function::default());
    }
    let place = ring.orbits.iter().take(orbit).filter(turning).count();
    let first = cosine(functions, 1)?;
    let turns = Turns::new(functions, &first);
    let (_, adjugates) = turns.characteristic(&ring.turning(&turns, 1)?)?;
    let adjugate = turns.adjugate(&adjugates, lambda)?;
    let is_zero = |pair: &Pair| {
        Ok::<_, Stop>(functions.is_zero(&pair.real)? && functions.is_zero(&pair.turned)?)
    };
    for own in 0..adjugate.len() {
        let column = adjugate.iter().filter_map(|row| row.get(own)).map(is_zero);
        if !column.collect::<Result<Vec<bool>, Stop>>()?.contains(&false) {
            continue;
        }
        // û is not 0 for this orbit, and 0 for those before it.
        let row = adjugate.get(own).ok_or(ENTRY)?;
        let (unit, entry) = row.get(own).zip(row.get(place)).ok_or(ENTRY)?;
        if !functions.is_zero(&unit.turned)? || functions.sign(&unit.real)? == 0 {
            return Err(ENTRY);
        }
        let value = turns.product(entry, &turns.power(j.saturating_neg())?)?;
        // ω = cos(2π/t) + i·sin(2π/t), and sin(2π/t) = 2h√(1 − h²).
        let part = if second {
            let meter = functions.meter();
            let h = Polynomial::variable(H);
            let square = Polynomial::int(1).plus(meter, -1, &h.times(meter, &h)?)?;
            let root = functions.square_root(&square.into())?;
            let sine = functions.product(&root, &h.scaled(&int(-2)).into())?;
            functions.product(&value.turned, &sine)?
        } else {
            functions.sum(&value.real, 1, &functions.product(&value.turned, &first.into())?)?
        };
        return functions.quotient(&part, &unit.real);
    }
    Err(ENTRY)
}
