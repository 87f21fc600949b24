//! Sets of real numbers that are unions of finitely many intervals.

use super::Rational;
use std::fmt;
use std::ops::Bound;

/// An interval of real numbers with rational or infinite ends; not empty.
///
/// ```
/// use std::ops::Bound;
/// use subcert::exact::{Interval, Rational};
///
/// let interval = Interval {
///     low: Bound::Excluded(Rational::new(1, 6)),
///     high: Bound::Included(Rational::new(2, 3)),
/// };
/// assert_eq!(interval.to_string(), "(1/6, 2/3]");
/// assert_eq!(interval.describe("mu"), "1/6 < mu <= 2/3");
/// assert!(interval.contains(&Rational::new(2, 3)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The lower end.
    pub low: Bound<Rational>,
    /// The upper end.
    pub high: Bound<Rational>,
}

impl Interval {
    /// Whether `x` is in the interval.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        let above = match &self.low {
            Bound::Unbounded => true,
            Bound::Included(low) => low <= x,
            Bound::Excluded(low) => low < x,
        };
        above
            && match &self.high {
                Bound::Unbounded => true,
                Bound::Included(high) => x <= high,
                Bound::Excluded(high) => x < high,
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
    outer: &Bound<Rational>,
    inner: &Bound<Rational>,
    beyond: impl Fn(&Rational, &Rational) -> bool,
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

impl IntervalSet {
    /// The union of those cells of the line that `keep` wants. The points
    /// p_1 < … < p_n cut the line into the 2n + 1 cells (−∞, p_1), {p_1},
    /// (p_1, p_2), …, (p_n, ∞), and `keep` has one entry for each, in this order.
    pub(super) fn of_cells(points: &[Rational], keep: &[bool]) -> IntervalSet {
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
