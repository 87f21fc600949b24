//! Eigenvalues and weights around a vertex or on a face, and the eigenvalues of the local matrix of a mask.

#![warn(clippy::arithmetic_side_effects)]

mod blocks;
mod roots;

use super::call::{Call, within, wrong};
use super::limits::window;
use super::masks::{Mask, signed};
use super::real::Real;
use crate::numbers::{Number, Value};
use crate::schemes::LocalRules;
use crate::shipped::Interval;
use crate::text::Stop;
use blocks::{Blocks, polynomial};
use roots::{Root, Roots, roots, size};
use std::cmp::Ordering;

/// The greatest valence.
const MAX_VALENCE: i64 = 100;

/// The greatest number of an eigenvalue.
const MAX_NUMBER: i64 = 1_000;

/// The most rows of a local matrix.
const MAX_ROWS: usize = 32;

/// The value of such a function, if it is known; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    real(call)?.map(Real::value).transpose()
}

/// The same as a real number.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    Ok(Some(match (call.function, call.arguments) {
        ("eigenvalue", [number]) => {
            let number = within(number, 1, MAX_NUMBER)?;
            nth(&local(call)?, number)?
        }
        ("eigenvalue", [valence, block, number]) => {
            let ring = ring(call, valence)?;
            let block = within(block, 0, MAX_VALENCE)?;
            if block >= ring.order {
                return wrong("there is no such block");
            }
            let block = block.min(ring.order.saturating_sub(block));
            let number = within(number, 1, MAX_NUMBER)?;
            let polynomials = ring.polynomials()?;
            nth(&roots(&polynomials[block], ring.meter)?, number)?
        }
        ("subdominant", [valence]) => Spectrum::of(&ring(call, valence)?)?.lambda()?.value.clone(),
        ("curvature", [valence]) => {
            let part = call.choose("part", &["both", "elliptic", "hyperbolic"])?;
            Spectrum::of(&ring(call, valence)?)?.curvature(part)?
        }
        ("limit_weight", [valence]) => {
            let orbit = call.word("orbit", "");
            limit_weight(&ring(call, valence)?, &orbit)?
        }
        _ => return Ok(None),
    }))
}

/// The ring that the call is about, at a valence.
fn ring<'c>(call: &mut Call<'c>, valence: &Value) -> Result<Blocks<'c>, Stop> {
    let order = within(valence, 3, MAX_VALENCE)?;
    let Some(reference) = call.reference()?.or_else(|| call.scope.ring.clone()) else {
        return wrong(format!("`{}` needs rules around a vertex or on a face", call.function));
    };
    let valence = i64::try_from(order).ok();
    let rules = LocalRules::of_valence(call.library, &reference, call.scope, valence)?;
    Blocks::of(call.library.meter, &rules, order)
}

/// The j-th greatest real root.
fn nth(found: &Roots, number: usize) -> Result<Real, Stop> {
    let all = found.real.iter().flat_map(|root| std::iter::repeat_n(root, root.multiplicity));
    let mut all = all.skip(number.saturating_sub(1));
    all.next().map(|root| root.value.clone()).ok_or(Stop::Undefined("there is no such eigenvalue"))
}

/// The real eigenvalues of the local matrix of a mask.
fn local(call: &mut Call<'_>) -> Result<Roots, Stop> {
    let meter = call.library.meter;
    let mask = Mask::of_numbers(meter, &*call.scheme()?)?;
    let (n, (first, last)) = (signed(mask.arity)?, window(&mask)?);
    let far = || Stop::Capped("the places of the coefficients of a mask");
    let below = n.checked_sub(1).ok_or_else(far)?;
    let inside = |k: &i64| {
        let place = k.checked_mul(below);
        let (low, high) = (mask.first, mask.last());
        place.zip(high.ok()).is_some_and(|(place, high)| low < place && place < high)
    };
    let places: Vec<i64> = (first..=last).filter(inside).collect();
    if places.is_empty() {
        return Err(Stop::Undefined("there is no local matrix"));
    }
    if places.len() > MAX_ROWS {
        return Err(Stop::Capped("the rows of a local matrix"));
    }
    let mut matrix = Vec::new();
    for k in &places {
        let at = n.checked_mul(*k).ok_or_else(far)?;
        let entry = |l: &i64| {
            let a = at.checked_sub(*l).and_then(|k| mask.at(k));
            a.map_or(Ok(Number::Small(0, 1)), |a| a.number().cloned())
        };
        matrix.push(places.iter().map(entry).collect::<Result<Vec<Number>, Stop>>()?);
    }
    roots(&polynomial(&matrix, meter)?, meter)
}

/// The eigenvalues of the blocks 0, …, ⌊N/2⌋.
struct Spectrum {
    order: usize,
    blocks: Vec<Roots>,
}

fn is_one(root: &Root) -> bool {
    matches!(&root.value, Real::Exact(value) if *value == Value::int(1))
}

impl Spectrum {
    fn of(ring: &Blocks<'_>) -> Result<Spectrum, Stop> {
        let polynomials = ring.polynomials()?;
        let blocks = polynomials.iter().map(|p| roots(p, ring.meter));
        Ok(Spectrum { order: ring.order, blocks: blocks.collect::<Result<Vec<Roots>, Stop>>()? })
    }

