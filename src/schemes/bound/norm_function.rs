//! The norm of a power of an operator as a function of a parameter.

use super::parametric_rows::{RangeError, Row, distinct_rows};
use super::power::Order;
use crate::exact::{PiecewisePolynomial, Rational, RationalPolynomial};
use crate::scheme::Rules;

/// ‖Rᶜ‖_∞ as a function of the parameter.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`](super::MAX_RANGE_WORK).
pub fn norm_function(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
) -> Result<PiecewisePolynomial, RangeError> {
    let rows = distinct_rows([rules], levels, order)?;
    Ok(greatest(rows.iter().map(|[row]| row.function(None)).collect(), None))
}

/// A function that equals ‖Rᶜ‖_∞ on the interval `window`. For a short interval it takes
/// less work than [`norm_function`].
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`](super::MAX_RANGE_WORK).
pub fn norm_function_on(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
    window: &(Rational, Rational),
) -> Result<PiecewisePolynomial, RangeError> {
    let rows = distinct_rows([rules], levels, order)?;
    Ok(greatest(rows.iter().map(|[row]| row.function(Some(window))).collect(), Some(window)))
}

/// A function that equals the value of [`joint_norm`](super::joint_norm) on the interval
/// `window`.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`](super::MAX_RANGE_WORK).
///
/// # Panics
/// When arity or width differ.
pub fn joint_norm_function_on(
    rules: [&Rules<RationalPolynomial>; 2],
    levels: u32,
    order: Order,
    window: &(Rational, Rational),
) -> Result<PiecewisePolynomial, RangeError> {
    let [first, second] = rules;
    assert_eq!(first.arity(), second.arity(), "joint suprema need equal arities");
    assert_eq!(first.width(), second.width(), "joint suprema need equal widths");
    let rows = distinct_rows([first, second], levels, order)?;
    let product = |[first, second]: &[Row; 2]| {
        first.function(Some(window)).times(&second.function(Some(window)))
    };
    Ok(greatest(rows.iter().map(product).collect(), Some(window)))
}

/// The pointwise maximum of the functions; with a window, only on this interval.
fn greatest(
    mut functions: Vec<PiecewisePolynomial>,
    window: Option<&(Rational, Rational)>,
) -> PiecewisePolynomial {
    if let Some((low, high)) = window {
        let middle = (low + high) / Rational::from(2);
        let champion = functions.iter().max_by_key(|function| function.at(&middle)).cloned();
        // Functions that are below the champion on the whole interval are left out.
        let below = |function: &PiecewisePolynomial| match (&champion, function.pieces()) {
            (Some(champion), [piece]) if champion.piece_count() == 1 => {
                let ahead = champion.pieces()[0].minus(piece);
                ahead.sign_at(low) > 0 && !ahead.numerator().may_vanish_between(low, high)
            }
            _ => false,
        };
        functions.retain(|function| !below(function));
        functions.sort_by_cached_key(PiecewisePolynomial::to_string);
        functions.dedup();
    }
    // In pairs, so that functions of similar size are compared.
    while functions.len() > 1 {
        let greater = |pair: &[PiecewisePolynomial]| match pair {
            [first, second] => first.greater(second),
            _ => pair[0].clone(),
        };
        functions = functions.chunks(2).map(greater).collect();
    }
    functions.pop().unwrap_or_else(|| PiecewisePolynomial::constant(Rational::zero()))
}
