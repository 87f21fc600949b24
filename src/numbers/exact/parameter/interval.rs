//! Intervals of real numbers.

use crate::exact::{Rational, RealAlgebraic};
use std::fmt;
use std::ops::Bound;

/// An interval of real numbers with algebraic or infinite ends; not empty.
///
/// ```
/// use std::ops::Bound;
/// use subcert::exact::{Interval, Rational};
///
/// let interval = Interval {
///     low: Bound::Excluded(Rational::new(1, 6).into()),
///     high: Bound::Included(Rational::new(2, 3).into()),
/// };
/// assert_eq!(interval.to_string(), "(1/6, 2/3]");
/// assert_eq!(interval.describe("mu"), "1/6 < mu <= 2/3");
/// assert!(interval.contains(&Rational::new(2, 3)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The lower end.
    pub low: Bound<RealAlgebraic>,
    /// The upper end.
    pub high: Bound<RealAlgebraic>,
}

impl Interval {
    /// Without its ends; a single number as it is.
    #[must_use]
    pub fn interior(&self) -> Interval {
        let open = |end: &Bound<RealAlgebraic>| match end {
            Bound::Included(end) | Bound::Excluded(end) => Bound::Excluded(end.clone()),
            Bound::Unbounded => Bound::Unbounded,
        };
        if self.low != Bound::Unbounded && self.low == self.high {
            return self.clone();
        }
        Interval { low: open(&self.low), high: open(&self.high) }
    }

    /// Whether `x` is in the interval.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        let above = match &self.low {
            Bound::Unbounded => true,
            Bound::Included(low) => low.cmp_rational(x).is_le(),
            Bound::Excluded(low) => low.cmp_rational(x).is_lt(),
        };
        above
            && match &self.high {
                Bound::Unbounded => true,
                Bound::Included(high) => high.cmp_rational(x).is_ge(),
                Bound::Excluded(high) => high.cmp_rational(x).is_gt(),
            }
    }

    /// A rational number in the interval; `None` when the interval is a single irrational
    /// number.
    ///
    /// ```
    /// use subcert::exact::{PiecewisePolynomial, Rational};
    ///
    /// let x = PiecewisePolynomial::variable();
    /// let set = x.times(&x).below(&Rational::from(2));
    /// assert_eq!(set.intervals()[0].rational(), Some(Rational::zero()));
    /// ```
    #[must_use]
    pub fn rational(&self) -> Option<Rational> {
        let one = Rational::one();
        match (&self.low, &self.high) {
            (Bound::Unbounded, Bound::Unbounded) => Some(Rational::zero()),
            (Bound::Unbounded, Bound::Included(high) | Bound::Excluded(high)) => {
                Some(high.bounds().0 - one)
            }
            (Bound::Included(low) | Bound::Excluded(low), Bound::Unbounded) => {
                Some(low.bounds().1 + one)
            }
            (
                Bound::Included(low) | Bound::Excluded(low),
                Bound::Included(high) | Bound::Excluded(high),
            ) if low < high => Some(low.rational_below(high)),
            (Bound::Included(low) | Bound::Excluded(low), _) => low.as_rational().cloned(),
        }
    }

    /// Whether all of `other` is in the interval.
    #[must_use]
    pub fn covers(&self, other: &Interval) -> bool {
        reaches(&self.low, &other.low, |outer, inner| outer < inner)
            && reaches(&self.high, &other.high, |outer, inner| outer > inner)
    }

    /// The interval as a condition on `variable`: `1/6 < mu < 2/3`, `mu >= 1`,
    /// `mu = 0`, `every mu`.
    #[must_use]
    pub fn describe(&self, variable: &str) -> String {
        match (&self.low, &self.high) {
            (Bound::Unbounded, Bound::Unbounded) => format!("every {variable}"),
            (Bound::Included(low), Bound::Included(high)) if low == high => {
                format!("{variable} = {low}")
            }
            (Bound::Included(low), Bound::Unbounded) => format!("{variable} >= {low}"),
            (Bound::Excluded(low), Bound::Unbounded) => format!("{variable} > {low}"),
            (low, high) => {
                let low = match low {
                    Bound::Unbounded => String::new(),
                    Bound::Included(low) => format!("{low} <= "),
                    Bound::Excluded(low) => format!("{low} < "),
                };
                let high = match high {
                    Bound::Unbounded => String::new(),
                    Bound::Included(high) => format!(" <= {high}"),
                    Bound::Excluded(high) => format!(" < {high}"),
                };
                format!("{low}{variable}{high}")
            }
        }
    }
}

/// Whether the end `outer` lies at least as far out as the end `inner`. `beyond(a, b)`
/// says whether a lies strictly farther out than b.
fn reaches(
    outer: &Bound<RealAlgebraic>,
    inner: &Bound<RealAlgebraic>,
    beyond: impl Fn(&RealAlgebraic, &RealAlgebraic) -> bool,
) -> bool {
    match (outer, inner) {
        (Bound::Unbounded, _) => true,
        (_, Bound::Unbounded) => false,
        (Bound::Excluded(a), Bound::Included(b)) => beyond(a, b),
        (Bound::Included(a) | Bound::Excluded(a), Bound::Included(b) | Bound::Excluded(b)) => {
            a == b || beyond(a, b)
        }
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.low {
            Bound::Unbounded => f.write_str("(-inf, ")?,
            Bound::Included(low) => write!(f, "[{low}, ")?,
            Bound::Excluded(low) => write!(f, "({low}, ")?,
        }
        match &self.high {
            Bound::Unbounded => f.write_str("inf)"),
            Bound::Included(high) => write!(f, "{high}]"),
            Bound::Excluded(high) => write!(f, "{high})"),
        }
    }
}
