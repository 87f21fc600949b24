//! Refined polygons for pictures, in f64: points i at i/n^k, constant beyond the control points.

use crate::float::nearest;
use crate::limit::ExtremalPolygon;
use crate::scheme::{Mask, Rules};

/// From this factor on, the points of a later level are as good as limit points: where those of level k move
/// away by a shift of the parameter, what is left of it is this small a part.
const FINER: f64 = 256.0;

/// The most points that are computed of a level.
const MAX_POINTS: usize = 80_000;

/// The most points of a line: a picture is not wider.
const MAX_DRAWN: usize = 400;

/// A part of the parameters: from t − reach to t + reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// t.
    pub(super) t: f64,
    /// How far it reaches to both sides.
    pub(super) reach: f64,
}

impl Window {
    /// Its ends.
    pub(super) fn ends(self) -> (f64, f64) {
        (self.t - self.reach, self.t + self.reach)
    }
}

/// The points of a level: those of the indices from `first` on; beyond, the first and the last are
/// repeated.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// k.
    pub(super) k: u32,
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
        Level { k: 0, first: polygon.first, points: points.collect(), scale: 1.0 }
    }

    /// x_i.
    pub(super) fn point(&self, i: i64) -> f64 {
        let last = self.points.len().saturating_sub(1);
        let place = usize::try_from(i.saturating_sub(self.first)).unwrap_or(0).min(last);
        self.points.get(place).copied().unwrap_or(0.0)
    }

    /// The next level.
    fn refined(&self, rules: &Rules<f64>) -> Option<Level> {
        let [arity, width] = [rules.arity(), rules.width()].map(|n| i64::try_from(n).unwrap_or(0));
        let count = i64::try_from(self.points.len()).ok()?;
        // Beyond these indices, every rule sees one value only.
        let from = self.first - rules.offset() - width;
        let to = self.first + count - rules.offset();
        let one = |i: i64, row: &Vec<f64>| {
            (i + rules.offset()..).zip(row).map(|(at, weight)| weight * self.point(at)).sum()
        };
        let points = (from..=to).flat_map(|i| rules.rows().iter().map(move |row| one(i, row)));
        Some(Level {
            k: self.k + 1,
            first: from * arity,
            points: points.collect(),
            scale: self.scale * float(arity),
        })
    }

    /// Without the points on which nothing in the window depends. A point of the next level depends on those
    /// within `around` of its place, so that twice as many beyond the window are enough for all later levels:
    /// with n ≥ 2, n·(2a − a) ≥ 2a.
    fn trimmed(mut self, window: Window, around: i64) -> Level {
        let (from, to) = window.ends();
        let from = Level::index((from * self.scale).floor()) - 2 * around;
        let to = Level::index((to * self.scale).ceil()) + 2 * around;
        let last = self.points.len().saturating_sub(1);
        let place = |i: i64| usize::try_from(i - self.first).unwrap_or(0).min(last);
        let (from, to) = (place(from), place(to));
        self.points = self.points[from..=to].to_vec();
        self.first += i64::try_from(from).unwrap_or(0);
        self
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
        let count = usize::try_from(last - first + 1).unwrap_or(0);
        let step = count.div_ceil(MAX_DRAWN).max(1);
        let inner = (first..=last).step_by(step).map(|i| (self.parameter(i), self.point(i)));
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

/// The levels from 0 to one that stands for the limit of level `k` in a window; `None` where that takes too
/// many points.
pub(super) fn levels(
    mask: &Mask,
    polygon: &ExtremalPolygon,
    k: u32,
    window: Window,
) -> Option<Vec<Level>> {
    let rules = mask.rules().map(nearest);
    let around = i64::try_from(rules.width()).ok()? + rules.offset().abs() + 2;
    let mut levels = vec![Level::control(polygon)];
    loop {
        let last = levels.last()?;
        if last.points.len() > MAX_POINTS {
            return None;
        }
        let own = levels.get(usize::try_from(k).ok()?);
        if own.is_some_and(|own| last.scale >= FINER * own.scale) {
            return Some(levels);
        }
        levels.push(last.refined(&rules)?.trimmed(window, around));
    }
}
