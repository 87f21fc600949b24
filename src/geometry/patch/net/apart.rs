//! How far limit points are from the whole net of a level (`proofs/THEOREMS.md`, 97 and 99 (f)).

use super::super::depth::PIECE_STEPS;
use super::super::judge::{Judge, Rounded};
use super::super::threads::in_threads;
use super::cell::Cell;
use super::constants::UP;
use super::depth::NetDistances;
use super::measure::FACE_WIDTH;
use super::points::minus;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::Point;
use std::collections::BTreeSet;

/// How many limit points are tried.
const TRIED: usize = 64;

/// How much less than the distance the bound may be, relative to it.
const WIDTH: f64 = 0.01;

/// How many pieces are looked at for one point.
const STEPS: u64 = 200_000;

impl NetDistances {
    /// A lower bound of the one-sided Hausdorff distance at a level: the greatest distance, from the
    /// whole net, of the limit points that are farthest from it at their parameters, each in its piece.
    pub(super) fn apart(&self, level: u32) -> f64 {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let waiting = model.above(level, 0.0);
        if waiting.is_empty() {
            return 0.0;
        }
        let roots: Vec<usize> = (0..model.roots()).collect();
        let balls = in_threads(&roots, |&root| self.ball(&model.rounded_cell(root), &judge, level));
        // More of those with great bounds than of the others.
        let chosen: BTreeSet<usize> =
            (0..TRIED).map(|i| waiting.len() * i * i / (TRIED * TRIED)).collect();
        let mut best = 0.0_f64;
        for (_, root) in chosen.into_iter().filter_map(|i| waiting.get(i)) {
            let mut search = self.search(&judge, level, PIECE_STEPS);
            let (mut far, mut place) = (best, None);
            search.measure(model.rounded_cell(*root), FACE_WIDTH, &mut far, &mut place);
            if let Some(place) = place {
                let known = judge.above(
                    &minus(&place.limit, &place.polygon),
                    place.levels[0].max(place.levels[1]),
                );
                best = best.max(self.to_whole(&place.limit, known, &judge, level, &balls));
            }
        }
        best * nearest(&model.scale)
    }

    /// A lower bound of the distance of a point, which is at most `known` away, from the net.
    fn to_whole(
        &self,
        point: &Point<f64>,
        known: f64,
        judge: &Rounded,
        level: u32,
        balls: &[(Point<f64>, f64)],
    ) -> f64 {
        let (mut nearest, mut steps, mut lower) = (known, STEPS, known);
        for (root, (centre, radius)) in balls.iter().enumerate() {
            let reach = judge.below(&minus(point, centre), 0) - radius;
            if reach >= nearest * (1.0 - WIDTH) {
                lower = lower.min(reach);
                continue;
            }
            let mut stack = vec![self.model.rounded_cell(root)];
            while let Some(cell) = stack.pop() {
                let (centre, radius) = self.ball(&cell, judge, level);
                let distance = minus(point, &centre);
                if cell.base.is_some() {
                    // The first corner is a point of the net.
                    nearest = nearest.min(judge.above(&distance, cell.level()));
                }
                let reach = judge.below(&distance, cell.level()) - radius;
                steps = steps.saturating_sub(1);
                let [_, deepest] = self.model.most_levels(u32::MAX);
                if reach >= nearest * (1.0 - WIDTH) || steps == 0 || cell.level() >= deepest {
                    lower = lower.min(reach);
                } else if cell.level() == level && cell.base.is_none() {
                    stack.push(cell.begun(&self.model.directions));
                } else {
                    stack.extend(cell.parts(&self.model.directions, [true; 2]));
                }
            }
        }
        lower.max(0.0)
    }

    /// A point, and how far the net of the level on a cell is from it at most.
    fn ball(&self, cell: &Cell<f64>, judge: &Rounded, level: u32) -> (Point<f64>, f64) {
        let radius = |points: &[Point<f64>], centre: &Point<f64>| {
            judge.greatest(points.iter().map(|point| minus(point, centre)), cell.level())
        };
        if let Some(base) = &cell.base {
            return (base.points[0], radius(&base.points, &base.points[0]));
        }
        let centre = cell.points[cell.points.len() / 2];
        let norm = |direction: &super::direction::Direction| {
            direction.constants.polygon_at(level.saturating_sub(cell.level()))
        };
        let norm: f64 = self.model.directions.iter().map(norm).product();
        (centre, radius(&cell.points, &centre) * norm * UP)
    }
}
