//! How far a point is from the whole mesh of a level (`proofs/THEOREMS.md`, 97 and 99 (f)).

use super::judge::{Judge as _, Rounded};
use super::surface::{Ball, Surface};
use crate::mesh::Point;
use crate::patch::number::Vector as _;
use crate::patch::threads::in_threads;
use crate::stop::check;

/// How much less than the distance the bound may be, relative to it.
const WIDTH: f64 = 0.01;

/// How many pieces are looked at for one point.
const STEPS: u64 = 200_000;

/// The mesh of a level, for the distances of points from it.
pub(super) struct WholeMesh<'a, S> {
    model: &'a S,
    judge: &'a Rounded,
    level: u32,
    /// Where it is on each root.
    balls: Vec<Ball>,
}

impl<'a, S: Surface> WholeMesh<'a, S> {
    pub(crate) fn new(model: &'a S, judge: &'a Rounded, level: u32) -> Self {
        let roots: Vec<usize> = (0..model.root_count()).collect();
        let ball = |&root: &usize| model.root_ball(&model.root(root, level), judge, level);
        WholeMesh { model, judge, level, balls: in_threads(&roots, ball) }
    }

    /// A lower bound of the distance of a point from the mesh on a piece.
    fn reach(&self, ball: &Ball, point: &Point<f64>) -> f64 {
        self.judge.below(&point.minus(&ball.centre), ball.level) - ball.radius
    }

    /// A lower bound of the distance of a point, which is at most `known` away, from the mesh.
    pub(crate) fn distance(&self, point: &Point<f64>, known: f64) -> f64 {
        let (mut nearest, mut steps, mut lower) = (known, STEPS, known);
        let [_, deepest] = self.model.most_levels();
        for (root, ball) in self.balls.iter().enumerate() {
            let reach = self.reach(ball, point);
            if reach >= nearest * (1.0 - WIDTH) {
                lower = lower.min(reach);
                continue;
            }
            let mut stack = vec![self.model.root(root, self.level)];
            while let Some(cell) = stack.pop() {
                check();
                let ball = self.model.ball(&cell, self.judge, self.level);
                if ball.on_mesh {
                    let distance = point.minus(&ball.centre);
                    nearest = nearest.min(self.judge.above(&distance, ball.level));
                }
                let reach = self.reach(&ball, point);
                steps = steps.saturating_sub(1);
                if reach >= nearest * (1.0 - WIDTH) || steps == 0 || ball.level >= deepest {
                    lower = lower.min(reach);
                } else {
                    stack.extend(self.model.finer(cell, self.level));
                }
            }
        }
        lower.max(0.0)
    }
}
