//! A piece with its points: how far the net is from the limit on it.

use super::super::judge::Judge;
use super::constants::UP;
use super::direction::{Direction, Weights};
use super::points::{across, along, minus, tensor};
use super::rules::{Phase, Rules};
use crate::mesh::Point;

/// A cell of a level with the points of its window, row by row.
#[derive(Clone)]
pub(super) struct Cell<S> {
    pub(super) level: u32,
    /// i and j, of the parameters from i to i + 1 and from j to j + 1 over n^level and m^level.
    pub(super) index: [i128; 2],
    pub(super) points: Vec<Point<S>>,
    /// The net that the limit is compared with, where it is of this level or an earlier one.
    pub(super) base: Option<Base<S>>,
}

/// A net that is bilinear between some nodes of a cell.
#[derive(Clone)]
pub(super) struct Base<S> {
    /// The phases of both directions.
    pub(super) phases: [usize; 2],
    /// The points at the nodes, row by row.
    pub(super) points: Vec<Point<S>>,
}

/// What is known of the distance on a cell.
pub(super) struct Known<S> {
    pub(super) upper: f64,
    pub(super) lower: f64,
    /// Whether all is within the tolerance.
    pub(super) within: bool,
    /// Whether the distance at that node is beyond the tolerance.
    pub(super) beyond: bool,
    /// The nodes with the greatest lower bound, and the points there.
    pub(super) nodes: [usize; 2],
    pub(super) limit: Point<S>,
    pub(super) polygon: Point<S>,
}

/// A bound of the distance of the net of a level, `later` levels after that of a cell with
/// differences of at most these sizes; and of all later ones (`proofs/THEOREMS.md`, 99 (a)).
pub(super) fn bound(directions: &[Direction; 2], [a, b]: [f64; 2], later: u32) -> f64 {
    let [u, v] = directions.each_ref().map(|direction| &direction.constants);
    let (a, b) = (u.error_at(later) * a, v.error_at(later) * b);
    let one = a * v.limit + u.polygon_at(later) * b;
    let other = b * u.limit + v.polygon_at(later) * a;
    one.min(other) * UP
}

fn rules<S: Weights>(directions: &[Direction; 2]) -> [&Rules<S>; 2] {
    directions.each_ref().map(S::rules)
}

impl<S: Weights> Base<S> {
    fn phases<'a>(&self, directions: &'a [Direction; 2]) -> [&'a Phase<S>; 2] {
        let [u, v] = rules::<S>(directions);
        [&u.phases[self.phases[0]], &v.phases[self.phases[1]]]
    }
}

impl<S: Weights> Cell<S> {
    /// The work for this cell: 1 for 16 points.
    pub(super) fn work(&self) -> u64 {
        self.points.len() as u64 / 16 + 1
    }

    /// This cell, compared with the net of its own level.
    pub(super) fn begun(self, directions: &[Direction; 2]) -> Cell<S> {
        let [u, v] = rules::<S>(directions);
        let points = tensor([&u.polygon, &v.polygon], &self.points, directions[1].window.size());
        Cell { base: Some(Base { phases: [u.start, v.start], points }), ..self }
    }

    /// The parts, in the order of their indices.
    pub(super) fn parts(&self, directions: &[Direction; 2]) -> Vec<Cell<S>> {
        let [u, v] = rules::<S>(directions);
        let [height, width] = directions.each_ref().map(|direction| direction.window.size());
        let refined = tensor([&u.refined, &v.refined], &self.points, width);
        let wide = v.refined.len();
        let [n, m] = directions.each_ref().map(|direction| direction.arity);
        let mut parts = Vec::with_capacity(n * m);
        for (a, i) in (0..n).zip(self.index[0].saturating_mul(n as i128)..) {
            for (b, j) in (0..m).zip(self.index[1].saturating_mul(m as i128)..) {
                let rows = refined.chunks(wide).skip(a).take(height);
                let points = rows.flat_map(|row| row[b..b + width].iter().cloned()).collect();
                let base = self.base.as_ref().map(|base| {
                    let [u, v] = base.phases(directions);
                    let ((first, rows), (second, columns)) = (&u.parts[a], &v.parts[b]);
                    let points = tensor([rows, columns], &base.points, v.nodes.len());
                    Base { phases: [*first, *second], points }
                });
                parts.push(Cell { level: self.level + 1, index: [i, j], points, base });
            }
        }
        parts
    }

    /// The greatest differences in both directions.
    pub(super) fn sizes(
        &self,
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> [f64; 2] {
        let [u, v] = rules::<S>(directions);
        let width = directions[1].window.size();
        let u = across(&u.differences, &self.points, width);
        let v = along(&v.differences, &self.points, width);
        [u, v].map(|vectors| judge.greatest(vectors.into_iter(), self.level))
    }

    /// What is known of the distance from the net that the limit is compared with; `None` where there is none
    /// yet.
    pub(super) fn known(
        &self,
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> Option<Known<S>> {
        let base = self.base.as_ref()?;
        let phases = base.phases(directions);
        let width = directions[1].window.size();
        let limits = tensor([&phases[0].limits, &phases[1].limits], &self.points, width);
        let columns = phases[1].nodes.len();
        let mut known: Option<Known<S>> = None;
        let mut upper = 0.0_f64;
        for (at, (limit, polygon)) in limits.into_iter().zip(&base.points).enumerate() {
            let error = minus(&limit, polygon);
            let lower = judge.below(&error, self.level);
            let beyond = judge.within(&error, self.level) == Some(false);
            upper = upper.max(judge.above(&error, self.level));
            let better =
                known.as_ref().is_none_or(|known| (beyond, lower) > (known.beyond, known.lower));
            if better {
                let (nodes, polygon) = ([at / columns, at % columns], polygon.clone());
                known =
                    Some(Known { upper: 0.0, lower, within: false, beyond, nodes, limit, polygon });
            }
        }
        let mut known = known?;
        let (upper, within) = self.by_coefficients(base, directions, judge).unwrap_or_else(|| {
            let upper = upper + self.tail(phases, directions, judge);
            (upper, upper <= judge.tolerance())
        });
        (known.upper, known.within) = (upper, within && !known.beyond);
        Some(known)
    }

    /// How much farther than at the nodes the distance can be between them (99 (c)).
    fn tail(
        &self,
        phases: [&Phase<S>; 2],
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> f64 {
        let [a, b] = self.sizes(directions, judge);
        let [u, v] = directions.each_ref().map(|direction| &direction.constants);
        let [twice, again] = phases.map(|phase| if phase.nodes.len() > 2 { 2.0 } else { 1.0 });
        (twice * u.chord * a * v.limit + u.limit * again * v.chord * b) * UP
    }

    /// A bound by the Bézier coefficients, and whether all are within the tolerance; `None` where the
    /// difference is not known to be a polynomial.
    fn by_coefficients(
        &self,
        base: &Base<S>,
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> Option<(f64, bool)> {
        let [u, v] = rules::<S>(directions);
        let (first, second) = (u.bezier.as_ref()?, v.bezier.as_ref()?);
        if base.phases != [0, 0] {
            return None;
        }
        let limit = tensor([first, second], &self.points, directions[1].window.size());
        let plain = tensor([&u.raised, &v.raised], &base.points, 2);
        let (mut upper, mut within) = (0.0_f64, true);
        for (limit, plain) in limit.iter().zip(&plain) {
            let error = minus(limit, plain);
            upper = upper.max(judge.above(&error, self.level));
            within = within && judge.within(&error, self.level) == Some(true);
        }
        Some((upper, within))
    }
}
