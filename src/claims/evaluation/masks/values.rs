//! Values, integrals and inner products of limits of masks that are not rational.

use super::common::{MAX_PLACES, check_pair, not_shown};
use super::generic::Asked;
use crate::cap::Cap;
use crate::exact::{Rational, Real};
use crate::formula::CallError;
use crate::scheme::Mask;
use crate::smoothness::{
    LimitValues, Shape, Symbol, derivative_symbol, integral_symbol, is_contractive, is_shape_kept,
};
use std::fmt::Display;

/// The greatest number of residue classes of a contraction constant below 1.
const MAX_CLASSES: usize = 256;

/// φ^(m)(x): Σ_i (−1)^i binomial(m, i) ψ(x − i).
pub(super) struct ValueAt<'x> {
    pub(super) x: &'x Rational,
    pub(super) order: u32,
}

impl Asked for ValueAt<'_> {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let symbol = Symbol::of(converging(&masks[0])?);
        let derived = match self.order {
            0 => symbol,
            order => {
                let message = format!("limits have no continuous derivative of order {order}");
                let derived = derivative_symbol(&symbol, order);
                let derived = derived.ok_or(CallError::Undefined(message))?;
                is_continuous(&derived)?;
                derived
            }
        };
        let values = values(&derived)?;
        let mut sum = F::zero();
        // (−1)^i binomial(m, i)
        let mut factor = Rational::one();
        for i in 0..=self.order {
            let value = at(&values, &(self.x - Rational::from(i)))?;
            sum.accumulate(&value.times(&F::from_rational(&factor)));
            factor = factor * Rational::from(i64::from(i) - i64::from(self.order))
                / Rational::from(i + 1);
        }
        Ok(sum)
    }
}

/// 1 if all limits of data with a shape have it, else 0.
pub(super) struct Keeps {
    pub(super) shape: Shape,
}

impl Asked for Keeps {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let symbol = Symbol::of(converging(&masks[0])?);
        let kept = is_shape_kept(&symbol, &values(&symbol)?, self.shape);
        kept.map(|kept| F::from_rational(&Rational::from(i64::from(kept)))).ok_or_else(|| {
            let what = "the shape of limits is not decided: the number of coefficients";
            CallError::BeyondCap(Cap::new(what, 256))
        })
    }
}

/// ∫ φ from x to y: Σ_{j ≥ 0} (χ(y − j) − χ(x − j)).
pub(super) struct Integral<'x> {
    pub(super) ends: [&'x Rational; 2],
}

impl Asked for Integral<'_> {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let symbol = integral_symbol(&Symbol::of(converging(&masks[0])?));
        let (first, last) = symbol.support();
        let values = values(&symbol)?;
        let up_to = |end: &Rational| {
            // All of φ is before what is not less than the end of the support of χ less 1.
            if *end >= &last - Rational::one() {
                return Ok(F::from_rational(&Rational::one()));
            }
            let count = (end - &first).ceil().to_i64().unwrap_or(i64::MAX);
            if count > MAX_PLACES {
                let cap = Cap::new("the support of a limit", MAX_PLACES.unsigned_abs());
                return Err(CallError::BeyondCap(cap));
            }
            let mut terms = (0..count.max(0)).map(|j| at(&values, &(end - Rational::from(j))));
            terms.try_fold(F::zero(), |sum, term| Ok(sum.plus(&term?)))
        };
        Ok(up_to(self.ends[1])?.minus(&up_to(self.ends[0])?))
    }
}

/// ∫ φ(x) ψ(x − k) dx of one mask, or of two.
pub(super) struct InnerProduct {
    pub(super) k: Rational,
}

impl Asked for InnerProduct {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let (first, second) = (&masks[0], masks.last().unwrap_or(&masks[0]));
        check_pair(first, second)?;
        let symbols = [first, second].map(Symbol::of);
        for own in &symbols {
            // φ is in L² if the function of its inner products is continuous.
            is_continuous(&own.correlation(own))?;
        }
        let products = symbols[0].correlation(&symbols[1]);
        is_continuous(&products)?;
        at(&values(&products)?, &self.k)
    }
}

/// An error unless the scheme of the symbol is shown to converge.
fn is_continuous<F: Real + PartialEq + Display>(symbol: &Symbol<F>) -> Result<(), CallError> {
    let mask = symbol.mask().map_err(|_| not_shown())?;
    converging(&mask).map(|_| ())
}

fn converging<F: Real + PartialEq>(mask: &Mask<F>) -> Result<&Mask<F>, CallError> {
    if is_contractive(mask, MAX_CLASSES) { Ok(mask) } else { Err(not_shown()) }
}

fn values<F: Real + PartialEq>(symbol: &Symbol<F>) -> Result<LimitValues<F>, CallError> {
    LimitValues::new(symbol).ok_or_else(|| {
        let what = "the number of integers in the support of a limit, or of its values there,";
        CallError::BeyondCap(Cap::new(what, 64))
    })
}

fn at<F: Real + PartialEq>(values: &LimitValues<F>, x: &Rational) -> Result<F, CallError> {
    values.at(x).ok_or_else(|| {
        let what = "limits of irrational masks are computed at places i/n^k only, and the k";
        CallError::BeyondCap(Cap::new(what, 16))
    })
}
