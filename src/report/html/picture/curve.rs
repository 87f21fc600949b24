//! Refined polygons for pictures, in f64: points i at i/n^k, constant beyond the control points.

use crate::float::nearest;
use crate::limit::ExtremalPolygon;
use crate::scheme::{Mask, Rules};

/// From this many points on, a polygon looks like its limit.
const MANY: usize = 1_200;

/// The most points that are kept of a level.
const MAX_POINTS: usize = 60_000;

/// The points of a level: those of the indices from `first` on; beyond, the first and the last are
/// repeated.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// k.
    pub(super) level: u32,
    first: i64,
    points: Vec<f64>,
    /// n^k.
    scale: f64,
}

impl Level {
    /// The control polygon.
    pub(super) fn control(polygon: &ExtremalPolygon) -> Level {
        let points = polygon.points.iter().map(|point| {
            // Control data are small integers.
            f64::from(i32::try_from(*point).unwrap_or(i32::MAX))
        });
        Level { level: 0, first: polygon.first, points: points.collect(), scale: 1.0 }
    }

    /// x_i.
    pub(super) fn point(&self, i: i64) -> f64 {
        let last = self.points.len().saturating_sub(1);
        let place = usize::try_from(i.saturating_sub(self.first)).unwrap_or(0).min(last);
        self.points.get(place).copied().unwrap_or(0.0)
    }

    /// The next level; `None` when it has too many points.
    fn refined(&self, rules: &Rules<f64>) -> Option<Level> {
        let [arity, width] = [rules.arity(), rules.width()].map(|n| i64::try_from(n).unwrap_or(0));
        let count = i64::try_from(self.points.len()).ok()?;
        // Beyond these indices, every rule sees one value only.
        let from = self.first - rules.offset() - width;
        let to = self.first + count - rules.offset();
        if usize::try_from((to - from + 1) * arity).ok()? > MAX_POINTS {
            return None;
        }
        let one = |i: i64, row: &Vec<f64>| {
            (i + rules.offset()..).zip(row).map(|(at, weight)| weight * self.point(at)).sum()
        };
        let points = (from..=to).flat_map(|i| rules.rows().iter().map(move |row| one(i, row)));
        Some(Level {
            level: self.level + 1,
            first: from * arity,
            points: points.collect(),
            scale: self.scale * float(arity),
        })
    }

    /// The value at t of the polygon with x_i at i/n^k.
    pub(super) fn at(&self, t: f64) -> f64 {
        let place = t * self.scale;
        let whole = place.floor();
        let part = place - whole;
        let i = Level::index(whole);
        (1.0 - part) * self.point(i) + part * self.point(i + 1)
    }

    /// Where x_i is.
    pub(super) fn parameter(&self, i: i64) -> f64 {
        float(i) / self.scale
    }

    /// The polygon between two parameters.
    pub(super) fn between(&self, (from, to): (f64, f64)) -> Vec<(f64, f64)> {
        let (first, last) = (
            Level::index((from * self.scale).floor()) + 1,
            Level::index((to * self.scale).ceil()) - 1,
        );
        let inner = (first..=last).map(|i| (self.parameter(i), self.point(i)));
        std::iter::once((from, self.at(from))).chain(inner).chain([(to, self.at(to))]).collect()
    }

    #[allow(clippy::cast_possible_truncation, reason = "a cast of a float saturates")]
    fn index(place: f64) -> i64 {
        place.clamp(-1e15, 1e15) as i64
    }
}

#[allow(clippy::cast_precision_loss, reason = "indices of a picture are small")]
fn float(i: i64) -> f64 {
    i as f64
}

/// The levels from 0 to one that looks like the limit, which is after `least` at least; `None` where
/// that takes too many points.
pub(super) fn levels(mask: &Mask, polygon: &ExtremalPolygon, least: u32) -> Option<Vec<Level>> {
    let rules = mask.rules().map(nearest);
    let mut levels = vec![Level::control(polygon)];
    while levels.last()?.level < least || levels.last()?.points.len() < MANY {
        levels.push(levels.last()?.refined(&rules)?);
    }
    Some(levels)
}
