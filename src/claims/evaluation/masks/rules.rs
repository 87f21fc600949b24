//! Functions that read only the coefficients of the rules of a mask.

use super::{KnownLimits, of_mask};
use crate::bound::{Recursion, convolution_coefficient, sequence};
use crate::evaluation::arguments::{index, narrow, place, within};
use crate::evaluation::functions::{QUANTITIES, name_of};
use crate::evaluation::options::Options;
use crate::exact::Rational;
use crate::formula::{Call, CallError, Value};
use crate::scheme::{Mask, Rules};
use std::borrow::Borrow;

/// The value of a function that reads only coefficients.
pub(crate) fn shape<V: Value + PartialEq, R: Borrow<Rules<V>>>(
    mask: &Mask<V>,
    difference: impl FnOnce() -> R,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    (other, known): (impl Fn(&str) -> Result<Mask<V>, CallError>, &KnownLimits),
) -> Result<V, CallError> {
    let number = |value: usize| V::from_rational(&Rational::from(value));
    match (call.function, call.arguments) {
        ("mask", [rule, column]) => coefficient(mask.rules(), rule, column),
        ("difference", [rule, column]) => coefficient(difference().borrow(), rule, column),
        ("convolution", [c, l, f]) => {
            let (order, recursion) = (options.order()?, options.recursion()?);
            let most = match recursion {
                Recursion::Derived => MAX_CONVOLUTIONS,
                Recursion::Printed => MAX_PRINTED_CONVOLUTIONS,
            };
            let c = within("the number of convolutions", c, 1..=most)?;
            let (l, f) = (place("the index l", l)?, index("the index f", f)?);
            let t = sequence(difference().borrow(), order);
            Ok(convolution_coefficient(&t, mask.arity(), narrow(c), l, f, recursion))
        }
        ("arity", []) => Ok(number(mask.arity())),
        ("width", []) => Ok(number(mask.width())),
        _ => of_mask(mask, call, options, other, known)?.ok_or_else(|| usage(call)),
    }
}

/// The error of a call that has not the form of its function.
pub(crate) fn usage<V>(call: &Call<'_, V>) -> CallError {
    let (name, count) = (call.function, call.arguments.len());
    let usage = QUANTITIES.iter().find(|(usage, _)| name_of(usage) == name);
    let usage = usage.map_or(name, |(usage, _)| usage);
    CallError::Misuse(format!(
        "`{name}` cannot be used so with {count} arguments; its form is {usage}"
    ))
}

/// The greatest number of convolutions whose coefficients are summed term by term.
const MAX_CONVOLUTIONS: i64 = 4;

/// The same cap for the printed recursion, which has far more terms.
const MAX_PRINTED_CONVOLUTIONS: i64 = 3;

fn coefficient<V: Value>(rules: &Rules<V>, rule: &V, column: &V) -> Result<V, CallError> {
    let (rule, column) = (index("the index of a rule", rule)?, index("a column", column)?);
    let row = usize::try_from(rule).ok().and_then(|rule| rules.rows().get(rule));
    let row = row.ok_or_else(|| {
        let last = rules.arity() - 1;
        CallError::Misuse(format!("there is no rule {rule}; the rules are 0 to {last}"))
    })?;
    let entry = usize::try_from(column).ok().and_then(|column| row.get(column));
    Ok(entry.cloned().unwrap_or_else(V::zero))
}
