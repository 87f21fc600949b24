//! One step of refinement of a sequence of numbers in f64, constant beyond its ends.

use crate::scheme::Rules;

/// A piece of a sequence: the numbers of the indices from `first` on.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) first: i64,
    pub(crate) points: Vec<f64>,
}

impl Line {
    /// x_i; beyond the piece the first or the last number.
    pub(crate) fn point(&self, i: i64) -> f64 {
        let last = self.points.len().saturating_sub(1);
        let place = usize::try_from(i.saturating_sub(self.first)).unwrap_or(0).min(last);
        self.points.get(place).copied().unwrap_or(0.0)
    }

    /// The next level; `None` where there are too many points to count.
    pub(crate) fn refined(&self, rules: &Rules<f64>) -> Option<Line> {
        let [arity, width] = [rules.arity(), rules.width()].map(|n| i64::try_from(n).unwrap_or(0));
        let count = i64::try_from(self.points.len()).ok()?;
        // Beyond these indices, every rule sees one value only.
        let from = self.first - rules.offset() - width;
        let to = self.first + count - rules.offset();
        let one = |i: i64, row: &Vec<f64>| {
            (i + rules.offset()..).zip(row).map(|(at, weight)| weight * self.point(at)).sum()
        };
        let points = (from..=to).flat_map(|i| rules.rows().iter().map(move |row| one(i, row)));
        Some(Line { first: from * arity, points: points.collect() })
    }

    /// The part between two indices, as far as it is there.
    pub(crate) fn part(mut self, from: i64, to: i64) -> Line {
        let last = self.points.len().saturating_sub(1);
        let place = |i: i64| usize::try_from(i - self.first).unwrap_or(0).min(last);
        let (from, to) = (place(from), place(to));
        self.points = self.points[from..=to].to_vec();
        self.first += i64::try_from(from).unwrap_or(0);
        self
    }
}

/// An integer as f64.
#[allow(clippy::cast_precision_loss, reason = "indices of a picture are small")]
pub(crate) fn float(i: i64) -> f64 {
    i as f64
}

/// The whole number at a place.
#[allow(clippy::cast_possible_truncation, reason = "a cast of a float saturates")]
pub(crate) fn index(place: f64) -> i64 {
    place.clamp(-1e15, 1e15) as i64
}
