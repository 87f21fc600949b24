//! The functions of the language whose values signs decide.

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions};
use super::polynomial::Polynomial;
use crate::numbers::{Q, int};
use crate::text::Stop;
use num_traits::One as _;

const NAMES: [&str; 8] = ["abs", "ceil", "floor", "kronecker", "max", "min", "mod", "sqrt"];

const FLOOR: Stop = Stop::Integers("an integer part is not shown to be the same for all");

/// Whether this is such a function.
pub fn has(name: &str) -> bool {
    NAMES.contains(&name)
}

/// The value of such a function.
pub fn value(functions: &Functions<'_>, name: &str, values: &[Function]) -> Result<Function, Stop> {
    match (name, values) {
        ("sqrt", [x]) => functions.square_root(x),
        ("abs", [x]) => absolute(functions, x),
        ("max" | "min", [first, rest @ ..]) => {
            rest.iter().try_fold(first.clone(), |best, x| extreme(functions, name, &best, x))
        }
        ("floor", [x]) => floor(functions, x),
        ("ceil", [x]) => functions.negated(&floor(functions, &functions.negated(x)?)?),
        ("mod", [x, m]) => {
            let whole = floor(functions, &functions.quotient(x, m)?)?;
            functions.sum(x, -1, &functions.product(m, &whole)?)
        }
        ("kronecker", [a, b]) => Ok(Function::int(i64::from(functions.compare(a, b)? == 0))),
        _ => Err(Stop::Wrong(format!("there is no `{name}` of {} arguments", values.len()))),
    }
}

/// |x|.
pub fn absolute(functions: &Functions<'_>, x: &Function) -> Result<Function, Stop> {
    if functions.sign(x)? < 0 { functions.negated(x) } else { Ok(x.clone()) }
}

/// The `max` or `min` of two values.
pub fn extreme(
    functions: &Functions<'_>,
    which: &str,
    one: &Function,
    other: &Function,
) -> Result<Function, Stop> {
    let sign = functions.compare(one, other)?;
    let first = if which == "max" { sign >= 0 } else { sign <= 0 };
    Ok(if first { one } else { other }.clone())
}

/// ⌊x⌋, if it is one integer.
fn floor(functions: &Functions<'_>, x: &Function) -> Result<Function, Stop> {
    let (low, high) = functions.first(x)?.ends();
    let (mut least, most) = (low.floor() - Q::one(), high.floor());
    if &most - &least > int(3) {
        return Err(FLOOR);
    }
    while least <= most {
        let k = Function::from(Polynomial::from(least.clone()));
        let above = functions.sum(&Function::int(1), 1, &k)?;
        // An integer that is not shown to be the one may be followed by one that is.
        let found = [functions.compare(x, &k), functions.compare(&above, x)];
        if let [Ok(0 | 1), Ok(1)] = found {
            return Ok(k);
        }
        functions.meter().spend(1)?;
        least += Q::one();
    }
    Err(FLOOR)
}