    /// The subdominant eigenvalue.
    fn lambda(&self) -> Result<&Root, Stop> {
        let none = Stop::Undefined("there is no subdominant eigenvalue");
        if self.blocks.iter().any(|block| block.others > 0) {
            return Err(Stop::Capped("complex eigenvalues"));
        }
        let ones: usize = self.blocks[0]
            .real
            .iter()
            .filter(|root| is_one(root))
            .map(|root| root.multiplicity)
            .sum();
        let lambda = self.blocks.get(1).and_then(|block| block.real.first()).ok_or(none.clone())?;
        if ones != 1 || lambda.multiplicity != 1 || lambda.near.sign() != Some(1) {
            return Err(none);
        }
        // λ is below 1, and all others are below λ.
        if lambda.near.compare(&1.into()) != Some(Ordering::Less) {
            return Err(none);
        }
        for other in self.others(|_| true) {
            match other.near.absolute().compare(&lambda.near) {
                Some(Ordering::Less) => {}
                Some(_) => return Err(none),
                None => return Err(Stop::Capped("the digits that separate eigenvalues")),
            }
        }
        Ok(lambda)
    }

    /// The eigenvalues of some blocks but 1 and λ.
    fn others(&self, of: impl Fn(usize) -> bool) -> Vec<&Root> {
        let own = |(k, block): (usize, &'_ Roots)| -> Vec<usize> {
            (0..block.real.len())
                .filter(|place| !(k == 0 && is_one(&block.real[*place]) || k == 1 && *place == 0))
                .collect()
        };
        let blocks = self.blocks.iter().enumerate().filter(|(k, _)| of(*k));
        blocks
            .flat_map(|(k, block)| {
                own((k, block)).into_iter().map(|place| &block.real[place]).collect::<Vec<&Root>>()
            })
            .collect()
    }

    /// The greatest absolute value of other eigenvalues over λ².
    fn curvature(&self, part: usize) -> Result<Real, Stop> {
        let lambda = self.lambda()?;
        // Block N − 2 has the eigenvalues of block 2.
        let second = 2.min(self.order.saturating_sub(2));
        let others = self.others(|k| match part {
            0 => true,
            1 => k == 0,
            _ => k == second,
        });
        let mut greatest: Option<(Real, Interval)> = None;
        for root in others {
            let next = if root.near == Interval::from(0) {
                (Real::Exact(Value::int(0)), root.near.clone())
            } else {
                size(root)?
            };
            greatest = Some(match greatest {
                None => next,
                Some(best) => match best.1.compare(&next.1) {
                    Some(Ordering::Less) => next,
                    Some(_) => best,
                    None if is_same(&best.0, &next.0) => best,
                    None => return Err(Stop::Capped("the digits that separate eigenvalues")),
                },
            });
        }
        let (value, _) = greatest.ok_or(Stop::Undefined("there are no other eigenvalues"))?;
        if let (Real::Exact(top), Real::Exact(bottom)) = (&value, &lambda.value) {
            return Ok(Real::Exact(top.over(bottom)?.over(bottom)?));
        }
        let lambda = || Box::new(lambda.value.clone());
        let ratio = Real::Ratio(Box::new(value), lambda());
        Ok(Real::Ratio(Box::new(ratio), lambda()))
    }
}

/// Whether two numbers are given alike.
fn is_same(one: &Real, other: &Real) -> bool {
    match (one, other) {
        (Real::Exact(one), Real::Exact(other)) => one == other,
        (Real::RootOf(p, i), Real::RootOf(q, j)) => p == q && i == j,
        _ => false,
    }
}

/// The weight of each point of an orbit in w, wM = w, Σw = 1.
fn limit_weight(ring: &Blocks<'_>, orbit: &str) -> Result<Real, Stop> {
    let matrix = ring.still()?;
    let size = matrix.len();
    let place = ring.orbits.iter().position(|(name, _)| name == orbit || orbit.is_empty());
    let place = place.ok_or_else(|| Stop::Wrong(format!("the ring has no orbit `{orbit}`")))?;
    // Σ_a u_a(M_{a,b} − δ_{a,b}) = 0, of which the last follows from the others, and Σ u = 1.
    let mut rows: Vec<Vec<Value>> = Vec::new();
    for b in 0..size {
        let mut row = Vec::new();
        for (a, from) in matrix.iter().enumerate() {
            let entry = Value::from(from[b].clone());
            row.push(if a == b { entry.minus(&Value::int(1))? } else { entry });
        }
        row.push(Value::int(0));
        rows.push(row);
    }
    let last = size.saturating_sub(1);
    rows[last] = vec![Value::int(1); size.saturating_add(1)];
    let solution = solved(rows)?;
    let points = ring.orbits[place].1.len();
    Ok(Real::Exact(solution[place].over(&super::call::number(points))?))
}

/// The only solution of linear equations.
fn solved(mut rows: Vec<Vec<Value>>) -> Result<Vec<Value>, Stop> {
    let size = rows.len();
    for column in 0..size {
        let pivot = (column..size).find(|row| !rows[*row][column].is_zero());
        let pivot = pivot.ok_or(Stop::Undefined("the points have no limit, or not one"))?;
        rows.swap(column, pivot);
        let lead = rows[column][column].clone();
        for entry in &mut rows[column] {
            *entry = entry.over(&lead)?;
        }
        let own = rows[column].clone();
        for (place, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if place != column && !factor.is_zero() {
                for (entry, other) in row.iter_mut().zip(&own) {
                    *entry = entry.minus(&factor.times(other)?)?;
                }
            }
        }
    }
    Ok(rows.into_iter().filter_map(|mut row| row.pop()).collect())
}
