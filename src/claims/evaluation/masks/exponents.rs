//! Bounds of the smoothness of limits that hold on a whole interval of a parameter.

use super::common::{converted, not_shown};
use crate::exact::{QuotientAt, Rational, RationalPolynomial, Scalar as _};
use crate::formula::CallError;
use crate::scheme::Mask;
use crate::smoothness::{
    Symbol, derivative_symbol, independence_conditions, is_contractive, is_independent,
};

/// The greatest number of residue classes of a contraction that is looked for on an interval of a parameter.
pub(crate) const MAX_CLASSES: usize = 16;

/// An end of what is known of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Lower,
    Upper,
}

/// Whether the shifts of φ are linearly independent, for a mask at a place of a parameter.
///
/// # Errors
/// When it is not decided.
pub(super) fn is_independent_at(mask: &Mask<QuotientAt>) -> Result<bool, CallError> {
    let symbol = Symbol::of(mask);
    let coefficients = symbol.coefficients();
    let polynomials = coefficients.iter().map(|c| c.as_polynomial().cloned());
    let polynomials: Option<Vec<RationalPolynomial>> = polynomials.collect();
    let conditions = polynomials.and_then(|all| independence_conditions(&all, mask.arity()));
    let place = coefficients.iter().find(|c| c.as_constant().is_none());
    let holds = |condition: &RationalPolynomial| {
        place.map_or(!condition.is_zero(), |place| place.with(condition).sign() != 0)
    };
    if conditions.is_some_and(|conditions| conditions.iter().all(holds)) {
        return Ok(true);
    }
    // At a single rational number all values are numbers.
    let one = QuotientAt::from_rational(&Rational::one());
    let number = |c: &QuotientAt| c.times(&one).as_constant();
    let mask = converted(mask, number).ok_or_else(not_shown)?;
    Ok(is_independent(&Symbol::of(&mask)))
}

/// An end of what is known of `smoothness` or `hoelder` on all of the interval for which a place stands.
///
/// With independent shifts and K sum rules not all limits are C^K, and the exponent is at most K. If the m-th derived scheme converges, all limits are C^m.
/// A scheme that diverges has the order −1, and no exponent.
///
/// # Errors
/// When nothing is known.
pub(super) fn bound_at(
    mask: &Mask<QuotientAt>,
    function: &str,
    end: End,
) -> Result<QuotientAt, CallError> {
    let symbol = Symbol::of(mask);
    let of_exponent = function == "hoelder";
    if of_exponent && !is_contractive(mask, MAX_CLASSES) {
        return Err(not_shown());
    }
    let rules = symbol.sum_rules().0;
    let bound = match end {
        // No upper bound is known.
        End::Upper if !keeps_points(&symbol) && !is_independent_at(mask)? => {
            return Err(not_shown());
        }
        End::Upper => Rational::from(rules) - Rational::from(i64::from(!of_exponent)),
        End::Lower => {
            let converges = |m: &u32| {
                let derived = derivative_symbol(&symbol, *m).map(|derived| derived.mask());
                derived
                    .is_some_and(|mask| mask.is_ok_and(|mask| is_contractive(&mask, MAX_CLASSES)))
            };
            let orders = 0..u32::try_from(rules).unwrap_or(0);
            match orders.rev().find(converges) {
                Some(order) => Rational::from(i64::from(order)),
                None => Rational::from(-1),
            }
        }
    };
    Ok(QuotientAt::from_rational(&bound))
}

/// Whether one rule has one coefficient. Then the points that it makes are points of the level before, and if the scheme converges, the shifts of φ are
/// linearly independent: all but one vanish at a place.
fn keeps_points(symbol: &Symbol<QuotientAt>) -> bool {
    let (n, zero) = (symbol.arity(), QuotientAt::zero());
    (0..n).any(|e| {
        let rule = symbol.coefficients().iter().skip(e).step_by(n);
        rule.filter(|c| **c != zero).count() == 1
    })
}
