//! Comparing a printed range with the sets where limits are C^m, and where not.

use crate::claim::{Ends, SmoothRangeStatement};
use crate::diagnostic::Diagnostic;
use crate::exact::{Interval, IntervalSet, Rational};
use crate::finding::SmoothnessVerdict;

/// The greatest denominator of the simple values that are tried.
const MAX_DENOMINATOR: i64 = 1_000;

/// Where the limits are C^m, and where not.
pub(super) struct Sides {
    pub(super) inside: IntervalSet,
    pub(super) outside: IntervalSet,
    /// Whether finitely many values outside may be exceptions.
    pub(super) but_finitely_many: bool,
}

/// What a value shows: whether the limits are C^m there, and what is known of them; `None` where it
/// is not decided.
pub(super) type Counterexample<W> = Option<(bool, W)>;

/// A printed range and what is known of it.
pub(super) struct Trial<'t, W> {
    pub(super) statement: &'t SmoothRangeStatement,
    /// `None` where the limits are C^m at single values at most.
    pub(super) sides: Option<Sides>,
    /// What a single value shows.
    pub(super) at: &'t dyn Fn(&Rational) -> Result<Counterexample<W>, Diagnostic>,
}

/// The verdict on a range.
pub(super) struct Judged<W> {
    pub(super) verdict: SmoothnessVerdict,
    /// The values that decide nothing, at which nothing is proved either.
    pub(super) undecided: IntervalSet,
    /// A value that refutes the range, whether it is in it, and what is known of the limits there.
    pub(super) witness: Option<(Rational, bool, W)>,
}

/// A number of an interval with a small denominator, if there is one.
fn simple(interval: &Interval) -> Option<Rational> {
    let any = interval.rational()?;
    let near = (1..=MAX_DENOMINATOR).find_map(|d| {
        let d = Rational::from(d);
        let below = Rational::from((&any * &d).floor());
        let ends = [&below / &d, (below + Rational::one()) / &d];
        ends.into_iter().find(|x| interval.contains(x))
    });
    near.or(Some(any))
}

impl<W> Trial<'_, W> {
    /// Judges the range.
    pub(super) fn judged(&self) -> Result<Judged<W>, Diagnostic> {
        let whole = self.statement.domain.interval(Ends::Printed);
        let undecided = self.undecided(&whole, &whole);
        let right = self.witness(&whole, &whole)?.is_none() && !self.excludes(&whole);
        let (witness, verdict) = if right && undecided.is_empty() {
            (None, SmoothnessVerdict::Confirmed)
        } else {
            let [less, more] =
                [Ends::Least, Ends::Most].map(|ends| self.statement.domain.interval(ends));
            match self.witness(&less, &more)? {
                Some(witness) => (Some(witness), SmoothnessVerdict::Refuted),
                None if self.excludes(&less) => (None, SmoothnessVerdict::Refuted),
                None if self.undecided(&less, &more).is_empty() => {
                    (None, SmoothnessVerdict::RoundedEnds)
                }
                None => (None, SmoothnessVerdict::Open),
            }
        };
        Ok(Judged { verdict, undecided: undecided.without(&self.known()), witness })
    }

    /// The values at which it is proved that limits are C^m, or that not all are.
    fn known(&self) -> IntervalSet {
        match &self.sides {
            None => IntervalSet::default(),
            Some(sets) if sets.but_finitely_many => sets.inside.clone(),
            Some(sets) => sets.inside.union(&sets.outside),
        }
    }

    /// The values that decide nothing: those of `inner` at which C^m is not proved; and, if the paper says
    /// that there are no others, those beyond `outer` at which it is not refuted.
    pub(super) fn undecided(&self, inner: &IntervalSet, outer: &IntervalSet) -> IntervalSet {
        let beyond = IntervalSet::everything().without(outer);
        let Some(sets) = &self.sides else { return inner.clone() };
        let open = inner.without(&sets.inside);
        if !self.statement.only {
            return open;
        }
        // With exceptions, of which there are finitely many, nothing is sure outside.
        let refuted = if sets.but_finitely_many { &IntervalSet::default() } else { &sets.outside };
        open.union(&beyond.without(refuted))
    }

    /// Whether a value of the range is certainly excluded.
    fn excludes(&self, range: &IntervalSet) -> bool {
        self.sides.as_ref().is_some_and(|sets| {
            !sets.but_finitely_many && !range.intersection(&sets.outside).is_empty()
        })
    }

    /// A rational value of `inner` at which not all limits are C^m; or, if the paper says that there are no
    /// others, one beyond `outer` at which they are.
    fn witness(
        &self,
        inner: &IntervalSet,
        outer: &IntervalSet,
    ) -> Result<Option<(Rational, bool, W)>, Diagnostic> {
        let everything = IntervalSet::everything();
        let failing = match &self.sides {
            Some(sets) => inner.intersection(&sets.outside),
            None => inner.clone(),
        };
        if let Some(witness) = self.first(&failing, true)? {
            return Ok(Some(witness));
        }
        match &self.sides {
            Some(sets) if self.statement.only => {
                self.first(&everything.without(outer).intersection(&sets.inside), false)
            }
            _ => Ok(None),
        }
    }

    /// The first interval of these with a rational value that decides as expected.
    fn first(
        &self,
        set: &IntervalSet,
        inside: bool,
    ) -> Result<Option<(Rational, bool, W)>, Diagnostic> {
        // At an end, where something changes, a proof takes longest.
        let tried = set.intervals().iter().flat_map(|one| [one.interior(), one.clone()]);
        for at in tried.filter_map(|one| simple(&one)) {
            if let Some((smooth, known)) = (self.at)(&at)?
                && smooth != inside
            {
                return Ok(Some((at, inside, known)));
            }
        }
        Ok(None)
    }
}
