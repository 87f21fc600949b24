//! Judging a closed form in a free parameter.

use crate::claim::{FunctionClaim, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::parametric::FreeParameter;
use crate::exact::{Interval, PiecewisePolynomial, Rational};
use crate::finding::{Example, FunctionFinding, FunctionVerdict};

/// Judges a closed form: both sides as piecewise polynomial functions, in normal form.
pub(crate) fn judge<'a>(
    paper: &Paper,
    claim: &'a FunctionClaim,
    library: &Library<'_>,
) -> Result<FunctionFinding<'a>, Diagnostic> {
    let free = FreeParameter::new(paper, library, &claim.variable, claim.scheme.as_ref())?;
    let sides = Diagnostic::both(free.function(&claim.left), free.function(&claim.right));
    let verdict = match Diagnostic::or_cap(sides)? {
        Err(cap) => FunctionVerdict::BeyondCap(cap),
        Ok((left, right)) if left == right => FunctionVerdict::Holds,
        Ok((left, right)) => FunctionVerdict::Fails {
            larger: left.exceeds(&right),
            smaller: right.exceeds(&left),
            example: Box::new(example(&left, &right)),
        },
    };
    Ok(FunctionFinding { id: format!("{}:{}", paper.key, claim.id), claim, verdict })
}

/// A place where two different functions differ: of 0 and the breaks of their difference, the one
/// with the largest difference, and of several such places the first. If the functions are equal at
/// all of these, it is a point between or beyond them.
fn example(left: &PiecewisePolynomial, right: &PiecewisePolynomial) -> Example {
    let difference = left.minus(right);
    let mut points = vec![Rational::zero()];
    points.extend(difference.breakpoints().iter().map(|place| place.bounds().0));
    let size = |x: &Rational| difference.at(x).abs();
    if points.iter().all(|x| size(x).is_zero()) {
        let differs = left.differs(right);
        points.extend(differs.intervals().iter().rev().filter_map(Interval::rational));
    }
    let better = |best: Rational, x: Rational| if size(&x) > size(&best) { x } else { best };
    let at = points.into_iter().reduce(better).expect("0 is one of them");
    Example { left: left.at(&at), right: right.at(&at), at }
}
