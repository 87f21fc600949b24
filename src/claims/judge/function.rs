//! Judging a closed form in a free parameter.

use crate::claim::{FunctionClaim, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::parametric::FreeParameter;
use crate::exact::{Interval, PiecewisePolynomial, Rational};
use crate::finding::{Example, FunctionFinding, FunctionVerdict};
use crate::judge::kind::JudgeAlone;

impl<'a> JudgeAlone<'a> for FunctionClaim {
    type Finding = FunctionFinding<'a>;

    /// Judges a closed form: both sides as piecewise polynomial functions, in normal form.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<FunctionFinding<'a>, Diagnostic> {
        let free = FreeParameter::new(paper, library, &self.variable, self.scheme.as_ref())?;
        let sides = Diagnostic::both(free.function(&self.left), free.function(&self.right));
        let verdict = match Diagnostic::or_cap(sides)? {
            Err(cap) => FunctionVerdict::BeyondCap(cap),
            Ok((left, right)) if left == right => FunctionVerdict::Holds,
            Ok((left, right)) => FunctionVerdict::Fails {
                larger: left.exceeds(&right),
                smaller: right.exceeds(&left),
                example: Box::new(example(&left, &right)),
            },
        };
        Ok(FunctionFinding { id: format!("{}:{}", paper.key, self.id), claim: self, verdict })
    }
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
