//! The weights of the points of a ring in the tangents at its vertex: the left eigenvector of block 1 for λ.

#![warn(clippy::arithmetic_side_effects)]

use super::places::{DIGITS, Factor, Place, decide};
use super::polynomials::{
    Cyclic, Polynomial, adjugate_of_cycles, at, common, divided, monic, trimmed,
};
use super::sectors::Sectors;
use crate::enclosures;
use crate::functions::real::Real;
use crate::functions::steps::{add, over, times};
use crate::numbers::{Meter, Number, Value};
use crate::text::Stop;

/// The row û of λ, û M_1 = λû, by a row of adj(λ − M_1).
pub struct Tangents<'s> {
    meter: &'s Meter,
    sectors: &'s Sectors<'s>,
    lambda: &'s Place,
    /// The entries of the row for the orbits of N points, polynomials in λ.
    row: Vec<Vec<Cyclic>>,
    /// The entry for the first orbit for which û is not 0.
    unit: Polynomial,
}

impl<'s> Tangents<'s> {
    /// Finds the row.
    pub fn new(
        meter: &'s Meter,
        sectors: &'s Sectors<'s>,
        lambda: &'s Place,
    ) -> Result<Tangents<'s>, Stop> {
        let (mut entries, scale) = adjugate_of_cycles(meter, sectors.valence, &sectors.turned())?;
        // They are polynomials in dλ.
        for entry in entries.iter_mut().flatten() {
            let mut power = Value::int(1);
            for element in entry {
                for c in element.iter_mut() {
                    *c = times(meter, c, &power)?;
                }
                power = times(meter, &power, &scale)?;
            }
        }
        let part = |entry: &[Cyclic], imaginary: bool| {
            let each = entry.iter().map(|c| sectors.part(c, 1, imaginary));
            each.collect::<Result<Polynomial, Stop>>().map(trimmed)
        };
        for place in 0..entries.len() {
            let mut first = false;
            for (row, other) in entries.iter().enumerate() {
                let Some(entry) = other.get(place) else { continue };
                let [real, imaginary] = [part(entry, false)?, part(entry, true)?];
                let is_real = is_root(meter, &imaginary, lambda)?;
                let is_zero = is_real && is_root(meter, &real, lambda)?;
                if row == place && !is_zero {
                    if !is_real {
                        return Err(Stop::Undefined("the entry of a tangent is not real"));
                    }
                    let row = other.clone();
                    return Ok(Tangents { meter, sectors, lambda, row, unit: real });
                }
                first |= !is_zero;
            }
            if first {
                return Err(Stop::Undefined("the entry of a tangent is 0"));
            }
        }
        Err(Stop::Undefined("the block has no tangents"))
    }

    /// Re û_a ω^{−j} for the orbit a of this number among those of N points, or −Im û_a ω^{−j}.
    pub fn weight(&self, place: usize, j: usize, second: bool) -> Result<Real, Stop> {
        let mut p = Polynomial::new();
        for c in self.row.get(place).into_iter().flatten() {
            // The element times x^−j.
            let mut turned = c.clone();
            turned.rotate_left(j.checked_rem(c.len()).unwrap_or(0));
            let part = self.sectors.part(&turned, 1, second)?;
            p.push(if second { part.negated()? } else { part });
        }
        self.over_unit(&trimmed(p))
    }

    /// p/unit at λ.
    fn over_unit(&self, p: &Polynomial) -> Result<Real, Stop> {
        let (meter, unit) = (self.meter, &self.unit);
        let Place::Of(factor, _) = self.lambda else {
            let Place::Exact(x) = self.lambda else { return Ok(Real::Exact(Value::int(0))) };
            return Ok(Real::Exact(over(meter, &at(meter, p, x)?, &at(meter, unit, x)?)?));
        };
        let modulus = monic(meter, &factor.p)?;
        let [p, unit] = [p, unit].map(|p| divided(meter, p, &modulus));
        let (p, unit) = (p?.1, unit?.1);
        if let Some(ratio) = ratio(meter, &p, &unit)? {
            return Ok(Real::Exact(ratio));
        }
        let lambda = Box::new(self.lambda.real()?);
        let value = |p: &[Value]| -> Result<Box<Real>, Stop> {
            let p = p.iter().map(|c| c.number().cloned());
            Ok(Box::new(Real::At(p.collect::<Result<Vec<Number>, Stop>>()?, lambda.clone())))
        };
        Ok(Real::Ratio(value(&p)?, value(&unit)?))
    }
}

/// The number that p is times q ≠ 0, if it is a multiple.
fn ratio(meter: &Meter, p: &[Value], q: &[Value]) -> Result<Option<Value>, Stop> {
    let (Some(top), Some(bottom)) = (p.last(), q.last()) else {
        return Ok(p.is_empty().then(|| Value::int(0)));
    };
    if p.len() != q.len() {
        return Ok(None);
    }
    let ratio = over(meter, top, bottom)?;
    let factor = ratio.negated()?;
    for (a, b) in p.iter().zip(q) {
        let mut rest = a.clone();
        add(meter, &mut rest, &factor, b)?;
        if !rest.is_zero() {
            return Ok(None);
        }
    }
    Ok(Some(ratio))
}

/// Whether p, without leading coefficients that are 0, is 0 at a place.
fn is_root(meter: &Meter, p: &[Value], place: &Place) -> Result<bool, Stop> {
    let factor = match place {
        _ if p.is_empty() => return Ok(true),
        Place::Exact(x) => return Ok(at(meter, p, x)?.is_zero()),
        Place::Of(factor, _) => factor,
    };
    let is_not_zero = |p: &[Value], bits: u64| -> Result<bool, Stop> {
        let p = Factor::enclosure(meter, p, bits)?;
        let value = enclosures::at(&p, &place.enclosed(meter, bits)?, bits)?;
        Ok(value.sign().is_some_and(|sign| sign != 0))
    };
    match is_not_zero(p, DIGITS[0]) {
        Ok(true) => return Ok(false),
        Ok(false) | Err(Stop::Undecided(_)) => {}
        Err(stop) => return Err(stop),
    }
    // The root is one of the common divisor or of the quotient, and not of both.
    let modulus = monic(meter, &factor.p)?;
    let shared = common(meter, &modulus, p)?;
    let rest = divided(meter, &modulus, &shared)?.0;
    if shared.len() < 2 || rest.len() < 2 {
        return Ok(shared.len() >= 2);
    }
    decide(|bits| {
        if is_not_zero(&shared, bits)? {
            return Ok(Some(false));
        }
        Ok(is_not_zero(&rest, bits)?.then_some(true))
    })
}
