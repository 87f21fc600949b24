//! How smooth the limits of a family are, and where its symbols are 0: each step of the index multiplies the symbol by the same powers of σ(z) = 1 + z + … + z^{n−1}.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::number;
use crate::functions::exponent;
use crate::functions::masks::quotient;
use crate::functions::real::Real;
use crate::functions::steps::add;
use crate::functions::zeros;
use crate::numbers::{Meter, Value, int};
use crate::schemes::{Factor, Family, Library};
use crate::text::Stop;

const OTHER: Stop = Stop::Family("a factor that depends on the index is no power of σ(z)");
const ENCLOSED: Stop = Stop::Family("the value for the first integer is not known to be rational");
const DIVERGES: Stop = Stop::Family("the scheme of the first integer diverges");

/// v + s(t − m), where v is the value for t = m, and s = 0 for what depends on the zeros alone: all symbols have the same.
pub fn of(library: &Library<'_>, function: &str, family: &Family) -> Result<Value, Stop> {
    let meter = library.meter;
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
    let first = library.member(family, family.integers.least)?;
    let found = match function {
        "sobolev" => exponent::sobolev(library, &first)?,
        "independent" => Real::Exact(exponent::independent(meter, &first)?),
        "hurwitz" => Real::Exact(zeros::hurwitz(meter, &first)?),
        _ => exponent::shown(library, function, &first)?,
    };
    let Real::Exact(value) = found else { return Err(ENCLOSED) };
    if matches!(function, "independent" | "hurwitz") {
        return Ok(value);
    }
    let rational = value.rational().ok_or(ENCLOSED)?;
    if function == "smoothness" && rational < int(0) {
        return Err(DIVERGES);
    }
    let since = family.integers.polynomial(vec![-int(family.integers.least), int(1)]);
    value.plus(1, &slope.times(&since)?)
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
