//! For which parameters the limits are C^m, from both sides.

use super::parametric::{ParametricSymbol, PolynomialMatrix};
use super::search::{Search, outer_ends};
use crate::bound::{ParameterRange, RangeError};
use crate::exact::{Interval, IntervalSet, Rational, RationalPolynomial};
use crate::joint::{Closing, MatrixSetError};
use crate::scheme::Rules;
use std::ops::Bound;

/// Why there is no range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SmoothRangeError {
    /// C^m needs sum rules of a higher order than hold for all parameters.
    #[error(
        "C^{m} needs sum rules of order {needed}, and those of order {found} hold for all parameters, but no \
         more: on no interval are the limits C^{m}"
    )]
    SumRules {
        /// m.
        m: usize,
        /// m + 1.
        needed: usize,
        /// The order that holds.
        found: usize,
    },
    /// As [`SmoothRangeError::SumRules`], where sum rules do not decide.
    #[error(
        "sum rules of order {found} hold for all parameters, but no more; integer shifts of the basic limit function may \
         be linearly dependent, so that limits may be C^{m} all the same, and masks with a parameter are not reduced"
    )]
    Dependent {
        /// m.
        m: usize,
        /// The order that holds.
        found: usize,
    },
    /// The rules are too long.
    #[error("the rules are too long for a proof of smoothness: {0}")]
    TooLong(#[from] MatrixSetError),
    /// The contraction is beyond a cap.
    #[error(transparent)]
    Range(#[from] RangeError),
}

impl SmoothRangeError {
    /// What it means that C^m needs sum rules of a higher order than `found`.
    pub(super) fn without_rules(m: usize, found: usize, independent: bool) -> SmoothRangeError {
        if independent {
            SmoothRangeError::SumRules { m, needed: m.saturating_add(1), found }
        } else {
            SmoothRangeError::Dependent { m, found }
        }
    }
}

/// Where the limits are C^m.
#[derive(Clone, Debug)]
pub struct SmoothRange {
    /// For c = 1, 2, … the set where ‖(n^mS_{m+1})^c‖ < 1, as of [`ParameterRange`].
    pub contraction: ParameterRange,
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
    /// Whether what the search finds outside is outside.
    refutes: bool,
}

/// Where the limits of a mask in one parameter are C^m.
///
/// Inside by contraction, up to `levels` levels, and by hulls that are invariant on whole intervals: for
/// the matrices of which those of the interval are the mean (`proofs/THEOREMS.md`, 111). Outside where a
/// product of n^mS_K has the eigenvalue 1 or more in absolute value, by the sign of det(I ∓ P) (112).
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
    let (whole, matrices) = scaled_matrices(rules, m)?;
    let n = Rational::from(whole.arity());
    let factor = (0..m).fold(Rational::one(), |power, _| power * &n);
    let derived = (0..=m).try_fold(whole.clone(), |symbol, _| symbol.over_sigma());
    let derived = derived.expect("sum rules of this order").scaled(&factor);
    let contraction = ParameterRange::new(&derived.rules(), levels)?;
    let mut search = Search::new(matrices)?;
    search.run(&contraction.union)?;
    let sure = m == 0 || whole.is_interpolating();
    let refutes = sure || is_independent(&whole);
    let (inside, outside) = (contraction.union.clone(), IntervalSet::default());
    let but_finitely_many = !sure;
    let mut range =
        SmoothRange { contraction, inside, outside, but_finitely_many, gap: None, search, refutes };
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
        self.search.refresh();
        for (low, high) in values.intervals().iter().filter_map(outer_ends) {
            self.search.divide((low, high), &self.inside, (width, Closing::All))?;
        }
        self.take();
        Ok(())
    }

    /// Takes over what the search has found.
    fn take(&mut self) {
        self.inside = self.inside.union(&self.search.inside);
        if self.refutes {
            self.outside = self.outside.union(&self.search.outside);
        }
        self.gap = gap(&self.inside.union(&self.outside));
    }
}

/// The symbol, and the matrices of n^mB_K for its order K of the sum rules.
fn scaled_matrices(
    rules: &Rules<RationalPolynomial>,
    m: usize,
) -> Result<(ParametricSymbol, Vec<PolynomialMatrix>), SmoothRangeError> {
    let whole = ParametricSymbol::of(rules);
    let orders = std::iter::successors(Some(whole.clone()), ParametricSymbol::over_sigma);
    let (found, last) = orders.enumerate().last().expect("the symbol itself");
    if found <= m {
        return Err(SmoothRangeError::without_rules(m, found, is_independent(&whole)));
    }
    let n = Rational::from(whole.arity());
    let factor = (0..m).fold(Rational::one(), |power, _| power * &n);
    Ok((whole, last.scaled(&factor).matrices()))
}

/// Whether the shifts are linearly independent for all but finitely many values.
fn is_independent(symbol: &ParametricSymbol) -> bool {
    symbol.is_independent(|c, [value, _]| c.value_at(value))
}

/// The length of the complement, if it is bounded.
fn gap(known: &IntervalSet) -> Option<Rational> {
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
