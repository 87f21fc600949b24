//! A piece with its points: how far the net is from the limit on it.

use super::super::number::{Row, Vector as _};
use super::constants::UP;
use super::direction::{Direction, Weights};
use super::points::{across, along, tensor};
use super::rules::{Phase, Rules};
use crate::mesh::Point;
use crate::patch::distance::judge::Judge;

/// A cell of a level with the points of its window, row by row.
#[derive(Clone)]
pub(crate) struct Cell<S> {
    /// How often each direction is divided.
    pub(super) levels: [u32; 2],
    /// i and j, of the parameters from i to i + 1 and from j to j + 1 over n and m to the power of
    /// these.
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
pub(super) struct Estimate<S> {
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
    /// What each direction adds to the distance between the nodes, at most.
    tails: [f64; 2],
    /// The directions in which a node keeps the difference from being a polynomial.
    broken: [bool; 2],
}

impl<S> Estimate<S> {
    /// The directions to divide: not one that adds much less than the other.
    pub(super) fn divided(&self) -> [bool; 2] {
        let [u, v] = self.tails;
        let less = |one: f64, other: f64| 2.0 * one < other;
        [!less(u, v) || self.broken[0], !less(v, u) || self.broken[1]]
    }
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

    /// The same on a part.
    fn part(&self, directions: &[Direction; 2], divided: [bool; 2], part: [usize; 2]) -> Base<S> {
        let phases = self.phases(directions);
        let parts = [0, 1].map(|d| &phases[d].parts[part[d]]);
        let rows = parts.map(|(_, rows)| &rows[..]);
        let points = refined(&self.points, phases[1].nodes.len(), divided, rows);
        let phases = [0, 1].map(|d| if divided[d] { parts[d].0 } else { self.phases[d] });
        Base { phases, points }
    }
}

/// Combinations of the points of a grid in some directions.
fn refined<S: Weights>(
    points: &[Point<S>],
    columns: usize,
    divided: [bool; 2],
    [u, v]: [&[Row<S>]; 2],
) -> Vec<Point<S>> {
    match divided {
        [true, true] => tensor([u, v], points, columns),
        [true, false] => across(u, points, columns),
        [false, _] => along(v, points, columns),
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

    /// The greater level.
    pub(super) fn level(&self) -> u32 {
        self.levels[0].max(self.levels[1])
    }

    /// The parts in some directions, in the order of their indices.
    pub(super) fn parts(&self, directions: &[Direction; 2], divided: [bool; 2]) -> Vec<Cell<S>> {
        let [u, v] = rules::<S>(directions);
        let [height, width] = directions.each_ref().map(|direction| direction.window.size());
        let rows = [u, v].map(|rules| &rules.refined[..]);
        let refined = refined(&self.points, width, divided, rows);
        let wide = if divided[1] { v.refined.len() } else { width };
        let arities = [0, 1].map(|d| if divided[d] { directions[d].arity } else { 1 });
        let first = [0, 1].map(|d| self.index[d].saturating_mul(arities[d] as i128));
        let levels = [0, 1].map(|d| self.levels[d] + u32::from(divided[d]));
        let mut parts = Vec::with_capacity(arities[0] * arities[1]);
        for (a, i) in (0..arities[0]).zip(first[0]..) {
            for (b, j) in (0..arities[1]).zip(first[1]..) {
                let rows = refined.chunks(wide).skip(a).take(height);
                let points = rows.flat_map(|row| row[b..b + width].iter().cloned()).collect();
                let base = self.base.as_ref().map(|base| base.part(directions, divided, [a, b]));
                parts.push(Cell { levels, index: [i, j], points, base });
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
        [u, v].map(|vectors| judge.greatest(vectors.into_iter(), self.level()))
    }

    /// What is known of the distance from the net that the limit is compared with; `None` where there is none
    /// yet.
    pub(super) fn known(
        &self,
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> Option<Estimate<S>> {
        let base = self.base.as_ref()?;
        let phases = base.phases(directions);
        let width = directions[1].window.size();
        let limits = tensor([&phases[0].limits, &phases[1].limits], &self.points, width);
        let columns = phases[1].nodes.len();
        let mut known: Option<Estimate<S>> = None;
        let mut upper = 0.0_f64;
        for (at, (limit, polygon)) in limits.into_iter().zip(&base.points).enumerate() {
            let error = limit.minus(polygon);
            let lower = judge.below(&error, self.level());
            let beyond = judge.within(&error, self.level()) == Some(false);
            upper = upper.max(judge.above(&error, self.level()));
            let better =
                known.as_ref().is_none_or(|known| (beyond, lower) > (known.beyond, known.lower));
            if better {
                let (nodes, polygon) = ([at / columns, at % columns], polygon.clone());
                known = Some(Estimate {
                    upper: 0.0,
                    lower,
                    within: false,
                    beyond,
                    nodes,
                    limit,
                    polygon,
                    tails: [0.0; 2],
                    broken: [false; 2],
                });
            }
        }
        let mut known = known?;
        known.tails = self.tails(phases, directions, judge);
        let polynomials = rules::<S>(directions).iter().all(|rules| rules.bezier.is_some());
        known.broken = base.phases.map(|phase| polynomials && phase != 0);
        let (upper, within) = self.by_coefficients(base, directions, judge).unwrap_or_else(|| {
            let upper = (upper + known.tails[0] + known.tails[1]) * UP;
            (upper, upper <= judge.tolerance())
        });
        (known.upper, known.within) = (upper, within && !known.beyond);
        Some(known)
    }

    /// How much farther than at the nodes the distance can be between them, by each direction (99 (c)).
    fn tails(
        &self,
        phases: [&Phase<S>; 2],
        directions: &[Direction; 2],
        judge: &impl Judge<Point<S>>,
    ) -> [f64; 2] {
        let [a, b] = self.sizes(directions, judge);
        let [u, v] = directions.each_ref().map(|direction| &direction.constants);
        let [twice, again] = phases.map(|phase| if phase.nodes.len() > 2 { 2.0 } else { 1.0 });
        [twice * u.chord * a * v.limit, u.limit * again * v.chord * b]
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
            let error = limit.minus(plain);
            upper = upper.max(judge.above(&error, self.level()));
            within = within && judge.within(&error, self.level()) == Some(true);
        }
        Some((upper, within))
    }
}
