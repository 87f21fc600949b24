//! Bounds of the smoothness of limits that hold on a whole interval of a parameter.

use super::common::not_shown;
use super::generic::Asked;
use crate::exact::{Rational, Real};
use crate::formula::CallError;
use crate::scheme::Mask;
use crate::smoothness::{Symbol, derivative_symbol, is_contractive, is_independent};
use std::fmt::Display;

/// The greatest number of residue classes of a contraction that is looked for on an interval of a parameter.
pub(crate) const MAX_CLASSES: usize = 16;

/// 1 if the shifts of φ are linearly independent, else 0.
pub(super) struct Independent;

impl Asked for Independent {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let independent = is_independent(&Symbol::of(&masks[0]));
        Ok(F::from_rational(&Rational::from(i64::from(independent))))
    }
}

/// An end of what is known of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Lower,
    Upper,
}

/// A bound of the order of continuity, or of the Hölder exponent.
pub(super) struct SmoothnessBound {
    pub(super) of_exponent: bool,
    pub(super) end: End,
}

impl Asked for SmoothnessBound {
    /// With independent shifts and K sum rules not all limits are C^K, and the exponent is at most K. If the m-th derived scheme converges, all limits
    /// are C^m. A scheme that diverges has the order −1, and no exponent.
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let symbol = Symbol::of(&masks[0]);
        if self.of_exponent && !is_contractive(&masks[0], MAX_CLASSES) {
            return Err(not_shown());
        }
        let rules = symbol.sum_rules().0;
        let bound = match self.end {
            // No upper bound is known.
            End::Upper if !keeps_points(&symbol) && !is_independent(&symbol) => {
                return Err(not_shown());
            }
            End::Upper => Rational::from(rules) - Rational::from(i64::from(!self.of_exponent)),
            End::Lower => {
                let converges = |m: &u32| {
                    let derived = derivative_symbol(&symbol, *m).map(|derived| derived.mask());
                    derived.is_some_and(|mask| {
                        mask.is_ok_and(|mask| is_contractive(&mask, MAX_CLASSES))
                    })
                };
                let orders = 0..u32::try_from(rules).unwrap_or(0);
                match orders.rev().find(converges) {
                    Some(order) => Rational::from(i64::from(order)),
                    None => Rational::from(-1),
                }
            }
        };
        Ok(F::from_rational(&bound))
    }
}

/// Whether one rule has one coefficient. Then the points that it makes are points of the level before, and if the scheme converges, the shifts of φ are
/// linearly independent: all but one vanish at a place.
fn keeps_points<F: Real + PartialEq>(symbol: &Symbol<F>) -> bool {
    let (n, zero) = (symbol.arity(), F::zero());
    (0..n).any(|e| {
        let rule = symbol.coefficients().iter().skip(e).step_by(n);
        rule.filter(|c| **c != zero).count() == 1
    })
}
