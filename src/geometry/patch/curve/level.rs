//! One level: whether its polygon and the curve are within the tolerance (`proofs/THEOREMS.md`, 165).

use super::super::geometric::{Nearness, SetKind};
use super::cells::Name;
use super::find::{Answer, Finder, Set, between, distance};
use std::collections::BTreeSet;

/// How many levels beyond that of the polygon the curve is divided.
const MORE_LEVELS: u32 = 26;

/// Pieces that are smaller than this share of the tolerance are not divided.
const SMALL: f64 = 1e-4;

/// How many cells of a level are tried at a few points first.
const MAX_TRIED: usize = 400;

/// How many levels more a piece of the curve beside a segment is divided.
const MORE_PIECES: u32 = 6;

/// The most cells of a level that equal parameters leave open.
const MAX_OPEN: usize = 1 << 18;

/// What is known of a level.
pub(super) type CurveNearness = Nearness<FarPoint>;

/// A point that is far from the other set.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FarPoint {
    pub(super) from: SetKind,
    pub(super) point: Vec<f64>,
    /// A point of the curve is at i/n^m, with (m, i) here; one of the polygon so far from point i of level m to the next.
    pub(super) at: Name,
    pub(super) share: f64,
    /// A lower bound of the distance.
    pub(super) distance: f64,
}

/// The search on one level.
pub(super) struct LevelSearch<'a> {
    pub(super) finder: &'a mut Finder,
    pub(super) level: u32,
    /// At most the tolerance.
    pub(super) tolerance: f64,
}

