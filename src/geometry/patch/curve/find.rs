//! Whether a set has a point near another one: a search through its cells.

use super::cells::{Cell, Cells, Name};
use crate::bound::Budget;

/// The most points that are kept.
pub(super) const MAX_POINTS: usize = 1 << 22;

/// The set that is searched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Set {
    /// The polygon of a level.
    Polygon(u32),
    /// The curve.
    Curve,
}

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Answer {
    Yes,
    /// None is near enough.
    No,
    /// The caps were met.
    Open,
}

/// A ball around the chords of some cells of level 0, which also has the curve and all polygons on them.
struct Ball {
    centre: Vec<f64>,
    radius: f64,
}

/// The cells with what makes a search through them quick.
pub(super) struct Finder {
    pub(super) cells: Cells,
    /// For each power of 2 the balls around so many cells of level 0 in turn.
    balls: Vec<Vec<Ball>>,
    /// How many cells may still be looked at.
    pub(super) budget: Budget,
    /// How many of them are kept for later levels.
    pub(super) rest: u64,
}

impl Finder {
    pub(super) fn new(mut cells: Cells, budget: Budget) -> Finder {
        let mut row: Vec<Ball> = cells
            .shape
            .roots
            .clone()
            .map(|i| {
                let cell = cells.cell((0, i));
                let [u, v] = cell.ends.map(|end| cells.points.point(end));
                let radius = cells.polygon_radius(&cell, u32::MAX);
                Ball { centre: between(u, v, 0.5), radius: radius + 0.5 * distance(u, v) }
            })
            .collect();
        let mut balls = Vec::new();
        while row.len() > 1 {
            let next = row
                .chunks(2)
                .map(|pair| {
                    let centre = between(&pair[0].centre, &pair[pair.len() - 1].centre, 0.5);
                    let reach = |ball: &Ball| distance(&centre, &ball.centre) + ball.radius;
                    let radius = pair.iter().map(reach).fold(0.0, f64::max);
                    Ball { centre, radius }
                })
                .collect();
            balls.push(std::mem::replace(&mut row, next));
        }
        balls.push(row);
        Finder { cells, balls, budget, rest: 0 }
    }

    /// Lets the search go on until one of so many parts of what is left is spent.
    pub(super) fn spend(&mut self, parts: u64) {
        let left = self.budget.left();
        self.rest = left - left / parts;
    }

    /// Forgets points and cells once they are many: they are computed again when they are needed.
    pub(super) fn tidy(&mut self) {
        if self.cells.points.len() > MAX_POINTS / 2 {
            self.cells.forget();
        }
    }

    /// Whether the caps on work or on memory are met.
    pub(super) fn is_at_its_end(&self) -> bool {
        self.budget.left() <= self.rest || self.cells.points.len() > MAX_POINTS
    }

    /// The clipped ends of the chord of a cell.
    pub(super) fn chord(&self, cell: &Cell) -> [Vec<f64>; 2] {
        let [u, v] = cell.ends.map(|end| self.cells.points.point(end));
        cell.part.map(|part| between(u, v, part))
    }

    /// Whether the set has a point, or a segment, that is at most `within` from all points `from`: for a segment each may be
    /// near to another point of it. Cells `hints` are looked at first.
    pub(super) fn find(
        &mut self,
        set: Set,
        from: &[&[f64]],
        within: f64,
        hints: &[Name],
    ) -> Answer {
        for &hint in hints {
            let hint = self.cells.named(hint);
            if self.cells.has(hint) && self.search(set, hint, from, within) == Answer::Yes {
                return Answer::Yes;
            }
        }
        let mut found = Answer::No;
        let mut groups = vec![(self.balls.len() - 1, 0)];
        while let Some((height, at)) = groups.pop() {
            let Ball { centre, radius } = &self.balls[height][at];
            let reach = within + radius + self.cells.slack();
            if from.iter().any(|from| distance(from, centre) > reach) {
                continue;
            }
            if height > 0 {
                groups.extend([2 * at, 2 * at + 1].map(|at| (height - 1, at)));
                groups.retain(|(height, at)| *at < self.balls[*height].len());
                continue;
            }
            let root = self.cells.shape.roots.start + i64::try_from(at).unwrap_or(0);
            match self.search(set, (0, root), from, within) {
                Answer::Yes => return Answer::Yes,
                Answer::No => {}
                Answer::Open => found = Answer::Open,
            }
        }
        found
    }

    /// The search in one cell.
    fn search(&mut self, set: Set, cell: Name, from: &[&[f64]], within: f64) -> Answer {
        let mut found = Answer::No;
        let mut stack = vec![cell];
        while let Some(name) = stack.pop() {
            if self.is_at_its_end() || !self.budget.take(1) {
                return Answer::Open;
            }
            let cell = self.cells.cell(name);
            let [u, v] = self.chord(&cell);
            let radius = match set {
                Set::Polygon(level) => {
                    self.cells.polygon_radius(&cell, level.saturating_sub(name.0))
                }
                Set::Curve => cell.radius,
            };
            let greatest =
                from.iter().map(|from| distance_to_segment(from, &u, &v)).fold(0.0, f64::max);
            if greatest > within + radius + self.cells.slack() {
                continue;
            }
            if set == Set::Polygon(name.0) {
                if greatest <= within {
                    return Answer::Yes;
                }
                continue;
            }
            if set == Set::Curve {
                let limits: Vec<Name> = self.cells.limits(name).collect();
                for (level, i) in limits {
                    let number = self.cells.points.limit(level, i);
                    let point = self.cells.points.point(number);
                    if from.iter().all(|from| distance(from, point) <= within) {
                        return Answer::Yes;
                    }
                }
                let small = radius + distance(&u, &v) < within * 1e-5;
                if small || !self.cells.is_numbered(name.0 + 1) {
                    found = Answer::Open;
                    continue;
                }
            }
            stack.extend(self.cells.parts(name));
        }
        found
    }
}

/// |x − y|.
pub(super) fn distance(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

/// x + t(y − x).
pub(super) fn between(x: &[f64], y: &[f64], t: f64) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x + t * (y - x)).collect()
}

/// The distance of p from the segment from u to v.
pub(super) fn distance_to_segment(p: &[f64], u: &[f64], v: &[f64]) -> f64 {
    let (mut along, mut square) = (0.0, 0.0);
    for ((p, u), v) in p.iter().zip(u).zip(v) {
        along += (p - u) * (v - u);
        square += (v - u) * (v - u);
    }
    let t = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    let off = p.iter().zip(u).zip(v).map(|((p, u), v)| {
        let x = u + t * (v - u) - p;
        x * x
    });
    off.sum::<f64>().sqrt()
}
