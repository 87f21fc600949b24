//! Sets of real numbers that are unions of finitely many intervals.

use crate::exact::{Interval, Rational, RealAlgebraic};
use std::fmt;
use std::ops::Bound;

/// A union of intervals. They are sorted and disjoint, and the union of two of them is
/// never an interval. So derived equality is equality of sets.
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
    /// The union of the cells of the real line that `keep` marks. The points p_1 < … <
    /// p_n cut the line into the 2n + 1 cells (−∞, p_1), {p_1}, (p_1, p_2), …, (p_n, ∞),
    /// and `keep` has one entry for each, in this order.
    ///
    /// # Panics
    /// When there are not 2n + 1 entries.
    #[must_use]
    pub fn of_cells(points: &[RealAlgebraic], keep: &[bool]) -> IntervalSet {
        assert_eq!(keep.len(), 2 * points.len() + 1);
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

    /// The numbers in at least one of the two sets.
    #[must_use]
    pub fn union(&self, other: &IntervalSet) -> IntervalSet {
        self.combined(other, |left, right| left || right)
    }

    /// The numbers in this set that are not in the other one.
    ///
    /// ```
    /// use subcert::exact::{IntervalSet, PiecewisePolynomial, Rational};
    ///
    /// let positive = IntervalSet::everything()
    ///     .without(&PiecewisePolynomial::variable().at_most(&Rational::zero()));
    /// assert!(positive.contains(&Rational::new(1, 9)) && !positive.contains(&Rational::zero()));
    /// ```
    #[must_use]
    pub fn without(&self, other: &IntervalSet) -> IntervalSet {
        self.combined(other, |left, right| left && !right)
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

    /// A rational lower and a rational upper bound of the set, neither of them in the
    /// set. `None` when the set is empty or unbounded, or when its least or greatest
    /// element exists and is rational.
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

    /// The finite ends of the intervals, from left to right, and whether each belongs to
    /// the set.
    pub fn ends(&self) -> impl Iterator<Item = (&RealAlgebraic, bool)> {
        let ends = self.intervals.iter().flat_map(|interval| [&interval.low, &interval.high]);
        ends.filter_map(|end| match end {
            Bound::Unbounded => None,
            Bound::Included(place) => Some((place, true)),
            Bound::Excluded(place) => Some((place, false)),
        })
    }

    /// For each cell that `points` cut the line into, whether it is in the set, in the
    /// order of [`IntervalSet::of_cells`]. The points must include all finite ends of the
    /// set.
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
