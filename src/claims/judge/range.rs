//! Judging a range of a free parameter.

use crate::claim::{Limit, Paper, Printed, RangeClaim, is_rounded};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::parametric::FreeParameter;
use crate::exact::{
    Enclosed, Interval, IntervalSet, PiecewisePolynomial, Rational, RealAlgebraic, Rounding,
};
use crate::finding::{Direction, EndFinding, EndRelation, FoundRange, RangeFinding, RangeVerdict};
use crate::formula::{Parameters, evaluate};
use crate::judge::kind::JudgeAlone;
use std::ops::Bound;

impl<'a> JudgeAlone<'a> for RangeClaim {
    type Finding = RangeFinding<'a>;

    /// Judges a range against the exact set where the value keeps its limit.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<RangeFinding<'a>, Diagnostic> {
        let free = FreeParameter::new(paper, library, &self.variable, self.scheme.as_ref())?;
        let formula = self.limit.formula();
        let limit = evaluate(&formula.expr, &Parameters::<Rational>::default());
        let limit = limit.map_err(|error| formula.diagnostic(&error));
        let sides = Diagnostic::or_cap(Diagnostic::both(free.function(&self.value), limit))?;
        let found = sides.map(|(function, limit)| compare(self, &function, limit));
        Ok(RangeFinding { id: format!("{}:{}", paper.key, self.id), claim: self, found })
    }
}

fn compare(claim: &RangeClaim, function: &PiecewisePolynomial, limit: Rational) -> FoundRange {
    let below = function.below(&limit);
    let above = function.exceeds(&PiecewisePolynomial::constant(limit.clone()));
    let exact = match &claim.limit {
        Limit::Below(_) => below.clone(),
        Limit::AtMost(_) => function.at_most(&limit),
    };
    let comparison = Comparison { claim, function, exact: &exact };
    let sides = [(Side::Low, claim.from.as_ref()), (Side::High, claim.to.as_ref())];
    let ends = sides.map(|(side, printed)| printed.map(|printed| comparison.end(side, printed)));
    let verdict = comparison.verdict(&ends);
    let kept = exact.covers(&comparison.printed(&ends));
    let ends = ends.into_iter().flatten().collect();
    FoundRange { verdict, limit, exact, below, above, ends, kept }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Low,
    High,
}

impl Side {
    fn of(self, interval: &Interval) -> &Bound<RealAlgebraic> {
        match self {
            Side::Low => &interval.low,
            Side::High => &interval.high,
        }
    }
}

struct Comparison<'a> {
    claim: &'a RangeClaim,
    function: &'a PiecewisePolynomial,
    exact: &'a IntervalSet,
}

impl Comparison<'_> {
    fn end(&self, side: Side, printed: &Printed) -> EndFinding {
        let decimal = &printed.decimal;
        let at = decimal.value();
        let ends = self.exact.intervals().iter().map(|interval| side.of(interval));
        let nearest = ends
            .filter_map(|end| match end {
                Bound::Unbounded => None,
                Bound::Included(place) => Some((place, true)),
                Bound::Excluded(place) => Some((place, false)),
            })
            .min_by_key(|(place, _)| (&at - place.enclosure(1).lower()).abs());
        let inside = self.exact.contains(&at);
        let relation = nearest.map_or(EndRelation::Apart, |(exact, belongs)| {
            match decimal.rounding_of_algebraic(exact) {
                Rounding::Exact if self.claim.closed.is_none_or(|closed| closed == belongs) => {
                    EndRelation::Equal
                }
                Rounding::Exact => EndRelation::Belonging,
                Rounding::Nearest | Rounding::Cut | Rounding::Up if !is_rounded(decimal) => {
                    EndRelation::FewDigits
                }
                Rounding::Nearest => EndRelation::Nearest,
                Rounding::Cut => EndRelation::Rounded(Direction::Cut),
                Rounding::Up => EndRelation::Rounded(Direction::Away),
                Rounding::Neither => {
                    let outwards = match side {
                        Side::Low => &at - decimal.unit(),
                        Side::High => &at + decimal.unit(),
                    };
                    // If the paper says that the range is open, its end has to be the exact end
                    // itself.
                    let last = inside && exact.as_rational() == Some(&outwards) && !belongs;
                    if last && self.claim.closed != Some(false) {
                        EndRelation::LastInside
                    } else {
                        EndRelation::Apart
                    }
                }
            }
        });
        EndFinding {
            printed: printed.text.clone(),
            exact: nearest.map(|(place, _)| place.clone()),
            relation,
            inside,
            value: self.function.at(&at),
        }
    }

    fn verdict(&self, ends: &[Option<EndFinding>; 2]) -> RangeVerdict {
        let [exact] = self.exact.intervals() else { return RangeVerdict::Inexact };
        // Between ends in the wrong order there is nothing, however near they are to the exact ones.
        if let (Some(from), Some(to)) = (&self.claim.from, &self.claim.to)
            && from.decimal.value() > to.decimal.value()
        {
            return RangeVerdict::Inexact;
        }
        let mut verdict = RangeVerdict::Exact;
        for (side, end) in [Side::Low, Side::High].into_iter().zip(ends) {
            let Some(end) = end else {
                if *side.of(exact) != Bound::Unbounded {
                    return RangeVerdict::Inexact;
                }
                continue;
            };
            match end.relation {
                EndRelation::Equal => {}
                EndRelation::Belonging | EndRelation::FewDigits | EndRelation::Apart => {
                    return RangeVerdict::Inexact;
                }
                EndRelation::Nearest | EndRelation::Rounded(_) | EndRelation::LastInside => {
                    verdict = RangeVerdict::Rounding;
                }
            }
        }
        verdict
    }

    /// The range as printed. Where the paper does not say whether an end belongs to it, an end that
    /// equals the exact one belongs to it if the exact one belongs to the exact set, and any other
    /// end belongs to it.
    fn printed(&self, ends: &[Option<EndFinding>; 2]) -> Interval {
        let [low, high] = ends;
        let place = |printed: &Option<Printed>, end: &Option<EndFinding>| {
            let (Some(printed), Some(end)) = (printed, end) else { return Bound::Unbounded };
            let belongs =
                self.claim.closed.unwrap_or(end.inside || end.relation != EndRelation::Equal);
            let place = printed.decimal.value().into();
            if belongs { Bound::Included(place) } else { Bound::Excluded(place) }
        };
        Interval { low: place(&self.claim.from, low), high: place(&self.claim.to, high) }
    }
}
