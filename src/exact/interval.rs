//! Sets of real numbers that are unions of finitely many intervals.

use super::{Rational, RealAlgebraic};
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

    /// A rational number in the interval; `None` when it is one irrational number.
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

/// Whether one end is as far out as the other, where `beyond` compares their
/// places.
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

/// A union of intervals: sorted, disjoint, and no two of them make one, so that
/// equality is equality of sets.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct IntervalSet {
    intervals: Vec<Interval>,
}

impl From<Interval> for IntervalSet {
    fn from(interval: Interval) -> IntervalSet {
        IntervalSet { intervals: vec![interval] }
    }
}

impl IntervalSet {
    /// The union of those cells of the line that `keep` wants. The points
    /// p_1 < … < p_n cut the line into the 2n + 1 cells (−∞, p_1), {p_1},
    /// (p_1, p_2), …, (p_n, ∞), and `keep` has one entry for each, in this order.
    pub(super) fn of_cells(points: &[RealAlgebraic], keep: &[bool]) -> IntervalSet {
        debug_assert_eq!(keep.len(), 2 * points.len() + 1);
        let low = |cell: usize| match cell {
            0 => Bound::Unbounded,
            cell if cell % 2 == 1 => Bound::Included(points[cell / 2].clone()),
            cell => Bound::Excluded(points[cell / 2 - 1].clone()),
        };
        let high = |cell: usize| match points.get(cell / 2) {
            None => Bound::Unbounded,
            Some(point) if cell % 2 == 1 => Bound::Included(point.clone()),
            Some(point) => Bound::Excluded(point.clone()),
        };
        let mut intervals: Vec<Interval> = Vec::new();
        for (cell, _) in keep.iter().enumerate().filter(|(_, kept)| **kept) {
            match intervals.last_mut() {
                Some(run) if keep[cell - 1] => run.high = high(cell),
                _ => intervals.push(Interval { low: low(cell), high: high(cell) }),
            }
        }
        IntervalSet { intervals }
    }

    /// All real numbers.
    #[must_use]
    pub fn everything() -> IntervalSet {
        IntervalSet { intervals: vec![Interval { low: Bound::Unbounded, high: Bound::Unbounded }] }
    }

    /// The numbers in both sets.
    ///
    /// ```
    /// use subcert::exact::{PiecewisePolynomial, Rational};
    ///
    /// let x = PiecewisePolynomial::variable();
    /// let below = |bound| x.magnitude().below(&Rational::from(bound));
    /// assert_eq!(below(1).intersection(&below(2)), below(1));
    /// assert_eq!(below(1).union(&below(2)), below(2));
    /// ```
    #[must_use]
    pub fn intersection(&self, other: &IntervalSet) -> IntervalSet {
        self.combined(other, |left, right| left && right)
    }

    /// The numbers in one of the sets or in both.
    #[must_use]
    pub fn union(&self, other: &IntervalSet) -> IntervalSet {
        self.combined(other, |left, right| left || right)
    }

    fn combined(&self, other: &IntervalSet, keep: impl Fn(bool, bool) -> bool) -> IntervalSet {
        let mut points: Vec<RealAlgebraic> =
            self.ends().chain(other.ends()).map(|(place, _)| place.clone()).collect();
        points.sort();
        points.dedup();
        let (mine, theirs) = (self.cells(&points), other.cells(&points));
        let keep: Vec<bool> = mine.into_iter().zip(theirs).map(|(a, b)| keep(a, b)).collect();
        IntervalSet::of_cells(&points, &keep)
    }

    /// Rational bounds of the set, not in it; `None` when it is empty or unbounded, or
    /// an end of it is rational and belongs to it.
    #[must_use]
    pub fn hull(&self) -> Option<(Rational, Rational)> {
        let outside = |end: &Bound<RealAlgebraic>| match end {
            Bound::Unbounded => None,
            Bound::Included(place) if place.as_rational().is_some() => None,
            Bound::Included(place) | Bound::Excluded(place) => Some(place.bounds()),
        };
        let (low, high) = (self.intervals.first()?, self.intervals.last()?);
        Some((outside(&low.low)?.0, outside(&high.high)?.1))
    }

    /// The ends that are numbers, from left to right, and whether they belong to the
    /// set.
    pub fn ends(&self) -> impl Iterator<Item = (&RealAlgebraic, bool)> {
        let ends = self.intervals.iter().flat_map(|interval| [&interval.low, &interval.high]);
        ends.filter_map(|end| match end {
            Bound::Unbounded => None,
            Bound::Included(place) => Some((place, true)),
            Bound::Excluded(place) => Some((place, false)),
        })
    }

    /// Whether the cells between and at these points, which include all ends, are in
    /// the set; in the order of [`IntervalSet::of_cells`].
    fn cells(&self, points: &[RealAlgebraic]) -> Vec<bool> {
        let mut cells = vec![false; 2 * points.len() + 1];
        let place = |end: &RealAlgebraic| points.partition_point(|point| point < end);
        for interval in &self.intervals {
            let first = match &interval.low {
                Bound::Unbounded => 0,
                Bound::Included(low) => 2 * place(low) + 1,
                Bound::Excluded(low) => 2 * place(low) + 2,
            };
            let last = match &interval.high {
                Bound::Unbounded => 2 * points.len(),
                Bound::Included(high) => 2 * place(high) + 1,
                Bound::Excluded(high) => 2 * place(high),
            };
            cells[first..=last].fill(true);
        }
        cells
    }

    /// The intervals, from left to right.
    #[must_use]
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// Whether no number is in the set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.intervals.is_empty()
    }

    /// Whether `x` is in the set.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        self.intervals.iter().any(|interval| interval.contains(x))
    }

    /// Whether all of `interval` is in the set.
    #[must_use]
    pub fn covers(&self, interval: &Interval) -> bool {
        self.intervals.iter().any(|own| own.covers(interval))
    }

    /// The set as a condition on `variable`: `mu < 0 or mu = 1`; `no mu` when it is
    /// empty.
    #[must_use]
    pub fn describe(&self, variable: &str) -> String {
        if self.is_empty() {
            return format!("no {variable}");
        }
        let parts = self.intervals.iter().map(|interval| interval.describe(variable));
        parts.collect::<Vec<String>>().join(" or ")
    }
}

impl fmt::Display for IntervalSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts: Vec<String> = self.intervals.iter().map(Interval::to_string).collect();
        f.write_str(if parts.is_empty() { "{}" } else { "" })?;
        f.write_str(&parts.join(" u "))
    }
}