impl LevelSearch<'_> {
    pub(super) fn examine(&mut self) -> CurveNearness {
        let (cells, all) = self.left();
        let mut result = CurveNearness::Near;
        let mut met = BTreeSet::new();
        // What is far shows in a few points, most often.
        let tried = cells.len().min(MAX_TRIED);
        for &name in &cells[..tried] {
            if let Some(far) = self.far_point(name) {
                return CurveNearness::Far(far);
            }
        }
        if !all {
            return CurveNearness::Open;
        }
        for &name in &cells {
            for part in [SetKind::Limit, SetKind::Mesh] {
                let known = match part {
                    SetKind::Limit => self.curve(name, &mut met),
                    SetKind::Mesh => self.segment(name),
                };
                match known {
                    CurveNearness::Near => {}
                    CurveNearness::Open => result = CurveNearness::Open,
                    far @ CurveNearness::Far(_) => return far,
                }
            }
            if self.finder.is_at_its_end() {
                return CurveNearness::Open;
            }
        }
        result
    }

    /// A point of the segment of a cell of the level that is surely far from the curve, if one of a few is.
    fn far_point(&mut self, name: Name) -> Option<FarPoint> {
        let cell = self.finder.cells.cell(name);
        let [u, v] = self.finder.chord(&cell);
        for share in [0.0, 0.5] {
            let point = between(&u, &v, share);
            if self.is_beyond(Set::Curve, &point, self.tolerance, name) {
                return Some(self.far(SetKind::Mesh, point, name, cell.place(share), name));
            }
        }
        let next: Vec<Name> = self.finder.cells.parts(name).collect();
        for part in next {
            let limits: Vec<Name> = self.finder.cells.limits(part).collect();
            for at in limits {
                if let Some(far) = self.far_limit(at, name) {
                    return Some(far);
                }
            }
        }
        None
    }

    /// A point of the curve, if it is surely far from the polygon.
    fn far_limit(&mut self, at: Name, near: Name) -> Option<FarPoint> {
        let number = self.finder.cells.points.limit(at.0, at.1);
        let point = self.finder.cells.points.point(number).to_vec();
        let far = self.is_beyond(Set::Polygon(self.level), &point, self.tolerance, near);
        far.then(|| self.far(SetKind::Limit, point, at, 0.0, near))
    }

    fn slack(&self) -> f64 {
        self.finder.cells.slack()
    }

    /// The cells of the level that equal parameters do not show to be near, the farthest first, and whether these are
    /// all: of too many a sample is left.
    fn left(&mut self) -> (Vec<Name>, bool) {
        let mut all = true;
        let roots = self.finder.cells.shape.roots.clone();
        let mut names: BTreeSet<Name> = roots.map(|i| (0, i)).collect();
        for level in 0..=self.level {
            let mut next = BTreeSet::new();
            for &name in &names {
                let cell = self.finder.cells.cell(name);
                let radius = self.finder.cells.later_radius(&cell, self.level - level);
                if radius + self.slack() <= self.tolerance {
                    continue;
                }
                if level == self.level {
                    next.insert(name);
                } else {
                    let parts = self.finder.cells.parts(name);
                    next.extend(parts.map(|name| self.finder.cells.named(name)));
                }
            }
            names = next;
            if names.len() > MAX_OPEN || self.finder.is_at_its_end() {
                all = false;
                let step = names.len().div_ceil(MAX_TRIED);
                names = names.into_iter().step_by(step.max(1)).collect();
            }
        }
        let mut left: Vec<Name> = names.into_iter().collect();
        let radius = |name: &Name| self.finder.cells.known_radius(*name);
        left.sort_by(|x, y| radius(y).total_cmp(&radius(x)));
        (left, all)
    }

    /// The cell of the level that a cell of this level or a later one has its middle in, with both neighbours.
    fn hints(&self, (level, i): Name) -> [Name; 3] {
        let (mut at, shape) = (i, &self.finder.cells.shape);
        // Cell i of level m begins at (i + s)/n^m.
        for _ in self.level..level {
            at = shape.parent(at);
        }
        [0, -1, 1].map(|j| (self.level, at + j))
    }

    /// Whether the curve on a cell is near the polygon. `met` has the cells that were looked at.
    fn curve(&mut self, name: Name, met: &mut BTreeSet<Name>) -> CurveNearness {
        let mut result = CurveNearness::Near;
        let mut stack = vec![name];
        while let Some(name) = stack.pop() {
            let name = self.finder.cells.named(name);
            if !met.insert(name) {
                continue;
            }
            let cell = self.finder.cells.cell(name);
            let [u, v] = self.finder.chord(&cell);
            let enough = self.tolerance - cell.radius - self.slack();
            if enough >= 0.0 {
                // The distance from a segment is convex: all points between u and v are as near to it as these.
                let (polygon, hints) = (Set::Polygon(self.level), self.hints(name));
                if self.finder.find(polygon, &[&u, &v], enough, &hints) == Answer::Yes {
                    continue;
                }
            }
            let limits: Vec<Name> = self.finder.cells.limits(name).collect();
            for at in limits {
                if let Some(far) = self.far_limit(at, name) {
                    return CurveNearness::Far(far);
                }
            }
            let small = cell.radius + distance(&u, &v) < self.tolerance * SMALL;
            let last = name.0 >= self.level + MORE_LEVELS;
            if small
                || last
                || self.finder.is_at_its_end()
                || !self.finder.cells.is_numbered(name.0 + 1)
            {
                result = CurveNearness::Open;
                continue;
            }
            stack.extend(self.finder.cells.parts(name));
        }
        result
    }

    /// Whether a set is surely farther than this from a point.
    fn is_beyond(&mut self, set: Set, point: &[f64], least: f64, near: Name) -> bool {
        let enough = least + 2.0 * self.slack();
        let hints = match set {
            Set::Polygon(_) => self.hints(near).to_vec(),
            Set::Curve => vec![near],
        };
        self.finder.find(set, &[point], enough, &hints) == Answer::No
    }

    /// Whether the segment from u to v, of the shares from `low` to `high` of a cell, has a piece of the curve beside it that
    /// begins before u and ends after v, seen along the segment, and is near to its line.
    fn is_beside_curve(&mut self, name: Name, [low, high]: [f64; 2], u: &[f64], v: &[f64]) -> bool {
        let length = distance(u, v);
        if length <= self.slack() {
            return false;
        }
        let way: Vec<f64> = u.iter().zip(v).map(|(u, v)| (v - u) / length).collect();
        let shape = &self.finder.cells.shape;
        let (arity, [floor, ceiling]) = (shape.arity, shape.shift_between);
        let mut scale = 1;
        for level in self.level + 1..=self.level + MORE_PIECES {
            scale *= arity;
            if !self.finder.cells.is_numbered(level) {
                return false;
            }
            let more = 2 * scale + 4;
            let start = name.1 * scale + self.finder.cells.shape.place(low, scale);
            let end = name.1 * scale + self.finder.cells.shape.place(high, scale) + 1;
            let Some(first) = self.passes((level, start), -1, more, u, &way, 0.0) else {
                return false;
            };
            let Some(last) = self.passes((level, end), 1, more, u, &way, length) else {
                return false;
            };
            // Cell j has the parameters from j + s to j + 1 + s.
            let mut near = true;
            for j in first - ceiling..last - floor {
                let cell = self.finder.cells.cell((level, j));
                let ends =
                    cell.ends.map(|end| off_line(self.finder.cells.points.point(end), u, &way));
                if ends[0].min(ends[1]) - cell.radius > self.tolerance {
                    return false;
                }
                near &= ends[0].max(ends[1]) + cell.radius + self.slack() <= self.tolerance;
            }
            if near {
                return true;
            }
        }
        false
    }

    /// The first of the points of the curve from this one on, in steps of `step`, that is before 0 or after `end` along a
    /// line.
    fn passes(
        &mut self,
        (level, start): Name,
        step: i64,
        most: i64,
        u: &[f64],
        way: &[f64],
        end: f64,
    ) -> Option<i64> {
        for i in 0..most {
            let at = start + step * i;
            if !self.finder.cells.has_limit((level, at)) {
                return None;
            }
            let number = self.finder.cells.points.limit(level, at);
            let along = along(self.finder.cells.points.point(number), u, way);
            let slack = self.slack();
            if (step < 0 && along + slack <= end) || (step > 0 && along - slack >= end) {
                return Some(at);
            }
        }
        None
    }

    /// Whether a segment of the polygon is near the curve.
    fn segment(&mut self, name: Name) -> CurveNearness {
        let cell = self.finder.cells.cell(name);
        let [begin, end] = self.finder.chord(&cell);
        let mut result = CurveNearness::Near;
        let mut stack = vec![[0.0, 1.0]];
        while let Some([low, high]) = stack.pop() {
            let (u, v) = (between(&begin, &end, low), between(&begin, &end, high));
            let middle = between(&u, &v, 0.5);
            let enough = self.tolerance - self.slack();
            let half = 0.5 * distance(&u, &v);
            let part = [low, high].map(|share| cell.place(share));
            if self.is_beside_curve(name, part, &u, &v) {
                continue;
            }
            if enough > half {
                // All points between u and v are as near to a point of the curve as these.
                if self.finder.find(Set::Curve, &[&u, &v], enough, &[name]) == Answer::Yes {
                    continue;
                }
            }
            if self.is_beyond(Set::Curve, &middle, self.tolerance, name) {
                let share = cell.place(0.5 * (low + high));
                return CurveNearness::Far(self.far(SetKind::Mesh, middle, name, share, name));
            }
            if half < self.tolerance * SMALL || self.finder.is_at_its_end() {
                result = CurveNearness::Open;
                continue;
            }
            let half = 0.5 * (low + high);
            stack.extend([[half, high], [low, half]]);
        }
        result
    }

    /// A point that is far, with the greatest of a few lower bounds of its distance that holds.
    fn far(
        &mut self,
        from: SetKind,
        point: Vec<f64>,
        at: Name,
        share: f64,
        near: Name,
    ) -> FarPoint {
        let set = match from {
            SetKind::Limit => Set::Polygon(self.level),
            SetKind::Mesh => Set::Curve,
        };
        let (mut low, mut high) = (self.tolerance, 2.0 * self.tolerance);
        while self.is_beyond(set, &point, high, near) {
            (low, high) = (high, 2.0 * high);
        }
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if self.is_beyond(set, &point, middle, near) { low = middle } else { high = middle }
        }
        FarPoint { from, point, at, share, distance: low * (1.0 - 1e-12) }
    }
}

/// How far x is along a line from u on.
fn along(x: &[f64], u: &[f64], way: &[f64]) -> f64 {
    x.iter().zip(u).zip(way).map(|((x, u), way)| (x - u) * way).sum()
}

/// The distance of x from a line.
fn off_line(x: &[f64], u: &[f64], way: &[f64]) -> f64 {
    let along = along(x, u, way);
    let off = x.iter().zip(u).zip(way).map(|((x, u), way)| x - u - along * way);
    off.map(|off| off * off).sum::<f64>().sqrt()
}
