//! For which parameters the limits are C^m, from both sides.

use super::parametric::{ParametricSymbol, Reduced};
use super::range_error::SmoothRangeError;
use super::search::{Search, outer_ends};
use crate::bound::ParameterRange;
use crate::exact::{Interval, IntervalSet, Rational, RationalPolynomial};
use crate::joint::{Closing, MatrixSetError};
use crate::scheme::Rules;
use std::ops::Bound;

/// Where the limits are C^m.
#[derive(Clone, Debug)]
pub struct SmoothRange {
    /// For c = 1, 2, … the set where ‖(n^mS_{m+1})^c‖ < 1, as of [`ParameterRange`], and the scheme converges.
    pub contraction: ParameterRange,
    /// n^mS_{m+1} of these norms.
    pub differences: Rules<RationalPolynomial>,
    /// The polynomials g with which A was replaced by A(z)·g(z)/g(z^n), one after the other, since the shifts of the
    /// basic limit function are linearly dependent for all parameters.
    pub reduction: Vec<Vec<Rational>>,
    /// Where the scheme converges, if that does not follow from the symbol after this reduction.
    pub converges: Option<Box<SmoothRange>>,
    /// There all limits are C^m.
    pub inside: IntervalSet,
    /// There not all limits are C^m, or the scheme diverges.
    pub outside: IntervalSet,
    /// Whether finitely many parameters of `outside` may be exceptions: those where the shifts of the basic
    /// limit function are linearly dependent.
    pub but_finitely_many: bool,
    /// The length of what is in neither, rounded upwards; `None` where that is unbounded.
    pub gap: Option<Rational>,
    search: Search,
}

/// Where the limits of a mask in one parameter are C^m.
///
/// Inside by contraction, up to `levels` levels, and by hulls that are invariant on whole intervals: for
/// the matrices of which those of the interval are the mean (`proofs/THEOREMS.md`, 111). Outside where a
/// product of n^mS_K has the eigenvalue 1 or more in absolute value, by the sign of det(I ∓ P) (112). Where shifts are
/// linearly dependent for all parameters, all of this is about a reduced symbol (112 d).
///
/// # Errors
/// When the sum rules do not hold, or the work is beyond a cap.
///
/// # Panics
/// Never.
pub fn smooth_range(
    rules: &Rules<RationalPolynomial>,
    m: usize,
    levels: u32,
) -> Result<SmoothRange, SmoothRangeError> {
    let whole = ParametricSymbol::of(rules);
    let sure = m == 0 || whole.is_interpolating();
    let Reduced { symbol, steps, cycles } = whole.reduced(m);
    let scaled = symbol.scaled_differences(m, !steps.is_empty())?;
    let differences = scaled[m + 1].rules();
    let mut contraction = ParameterRange::new(&differences, levels)?;
    let mut search = Search::new(scaled.last().expect("the symbol itself").matrices())?;
    search.run(&contraction.union)?;
    let converges = cycles.then(|| smooth_range(rules, 0, levels)).transpose()?.map(Box::new);
    if let Some(converges) = &converges {
        for set in contraction.levels.iter_mut().chain([&mut contraction.union]) {
            *set = set.intersection(&converges.inside);
        }
    }
    let mut range = SmoothRange {
        inside: contraction.union.clone(),
        contraction,
        differences,
        reduction: steps,
        converges,
        outside: IntervalSet::default(),
        but_finitely_many: !sure,
        gap: None,
        search,
    };
    range.take();
    Ok(range)
}

impl SmoothRange {
    /// Looks closer at these values: adds to both sets what can be decided there, with intervals that are no
    /// wider than `width`. Of a set that is not bounded nothing is looked at beyond its finite ends.
    ///
    /// # Errors
    /// When the matrices of an interval are too many.
    ///
    /// ```
    /// use subcert::bound::polynomial_rules;
    /// use subcert::exact::{IntervalSet, Rational};
    /// use subcert::scheme::parse_parametric;
    /// use subcert::smoothness::smooth_range;
    ///
    /// // C^1 ends at 0.19272925…
    /// let mask = parse_parametric("four-point", "w")?;
    /// let rules = polynomial_rules(mask.rules(), "w")?;
    /// let mut range = smooth_range(&rules, 1, 2)?;
    /// let end = Rational::new(192_728, 1_000_000);
    /// assert!(!range.inside.contains(&end));
    /// let open = IntervalSet::everything().without(&range.inside).without(&range.outside);
    /// range.look_closer(&open, &Rational::new(1, 1_000_000))?;
    /// assert!(range.inside.contains(&end));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn look_closer(
        &mut self,
        values: &IntervalSet,
        width: &Rational,
    ) -> Result<(), MatrixSetError> {
        if let Some(converges) = &mut self.converges {
            converges.look_closer(values, width)?;
        }
        self.search.refresh();
        for (low, high) in values.intervals().iter().filter_map(outer_ends) {
            self.search.divide((low, high), &self.inside, (width, Closing::All))?;
        }
        self.take();
        Ok(())
    }

    /// Takes over what the search has found.
    fn take(&mut self) {
        let (mut inside, mut outside) = (self.search.inside.clone(), self.search.outside.clone());
        if let Some(converges) = &self.converges {
            inside = inside.intersection(&converges.inside);
            outside = outside.union(&converges.outside);
        }
        self.inside = self.inside.union(&inside);
        self.outside = self.outside.union(&outside);
        self.gap = gap(&self.inside.union(&self.outside));
    }
}

/// The length of the complement, if it is bounded.
pub(crate) fn gap(known: &IntervalSet) -> Option<Rational> {
    let intervals = known.intervals();
    let bounded = matches!(intervals.first()?.low, Bound::Unbounded)
        && matches!(intervals.last()?.high, Bound::Unbounded);
    if !bounded {
        return None;
    }
    let gaps = IntervalSet::everything().without(known);
    let length = |gap: &Interval| {
        let (low, high) = outer_ends(gap)?;
        Some(high - low)
    };
    gaps.intervals().iter().map(length).sum()
}
