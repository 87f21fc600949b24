//! Comparisons with the smoothness of limits, of which bounds are known on an interval of a parameter.

use crate::claim::{Comparison, Sign};
use crate::diagnostic::Diagnostic;
use crate::evaluation::masks::End;
use crate::evaluation::shape::Coefficients;
use crate::exact::{QuotientAt, Scalar as _};
use crate::formula::{Call, CallError, Context, Functions, LocatedFormula, Node};
use std::cmp::Ordering;

/// The functions of which bounds are known.
const BOUNDED: [&str; 2] = ["smoothness", "hoelder"];

/// The functions of a relation, with this end of what is known of a bounded one.
pub(super) struct Bounded<'a> {
    pub(super) coefficients: &'a Coefficients<'a, QuotientAt>,
    pub(super) end: End,
}

impl Functions<QuotientAt> for Bounded<'_> {
    fn call(
        &self,
        call: &Call<'_, QuotientAt>,
        context: &dyn Context<QuotientAt>,
    ) -> Result<QuotientAt, CallError> {
        if BOUNDED.contains(&call.function) {
            return self.coefficients.end(call, self.end, context);
        }
        self.coefficients.call(call, context)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.coefficients.is_scheme(function, name)
    }
}

/// Whether a side is nothing but a call of such a function: what is computed with one may not grow with it.
pub(super) fn is_bounded(formula: &LocatedFormula) -> bool {
    matches!(&formula.expr.node, Node::Call { function, .. } if BOUNDED.contains(&&function[..]))
}

/// Whether bounds of a side may decide a comparison.
pub(super) fn has_bounds(comparison: &Comparison) -> bool {
    let sign = comparison.sign;
    let compares = sign.is_order() || matches!(sign, Sign::Equal | Sign::Unequal);
    compares && [comparison.left.formula(0), comparison.right()].into_iter().any(is_bounded)
}

/// Whether a comparison is true, by the ends of what is known of its sides; `None` where they do not decide it.
///
/// # Errors
/// When a side has no value. An end that is beyond a cap is not needed where the other one decides.
pub(super) fn decided(
    comparison: &Comparison,
    end: impl Fn(&LocatedFormula, End) -> Result<QuotientAt, Diagnostic>,
) -> Result<Option<bool>, Diagnostic> {
    let (left, right) = (comparison.left.formula(0), comparison.right());
    let sign = |of_left, of_right| {
        Diagnostic::or_cap(
            end(left, of_left)
                .and_then(|left| Ok(left.minus(&end(right, of_right)?).sign().cmp(&0))),
        )
    };
    let agreed = |possible: &[Ordering]| {
        let mut all = possible.iter().map(|order| comparison.sign.fits(*order));
        let first = all.next()?;
        all.all(|other| other == first).then_some(first)
    };
    let all = [Ordering::Less, Ordering::Equal, Ordering::Greater];
    // To find a lower bound of smoothness takes longer.
    let greatest = sign(End::Upper, End::Lower)?.unwrap_or(Ordering::Greater);
    let upper: Vec<Ordering> = all.into_iter().filter(|order| *order <= greatest).collect();
    if let Some(truth) = agreed(&upper) {
        return Ok(Some(truth));
    }
    let least = sign(End::Lower, End::Upper)?.unwrap_or(Ordering::Less);
    let both: Vec<Ordering> = upper.into_iter().filter(|order| *order >= least).collect();
    Ok(agreed(&both))
}
