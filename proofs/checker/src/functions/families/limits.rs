//! How smooth the limits of a family are, and where its symbols are 0: each step of the index multiplies the symbol by the same powers of σ(z) = 1 + z + … + z^{n−1}.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::{Call, number};
use crate::functions::masks::quotient;
use crate::functions::real::Real;
use crate::functions::steps::add;
use crate::functions::{exponent, limits, modulus, peaks, shape, zeros};
use crate::numbers::{Meter, Value, int};
use crate::schemes::{Factor, Family, Scheme};
use crate::text::Stop;
use std::rc::Rc;

const OTHER: Stop = Stop::Family("a factor that depends on the index is no power of σ(z)");
const ENCLOSED: Stop = Stop::Family("the value for the first integer is not known to be rational");
const CHANGES: Stop =
    Stop::Family("the value for the first integer may be another one for the next");
const DIVERGES: Stop = Stop::Family("the scheme of the first integer diverges");

/// What is known of a function of all members.
pub enum Known {
    /// It is v + s(t − m), where v is its value for t = m.
    Grows,
    /// It is v: all symbols have the same zeros.
    Stays,
    /// It is v if v is this number.
    StaysAt(usize),
}

/// What is known of the function of this name.
pub fn known(function: &str, arity: usize) -> Option<Known> {
    match function {
        "smoothness" | "hoelder" | "sobolev" => Some(Known::Grows),
        "independent" | "hurwitz" => Some(Known::Stays),
        "positive" | "monotone" | "convex" | "overshoot" | "gibbs" | "riesz_upper" => {
            Some(Known::StaysAt(1))
        }
        "modulus_upper" => Some(Known::StaysAt(arity)),
        _ => None,
    }
}

/// The value of such a function for all t ≥ m.
pub fn of(call: &mut Call<'_>, known: &Known, family: &Family) -> Result<Value, Stop> {
    let (library, meter) = (call.library, call.library.meter);
    let mut slope = Value::int(0);
    for factor in &family.factors {
        if factor.slope == 0 {
            // Coefficients that depend on the index would change the limits too.
            factor.terms.values().try_for_each(|c| c.number().map(|_| ())).map_err(|_| OTHER)?;
        } else {
            let power = number(power_of_sigma(meter, factor, family.arity)?);
            add(meter, &mut slope, &Value::int(factor.slope), &power)?;
        }
    }
    let member = Rc::new(library.member(family, family.integers.least)?);
    let Some(Real::Exact(value)) = of_member(call, &member)? else { return Err(ENCLOSED) };
    match known {
        Known::Grows => {
            let rational = value.rational().ok_or(ENCLOSED)?;
            if call.function == "smoothness" && rational < int(0) {
                return Err(DIVERGES);
            }
            let since = family.integers.polynomial(vec![-int(family.integers.least), int(1)]);
            value.plus(1, &slope.times(&since)?)
        }
        Known::StaysAt(extreme) if !value.minus(&number(*extreme))?.is_zero() => Err(CHANGES),
        Known::Stays | Known::StaysAt(_) => Ok(value),
    }
}

/// The value of the function for one scheme.
fn of_member(call: &mut Call<'_>, member: &Rc<Scheme>) -> Result<Option<Real>, Stop> {
    let (library, meter) = (call.library, call.library.meter);
    Ok(Some(match call.function {
        "smoothness" | "hoelder" => exponent::shown(library, call.function, member)?,
        "sobolev" => exponent::sobolev(library, member)?,
        "independent" => Real::Exact(exponent::independent(meter, member)?),
        "hurwitz" => Real::Exact(zeros::hurwitz(meter, member)?),
        function => {
            call.set_scheme(Rc::clone(member));
            match function {
                "overshoot" | "gibbs" => return peaks::real(call),
                "riesz_upper" => return limits::real(call),
                "modulus_upper" => return modulus::real(call),
                _ => Real::Exact(shape::of(call)?),
            }
        }
    }))
}

/// The j of a factor c·z^k·σ(z)^j with a number c.
fn power_of_sigma(meter: &Meter, factor: &Factor, n: usize) -> Result<usize, Stop> {
    let (mut rest, mut power) = (factor.dense(), 0_usize);
    while rest.len() > 1 {
        rest = quotient(meter, &rest, n, None)?.ok_or(OTHER)?;
        power = power.saturating_add(1);
    }
    let number = rest.first().is_some_and(|c| c.number().is_ok());
    if number { Ok(power) } else { Err(OTHER) }
}
