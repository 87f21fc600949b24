//! Refined polygons for pictures, in f64: point i at (i + s)/n^k, constant beyond the control points.

use crate::float::nearest;
use crate::report::html::picture::plane::line::{Line, float, index};
use crate::scheme::{Mask, Rules};

/// From this factor on, the points of a later level are as good as limit points: where those of level k move
/// away by a shift of the parameter, what is left of it is this small a part.
pub(super) const FINER: f64 = 256.0;

/// The most points that are computed of a level.
const MAX_POINTS: usize = 80_000;

/// The most points of a line: a picture is not wider.
const MAX_DRAWN: usize = 400;

/// How many points beyond the ends, which have the values of these, are shown.
const BEYOND: i64 = 8;
const BEYOND_COUNT: usize = 8;

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

/// The points of a level.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// k.
    pub(super) k: u32,
    line: Line,
    /// n^k.
    scale: f64,
    /// Point i is at (i + s)/n^k with this s.
    shift: f64,
}

impl Level {
    /// The control polygon.
    pub(super) fn control(line: Line, shift: f64) -> Level {
        Level { k: 0, line, scale: 1.0, shift }
    }

    /// x_i.
    pub(super) fn point(&self, i: i64) -> f64 {
        self.line.point(i)
    }

    /// The next level.
    fn refined(&self, rules: &Rules<f64>) -> Option<Level> {
        let arity = float(i64::try_from(rules.arity()).ok()?);
        let line = self.line.refined(rules)?;
        Some(Level { k: self.k + 1, line, scale: self.scale * arity, shift: self.shift })
    }

    /// Without the points on which nothing in the window depends. A point of the next level depends on those
    /// within `around` of its place, so that twice as many beyond the window are enough for all later levels:
    /// with n ≥ 2, n·(2a − a) ≥ 2a.
    fn trimmed(mut self, window: Window, around: i64) -> Level {
        let (from, to) = window.ends();
        let from = index((from * self.scale).floor()) - 2 * around;
        let to = index((to * self.scale).ceil()) + 2 * around;
        self.line = self.line.part(from, to);
        self
    }

    /// The value at t of the polygon with x_i at i/n^k.
    pub(super) fn at(&self, t: f64) -> f64 {
        let place = t * self.scale - self.shift;
        let whole = place.floor();
        let part = place - whole;
        let i = index(whole);
        (1.0 - part) * self.point(i) + part * self.point(i + 1)
    }

    /// Where x_i is.
    pub(super) fn parameter(&self, i: i64) -> f64 {
        (float(i) + self.shift) / self.scale
    }

    /// The points between two parameters, as far as they are there.
    pub(super) fn vertices(&self, (from, to): (f64, f64)) -> impl Iterator<Item = (f64, f64)> {
        let indices = (self.line.first - BEYOND..).take(self.line.points.len() + 2 * BEYOND_COUNT);
        let all = indices.map(|i| (self.parameter(i), self.point(i)));
        all.filter(move |(t, _)| (from..=to).contains(t))
    }

    /// The polygon between two parameters.
    pub(super) fn between(&self, (from, to): (f64, f64)) -> Vec<(f64, f64)> {
        let (first, last) = (
            index((from * self.scale - self.shift).floor()) + 1,
            index((to * self.scale - self.shift).ceil()) - 1,
        );
        let count = usize::try_from(last - first + 1).unwrap_or(0);
        let step = count.div_ceil(MAX_DRAWN).max(1);
        let inner = (first..=last).step_by(step).map(|i| (self.parameter(i), self.point(i)));
        std::iter::once((from, self.at(from))).chain(inner).chain([(to, self.at(to))]).collect()
    }
}

/// The levels from 0 to one that stands for the limit of level `k` in a window, `finer` times as fine; `None` where
/// that takes too many points.
pub(super) fn levels(
    mask: &Mask,
    control: Level,
    (k, finer): (u32, f64),
    window: Window,
) -> Option<Vec<Level>> {
    let rules = mask.rules().map(nearest);
    // The shift moves the window.
    let moved = index(control.shift.abs().ceil());
    let around = i64::try_from(rules.width()).ok()? + rules.offset().abs() + 2 + moved;
    let mut levels = vec![control];
    loop {
        let last = levels.last()?;
        if last.line.points.len() > MAX_POINTS {
            return None;
        }
        let own = levels.get(usize::try_from(k).ok()?);
        if own.is_some_and(|own| last.scale >= finer * own.scale) {
            return Some(levels);
        }
        levels.push(last.refined(&rules)?.trimmed(window, around));
    }
}
