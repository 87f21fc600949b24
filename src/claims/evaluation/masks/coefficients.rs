//! Functions of masks that read only coefficients, and compare them.

use super::{IRRATIONAL, at_place, check_size, numbers};
use crate::evaluation::arguments::{narrow, within};
use crate::evaluation::options::{Data, Options, Parameters};
use crate::exact::{Rational, Scalar};
use crate::facts::{centre, is_interpolating};
use crate::formula::{Call, CallError, FormulaErrorKind, Value};
use crate::scheme::Mask;
use crate::smoothness::{Symbol, moments, reproduction_degree, reproduction_degree_at};

/// The greatest m of a moment.
const MAX_MOMENT: i64 = 64;

/// What is asked of a mask.
enum Asked<V> {
    Support,
    SupportStart,
    SupportEnd,
    Symmetric,
    Interpolating,
    SumRules,
    Generation,
    Reproduction(Parameters),
    ApproximationOrder(Data),
    Moment(u32),
    /// Whether it is dual to another mask, or to itself.
    Dual(Option<Mask<V>>),
}

/// What a call asks; `None` if it is about no such function of so many arguments.
fn asked<V: Value>(
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    other: impl FnOnce(&str) -> Result<Mask<V>, CallError>,
) -> Result<Option<Asked<V>>, CallError> {
    Ok(Some(match (call.function, call.arguments) {
        ("support", []) => Asked::Support,
        ("support_start", []) => Asked::SupportStart,
        ("support_end", []) => Asked::SupportEnd,
        ("symmetric", []) => Asked::Symmetric,
        ("interpolating", []) => Asked::Interpolating,
        ("sum_rules", []) => Asked::SumRules,
        ("generation", []) => Asked::Generation,
        ("reproduction", []) => Asked::Reproduction(options.parameters()?),
        ("approximation_order", []) => Asked::ApproximationOrder(options.data()?),
        ("moment", [m]) => {
            Asked::Moment(narrow(within("the order of a moment", m, 0..=MAX_MOMENT)?))
        }
        ("orthogonal", []) => Asked::Dual(None),
        ("biorthogonal", []) => match options.take("with") {
            Some(name) => Asked::Dual(Some(other(&name)?)),
            None => {
                let message = "name the other scheme: `biorthogonal(with = NAME)`";
                return Err(CallError::Misuse(message.to_owned()));
            }
        },
        _ => return Ok(None),
    }))
}

/// The value of a function that compares coefficients; `None` if there is no such function of so many arguments.
pub(super) fn of_coefficients<V: Value + PartialEq>(
    mask: &Mask<V>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    other: impl FnOnce(&str) -> Result<Mask<V>, CallError>,
) -> Result<Option<V>, CallError> {
    let Some(asked) = asked(call, options, other)? else { return Ok(None) };
    let unsupported = || CallError::Inner(FormulaErrorKind::Unsupported(IRRATIONAL));
    let found = match at_place(mask) {
        Some(mask) => {
            let of = |other: &Mask<V>| at_place(other).ok_or_else(unsupported);
            V::of_place(value(&asked, &mask, of)?)
        }
        None => V::of_number(&value(&asked, &numbers(mask)?, numbers)?),
    };
    found.map(Some).ok_or_else(unsupported)
}

fn value<V, F: Scalar + PartialEq>(
    asked: &Asked<V>,
    mask: &Mask<F>,
    of: impl Fn(&Mask<V>) -> Result<Mask<F>, CallError>,
) -> Result<F, CallError> {
    let number = |value: Rational| F::from_rational(&value);
    let truth = |holds: bool| number(Rational::from(i64::from(holds)));
    let count = |count: usize| number(Rational::from(count));
    let degree = |parameters: Parameters| match parameters {
        Parameters::Natural => reproduction_degree(mask),
        Parameters::Indexed => reproduction_degree_at(mask, &F::zero()),
    };
    let symbol = Symbol::of(mask);
    Ok(match asked {
        Asked::Support => {
            let (first, last) = symbol.support();
            number(last - first)
        }
        Asked::SupportStart => number(symbol.support().0),
        Asked::SupportEnd => number(symbol.support().1),
        Asked::Symmetric => truth(centre(&symbol).is_some()),
        Asked::Interpolating => truth(is_interpolating(mask)),
        Asked::SumRules | Asked::ApproximationOrder(Data::Adapted) => count(symbol.sum_rules().0),
        // The rules sum to 1, so that the order is 1 at least.
        Asked::Generation => count(symbol.sum_rules().0 - 1),
        Asked::Reproduction(parameters) => count(degree(*parameters)),
        Asked::ApproximationOrder(Data::Sampled) => count(degree(Parameters::Natural) + 1),
        Asked::Moment(m) => moments(&symbol, *m).pop().unwrap_or_else(F::zero),
        Asked::Dual(other) => {
            let other = other.as_ref().map(of).transpose()?;
            truth(are_dual(&symbol, mask, other.as_ref().unwrap_or(mask))?)
        }
    })
}

fn are_dual<F: Scalar + PartialEq>(
    symbol: &Symbol<F>,
    first: &Mask<F>,
    second: &Mask<F>,
) -> Result<bool, CallError> {
    if first.arity() != second.arity() {
        let message = format!("the arities differ: {} and {}", first.arity(), second.arity());
        return Err(CallError::Misuse(message));
    }
    check_size(first, second)?;
    Ok(symbol.is_dual_to(&Symbol::of(second)))
}
