//! A ring whose rules are the same in all sectors: its blocks.

#![warn(clippy::arithmetic_side_effects)]

use super::polynomials::{Cyclic, Polynomial, at, characteristic_of_cycles};
use crate::functions::call::{number, wrong};
use crate::functions::limits::solve;
use crate::functions::masks::signed;
use crate::functions::steps::{Values, add, over, plus, times};
use crate::numbers::{Meter, Number, Q, Value, characteristic};
use crate::schemes::LocalRules;
use crate::text::Stop;
use num_bigint::BigInt;

/// The most orbits.
const MAX_ORBITS: usize = 12;

/// A ring with sectors.
pub struct Sectors<'m> {
    meter: &'m Meter,
    /// N.
    pub valence: usize,
    /// The names of the orbits, with the numbers of their points.
    pub orbits: Vec<(String, usize)>,
    /// The m_{a[0],b[d]}, by a, b and d.
    weights: Vec<Vec<Cyclic>>,
}

/// A characteristic polynomial for all blocks but that of 0: each coefficient is Σ_d c_d e^{2πikd/N}.
pub struct Turning<'s>(&'s Sectors<'s>, Vec<Cyclic>);

impl<'m> Sectors<'m> {
    /// Checks that the rules are the same in all sectors.
    pub fn new(
        meter: &'m Meter,
        ring: &LocalRules<'_>,
        valence: usize,
    ) -> Result<Sectors<'m>, Stop> {
        let orbits = ring.orbits.clone();
        if orbits.iter().any(|(_, count)| *count != 1 && *count != valence) {
            return wrong("an orbit of the ring has neither one point nor as many as the valence");
        }
        if orbits.len() > MAX_ORBITS {
            return Err(Stop::Capped("the orbits of a ring"));
        }
        let (mut rows, mut weights) = (ring.weights.iter(), Vec::new());
        for (_, count) in &orbits {
            let of_orbit: Vec<&[Value]> = rows.by_ref().take(*count).map(|row| &row[..]).collect();
            let Some(first) = of_orbit.first().map(|row| parts(row, &orbits)) else { continue };
            for (turn, row) in of_orbit.iter().enumerate() {
                // m_{a[i],b[i+d]} = m_{a[0],b[d]}; in an orbit of one point the next index is the same one.
                for (own, expected) in parts(row, &orbits).iter().zip(&first) {
                    is_turned(meter, own, expected, turn)?;
                }
            }
            if *count == 1 {
                // The only point is also the next one.
                for part in &first {
                    is_turned(meter, part, part, 1)?;
                }
            }
            let first = first.into_iter().map(<[Value]>::to_vec).collect::<Vec<Cyclic>>();
            first.iter().flatten().try_for_each(|weight| weight.number().map(|_| ()))?;
            weights.push(first);
        }
        Ok(Sectors { meter, valence, orbits, weights })
    }

    /// M_0.
    fn sums(&self) -> Result<Vec<Vec<Value>>, Stop> {
        let sum = |weights: &Cyclic| {
            let mut sum = Value::int(0);
            weights.iter().try_for_each(|weight| plus(self.meter, &mut sum, weight))?;
            Ok(sum)
        };
        self.weights.iter().map(|row| row.iter().map(sum).collect()).collect()
    }

    /// The characteristic polynomial of M_0.
    pub fn still(&self) -> Result<Polynomial, Stop> {
        characteristic(&Values(self.meter), &self.sums()?)
    }

    /// Σ_d m_{a[0],b[d]} x^d for the orbits a and b of N points: M_k for x = e^{2πik/N}.
    pub fn turned(&self) -> Vec<Vec<Cyclic>> {
        let turns = || self.orbits.iter().map(|(_, count)| *count > 1);
        let rows = self.weights.iter().zip(turns()).filter(|(_, turns)| *turns);
        rows.map(|(row, _)| {
            row.iter().zip(turns()).filter(|(_, turns)| *turns).map(|(c, _)| c.clone()).collect()
        })
        .collect()
    }

    /// The characteristic polynomials of the blocks but M_0.
    pub fn turning(&self) -> Result<Turning<'_>, Stop> {
        let matrix = self.turned();
        Ok(Turning(self, characteristic_of_cycles(self.meter, self.valence, &matrix)?))
    }

    /// The sums of the limit weights of the points of each orbit: uM_0 = u, Σu = 1.
    pub fn limit(&self) -> Result<Vec<Value>, Stop> {
        let unique = Stop::Capped("limit weights that are not unique");
        // Another solution would differ by an eigenvector of M of the eigenvalue 1.
        let turning = self.turning()?;
        for k in 1..=self.valence.div_euclid(2) {
            if turning.is_root(k, &Value::int(1))? {
                return Err(unique);
            }
        }
        let sums = self.sums()?;
        let mut rows = Vec::new();
        for b in 0..sums.len() {
            let mut row: Vec<Value> = sums.iter().filter_map(|row| row.get(b).cloned()).collect();
            if let Some(own) = row.get_mut(b) {
                plus(self.meter, own, &Value::int(-1))?;
            }
            row.push(Value::int(0));
            rows.push(row);
        }
        // The weights of a point sum to 1, so that one equation follows from the others.
        if let Some(first) = rows.first_mut() {
            first.fill(Value::int(1));
        }
        solve(self.meter, rows)
    }
    /// The real part of Σ_d c_d e^{2πikd/N}, or the imaginary one.
    pub fn part(&self, c: &Cyclic, k: usize, imaginary: bool) -> Result<Value, Stop> {
        let (meter, n) = (self.meter, c.len());
        // Sums of the c_d with one kd mod N, and for cosines with one ±kd.
        let mut sums = vec![Value::int(0); n];
        for (d, c) in c.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            let place = k.saturating_mul(d).checked_rem(n).unwrap_or(0);
            let other = n.saturating_sub(place);
            let least = place.min(other);
            match sums.get_mut(least) {
                Some(sum) if !imaginary || place == least => plus(meter, sum, c)?,
                Some(sum) => plus(meter, sum, &c.negated()?)?,
                None => {}
            }
        }
        let mut total = Value::int(0);
        for (place, sum) in sums.iter().enumerate().filter(|(_, sum)| !sum.is_zero()) {
            let mut turn = Q::new(signed(place)?.into(), signed(n)?.into());
            if imaginary {
                turn -= Q::new(BigInt::from(1), BigInt::from(4));
            }
            let cosine = match (imaginary, place) {
                (true, 0) => continue,
                (false, 0) => Value::int(1),
                _ => {
                    meter.spend((n as u64).saturating_mul(n as u64) / 4)?;
                    Number::cosine(&turn)?.into()
                }
            };
            add(meter, &mut total, sum, &cosine)?;
        }
        Ok(total)
    }
}

