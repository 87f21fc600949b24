//! Functions of a family of schemes: their values for all integers from one on (proofs/format/relation.md, Families).

#![warn(clippy::arithmetic_side_effects)]

mod cumulants;
mod limits;
mod orders;

use super::call::{Call, number};
use crate::numbers::{Meter, Value};
use crate::schemes::{Factor, Family};
use crate::text::Stop;

const FUNCTIONS: [&str; 9] = [
    "approximation_order",
    "arity",
    "generation",
    "reproduction",
    "sum_rules",
    "support",
    "support_end",
    "support_start",
    "symmetric",
];

const NOT_SYMMETRIC: Stop = Stop::Family("a factor is not symmetric");
const INDEXED: Stop = Stop::Family("the parameters of a reproduction are not the natural ones");
const LEAST: Stop = Stop::Family("the orders of sum rules and cumulants are greater in turn");

/// The value of such a function; `None` if the call is none, or its scheme depends on no index with all values.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    // The arity changes none of the names.
    let of_first = limits::known(call.function, 2).is_some();
    let known = call.arguments.is_empty() && (of_first || FUNCTIONS.contains(&call.function));
    if call.scope.every.is_none() || !known {
        return Ok(None);
    }
    let Some(family) = call.family()? else { return Ok(None) };
    let meter = call.library.meter;
    // The rules of all schemes sum to 1, whatever is asked.
    let orders = orders::sum_rules(meter, &family)?;
    Ok(Some(match call.function {
        "arity" => number(family.arity),
        "support_start" => place(meter, &family, |[low, _]| Some(low))?,
        "support_end" => place(meter, &family, |[_, high]| Some(high))?,
        "support" => place(meter, &family, |[low, high]| high.checked_sub(low))?,
        "sum_rules" => orders,
        "generation" => orders.minus(&Value::int(1))?,
        "approximation_order" => match call.choose("data", &["sampled", "adapted"])? {
            1 => orders,
            _ => reproduction(meter, &family, &orders)?.plus(1, &Value::int(1))?,
        },
        "reproduction" => {
            if call.choose("parameters", &["natural", "indexed"])? == 1 {
                return Err(INDEXED);
            }
            reproduction(meter, &family, &orders)?
        }
        "symmetric" => {
            let several = family.factors.iter().filter(|factor| factor.has_several());
            if !several.map(Factor::dense).all(|f| f.iter().eq(f.iter().rev())) {
                return Err(NOT_SYMMETRIC);
            }
            Value::int(1)
        }
        function => match limits::known(function, family.arity) {
            Some(known) => limits::of(call, &known, &family)?,
            None => return Ok(None),
        },
    }))
}

/// Checks that the schemes of a family exist: the sum rules make their rules sum to 1.
pub fn exist(meter: &Meter, family: &Family) -> Result<(), Stop> {
    orders::sum_rules(meter, family).map(|_| ())
}

/// A place in the mask, which is the sum of those in the factors, over n − 1.
fn place(
    meter: &Meter,
    family: &Family,
    of: impl Fn([i64; 2]) -> Option<i64>,
) -> Result<Value, Stop> {
    let mut sum = Value::int(0);
    for factor in &family.factors {
        let place = of(factor.ends()).ok_or(Stop::Capped("the powers of z in a symbol"))?;
        meter.spend(1)?;
        sum.add(1, &factor.exponent(&family.integers).times(&Value::int(place))?)?;
    }
    sum.over(&number(family.arity).minus(&Value::int(1))?)
}

/// The lesser one of the orders of sum rules and of the first cumulant that is not 0, less 1.
fn reproduction(meter: &Meter, family: &Family, orders: &Value) -> Result<Value, Stop> {
    let cumulant = number(cumulants::first(meter, family)?);
    let more = cumulant.minus(orders)?;
    let least = if family.integers.never_negative(meter, &more)? {
        orders
    } else if family.integers.never_negative(meter, &more.negated()?)? {
        &cumulant
    } else {
        return Err(LEAST);
    };
    least.minus(&Value::int(1))
}
