//! Whether a point is far from the whole mesh of a level, or from the whole limit (`proofs/THEOREMS.md`, 163).

use super::super::cell::Cell;
use super::super::judge::{Points as _, Rounded};
use super::super::model::Model;
use super::super::number::{Vector as _, combinations};
use super::super::roots::Root;
use super::super::threads::in_threads;
use super::cover::reach;
use super::depth::SetKind;
use super::patch::{FaceSurface, Patch, ball, dot, mean, unit};
use crate::mesh::Point;

/// How many pieces are looked at for one point.
const STEPS: u64 = 200_000;

/// Both sets of one level.
pub(super) struct Whole<'a> {
    model: &'a Model,
    surface: FaceSurface,
    level: u32,
    slack: f64,
    /// For each piece of level 1 a ball around its points, and those of the mesh.
    balls: Vec<(Point<f64>, f64)>,
}

impl<'a> Whole<'a> {
    pub(super) fn new(
        model: &'a Model,
        judge: &Rounded,
        surface: FaceSurface,
        level: u32,
    ) -> Whole<'a> {
        let around = |root: &Root| {
            let cell = model.rounded_cell(root, level);
            let base = cell.base.unwrap_or_default();
            let all: Vec<Point<f64>> = cell.points.into_iter().chain(base).collect();
            ball(&all)
        };
        let balls = in_threads(&model.roots.all, around);
        Whole { model, surface, level, slack: 4.0 * judge.slack(level + 40), balls }
    }

    /// Whether a point of one set is surely farther than this from the other set.
    pub(super) fn is_beyond(&self, point: &Point<f64>, from: SetKind, distance: f64) -> bool {
        let enough = distance + self.slack;
        let mut steps = STEPS;
        let near = |(centre, radius): &(Point<f64>, f64)| {
            let way = point.minus(centre);
            let reach = enough + radius;
            way[0] * way[0] + way[1] * way[1] + way[2] * way[2] <= reach * reach * (1.0 + 1e-9)
        };
        self.model.roots.all.iter().zip(&self.balls).filter(|(_, ball)| near(ball)).all(
            |(root, _)| match from {
                SetKind::Mesh => self.limit_is_beyond(root, point, enough, &mut steps),
                SetKind::Limit => self.mesh_is_beyond(root, point, enough, &mut steps),
            },
        )
    }

    fn limit_is_beyond(
        &self,
        root: &Root,
        point: &Point<f64>,
        enough: f64,
        steps: &mut u64,
    ) -> bool {
        let shapes = &self.model.shapes;
        let mut stack = vec![self.model.rounded_cell(root, 1)];
        while let Some(cell) = stack.pop() {
            if *steps == 0 {
                return false;
            }
            *steps -= 1;
            let rules = Point::<f64>::rules(shapes.get(cell.shape));
            let hull: Vec<Point<f64>> = match &rules.regular {
                Some((bezier, _)) => combinations(bezier.iter().map(|(row, _)| row), &cell.points),
                None => cell.points.clone(),
            };
            let (centre, radius) = ball(&hull);
            if reach(point, &hull, &centre, radius) > enough {
                continue;
            }
            if radius < enough * 1e-6 || cell.level > 40 {
                return false;
            }
            stack.extend(cell.parts(shapes, false));
        }
        true
    }

    fn mesh_is_beyond(
        &self,
        root: &Root,
        point: &Point<f64>,
        enough: f64,
        steps: &mut u64,
    ) -> bool {
        let shapes = &self.model.shapes;
        let mut stack = vec![self.model.rounded_cell(root, self.level)];
        while let Some(cell) = stack.pop() {
            if *steps == 0 {
                return false;
            }
            *steps -= 1;
            if cell.base.is_none() {
                let (centre, radius) = ball(&cell.points);
                if reach(point, &cell.points, &centre, radius) > enough {
                    continue;
                }
                if cell.level < self.level {
                    stack.extend(cell.parts(shapes, false));
                    continue;
                }
            }
            let patches = self.patches(root, &cell);
            if !patches.into_iter().all(|patch| is_beyond_patch(patch, point, enough, steps)) {
                return false;
            }
        }
        true
    }

    /// The mesh of the level on a piece of that level.
    fn patches(&self, root: &Root, cell: &Cell<Point<f64>>) -> Vec<Patch> {
        let shapes = &self.model.shapes;
        if let Some(base) = &cell.base {
            return Patch::between(base, self.surface.is_bilinear(self.model.face_size(root)));
        }
        if let Some(Cell { base: Some(own), .. }) = cell.begun(shapes) {
            if own.len() == 3 || self.surface.is_bilinear(own.len()) {
                return Patch::between(&own, true);
            }
            let centre = mean(&own);
            let n = own.len();
            return (0..n).map(|i| Patch::triangle(own[i], own[(i + 1) % n], centre)).collect();
        }
        let rules = Point::<f64>::rules(shapes.get(cell.shape));
        let parts = cell.parts(shapes, true).into_iter().zip(&rules.base);
        parts
            .flat_map(|(part, rows)| {
                // The third corner is the centroid of the face.
                let bilinear = self.surface.is_bilinear(rows[2].len());
                Patch::between(&part.base.unwrap_or_default(), bilinear)
            })
            .collect()
    }
}

fn is_beyond_patch(patch: Patch, point: &Point<f64>, enough: f64, steps: &mut u64) -> bool {
    let mut stack = vec![patch];
    while let Some(patch) = stack.pop() {
        if *steps == 0 {
            return false;
        }
        *steps -= 1;
        let corners = patch.corners();
        let (centre, radius) = ball(corners);
        let mut reached = reach(point, corners, &centre, radius);
        if reached <= enough {
            let near = patch.near(point).minus(point);
            if let Some(normal) = unit(&near) {
                let heights = corners.iter().map(|x| dot(&normal, &x.minus(point)));
                reached = reached.max(heights.fold(f64::INFINITY, f64::min));
            }
        }
        if reached > enough {
            continue;
        }
        if radius < enough * 1e-6 {
            return false;
        }
        stack.extend(patch.parts());
    }
    true
}