/// The weights of the points of each orbit.
fn parts<'r>(mut row: &'r [Value], orbits: &[(String, usize)]) -> Vec<&'r [Value]> {
    let mut parts = Vec::new();
    for (_, count) in orbits {
        let (part, rest) = row.split_at(row.len().min(*count));
        parts.push(part);
        row = rest;
    }
    parts
}

/// Checks that own_{d + turn} = expected_d.
fn is_turned(meter: &Meter, own: &[Value], expected: &[Value], turn: usize) -> Result<(), Stop> {
    let turned = own.iter().cycle().skip(turn.checked_rem(own.len()).unwrap_or(0));
    for (a, b) in turned.zip(expected) {
        meter.spend(1)?;
        if a != b {
            meter.spend(a.steps(b))?;
            if !a.equals(b)? {
                return wrong("the weights of the ring are not the same in all sectors");
            }
        }
    }
    Ok(())
}

impl Turning<'_> {
    /// The characteristic polynomial of M_k, k ≠ 0, which must be real.
    pub fn block(&self, k: usize) -> Result<Polynomial, Stop> {
        let coefficient = |c: &Cyclic| {
            if self.0.part(c, k, true)?.is_zero() {
                self.0.part(c, k, false)
            } else {
                wrong("the characteristic polynomial of a block of the ring is not real")
            }
        };
        self.1.iter().map(coefficient).collect()
    }

    /// Whether x is a root of that of M_k.
    fn is_root(&self, k: usize, x: &Value) -> Result<bool, Stop> {
        let meter = self.0.meter;
        for imaginary in [false, true] {
            let p = self.1.iter().map(|c| self.0.part(c, k, imaginary));
            if !at(meter, &p.collect::<Result<Vec<Value>, Stop>>()?, x)?.is_zero() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// The weight of each point of an orbit of so many.
pub fn of_each(meter: &Meter, weight: &Value, count: usize) -> Result<Value, Stop> {
    over(meter, weight, &number(count))
}

/// μ/λ².
pub fn over_square(meter: &Meter, mu: &Value, lambda: &Value) -> Result<Value, Stop> {
    over(meter, mu, &times(meter, lambda, lambda)?)
}
