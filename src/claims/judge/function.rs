//! Judging a closed form in a free parameter.

use crate::claim::{Ends, FunctionClaim, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::parametric::FreeParameter;
use crate::exact::{Interval, IntervalSet, PiecewisePolynomial, Rational};
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
        let id = format!("{}:{}", paper.key, self.id);
        let (left, right) = match Diagnostic::or_cap(sides)? {
            Ok(sides) => sides,
            Err(cap) => {
                let verdict = FunctionVerdict::BeyondCap(cap);
                let (above, below) = (IntervalSet::default(), IntervalSet::default());
                return Ok(FunctionFinding { id, claim: self, verdict, above, below });
            }
        };
        let (above, below) = (left.exceeds(&right), right.exceeds(&left));
        let differs = above.union(&below).intersection(&self.domain.interval(Ends::Least));
        let printed = self.domain.interval(Ends::Printed);
        let verdict = match example(&left, &right, &differs) {
            None => FunctionVerdict::Holds,
            Some(example) => FunctionVerdict::Fails {
                larger: above.intersection(&printed),
                smaller: below.intersection(&printed),
                example: Box::new(example),
            },
        };
        Ok(FunctionFinding { id, claim: self, verdict, above, below })
    }
}

/// A place of a set at all of whose numbers two functions differ: of 0 and the breaks of their difference, the one
/// with the largest difference, and of several such places the first. If none of these is in the set, it is a point
/// between or beyond them. `None` if the set is empty: the functions are continuous, so that it is no single number.
fn example(
    left: &PiecewisePolynomial,
    right: &PiecewisePolynomial,
    differs: &IntervalSet,
) -> Option<Example> {
    let difference = left.minus(right);
    let mut points = vec![Rational::zero()];
    points.extend(difference.breakpoints().iter().map(|place| place.bounds().0));
    points.retain(|x| differs.contains(x));
    if points.is_empty() {
        points.extend(differs.intervals().iter().rev().filter_map(Interval::rational));
    }
    let size = |x: &Rational| difference.at(x).abs();
    let better = |best: Rational, x: Rational| if size(&x) > size(&best) { x } else { best };
    let at = points.into_iter().reduce(better)?;
    Some(Example { left: left.at(&at), right: right.at(&at), at })
}
