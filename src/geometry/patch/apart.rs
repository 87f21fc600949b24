//! How far a point is from the whole mesh of a level (`proofs/THEOREMS.md`, 97).

use super::cell::Cell;
use super::judge::{Judge, Rounded};
use super::model::Model;
use super::number::{Row, Vector as _, combinations};
use super::roots::Root;
use super::rules::{parts_of_face, quadrilaterals_of_face};
use super::threads::in_threads;
use crate::mesh::Point;

/// How much less than the distance the bound may be, relative to it.
const WIDTH: f64 = 0.01;

/// How many pieces are looked at for one point.
const STEPS: u64 = 200_000;

/// The mesh of a level, for the distances of points from it.
pub(super) struct WholeMesh<'a> {
    model: &'a Model,
    judge: &'a Rounded,
    level: u32,
    /// For each piece of level 1 a point of its neighbourhood, and how far the others are from it.
    balls: Vec<(Point<f64>, f64)>,
    /// The corners of the parts of a bilinear or flat piece.
    rows: Vec<Vec<Row<f64>>>,
}

impl<'a> WholeMesh<'a> {
    pub(super) fn new(model: &'a Model, judge: &'a Rounded, level: u32) -> WholeMesh<'a> {
        let ball = |root: &Root| {
            // With the polygon of level 0 it is that and not the points of level 1 that count.
            let cell = model.rounded_cell(root, level);
            let points = cell.base.as_ref().unwrap_or(&cell.points);
            (points[0], judge.greatest(points.iter().map(|x| x.minus(&points[0])), 1))
        };
        let balls = in_threads(&model.roots.all, ball);
        let triangles = model.kind.is_triangular();
        let rows =
            if triangles { parts_of_face(3) } else { quadrilaterals_of_face(4, &[0, 1, 2, 3]) };
        WholeMesh { model, judge, level, balls, rows }
    }

    /// A lower bound of the distance of a point, which is at most `known` away, from the mesh.
    pub(super) fn distance(&self, point: &Point<f64>, known: f64) -> f64 {
        let (mut nearest, mut steps) = (known, STEPS);
        let reach = |(centre, radius): &(Point<f64>, f64)| {
            self.judge.below(&point.minus(centre), 1) - radius
        };
        let mut lower = known;
        for (root, ball) in self.model.roots.all.iter().zip(&self.balls) {
            if reach(ball) >= nearest * (1.0 - WIDTH) {
                lower = lower.min(reach(ball));
                continue;
            }
            let cell = self.model.rounded_cell(root, self.level);
            lower = lower.min(self.in_piece(cell, point, &mut nearest, &mut steps));
        }
        lower.max(0.0)
    }

    /// The same for one piece.
    fn in_piece(
        &self,
        piece: Cell<Point<f64>>,
        point: &Point<f64>,
        nearest: &mut f64,
        steps: &mut u64,
    ) -> f64 {
        let mut lower = f64::INFINITY;
        let mut stack = vec![piece];
        while let Some(cell) = stack.pop() {
            let points = cell.base.as_ref().unwrap_or(&cell.points);
            let centre = mean(points);
            let radius = self.judge.greatest(points.iter().map(|x| x.minus(&centre)), cell.level);
            let distance = point.minus(&centre);
            if cell.base.is_some() {
                // The mean of the corners is a point of the mesh.
                *nearest = nearest.min(self.judge.above(&distance, cell.level));
            }
            let reach = self.judge.below(&distance, cell.level) - radius;
            *steps = steps.saturating_sub(1);
            if reach >= *nearest * (1.0 - WIDTH) || *steps == 0 {
                lower = lower.min(reach);
            } else if let Some(base) = &cell.base {
                stack.extend(self.quarters(&cell, base));
            } else if cell.level < self.level {
                stack.extend(cell.parts(&self.model.shapes, false));
            } else {
                match cell.begun(&self.model.shapes) {
                    Some(begun) => stack.push(begun),
                    None => stack.extend(cell.parts(&self.model.shapes, true)),
                }
            }
        }
        lower
    }

    /// The parts of a bilinear or flat piece, which need no points but its corners.
    fn quarters(&self, cell: &Cell<Point<f64>>, base: &[Point<f64>]) -> Vec<Cell<Point<f64>>> {
        let part = |rows: &Vec<Row<f64>>| Cell {
            shape: cell.shape,
            level: cell.level + 1,
            points: Vec::new(),
            base: Some(combinations(rows, base)),
            path: cell.path,
        };
        self.rows.iter().map(part).collect()
    }
}

fn mean(points: &[Point<f64>]) -> Point<f64> {
    let count = f64::from(u32::try_from(points.len()).unwrap_or(u32::MAX));
    [0, 1, 2].map(|i| points.iter().map(|point| point[i]).sum::<f64>() / count)
}
