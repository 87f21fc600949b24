//! Whether a point is far from the whole mesh of a level, or from the whole limit (`proofs/THEOREMS.md`, 163).

use super::super::number::{Vector as _, squared};
use super::super::threads::in_threads;
use super::cover::reach;
use super::patch::{Patch, dot, unit};
use super::pieces::{Hull, MeshPart, Sets};
use super::place::SetKind;
use crate::mesh::Point;
use crate::stop::check;

/// How many pieces are looked at for one point.
const STEPS: u64 = 200_000;

/// The highest level of pieces.
const DEEPEST: u32 = 40;

/// Both sets of one level.
pub(crate) struct Whole<S> {
    pub(crate) sets: S,
    /// Balls around the limit and the mesh of each root.
    balls: Vec<[(Point<f64>, f64); 2]>,
}

impl<S: Sets> Whole<S> {
    pub(crate) fn new(sets: S) -> Whole<S> {
        let numbers: Vec<usize> = (0..sets.count()).collect();
        let around = |&number: &usize| {
            let limit = sets.hull(&sets.root(number, false)).ball();
            let mesh = match sets.mesh_part(number, &sets.root(number, true)) {
                MeshPart::Within(points, extra) => as_hull(points, extra).ball(),
                MeshPart::Patches(patches) => {
                    let corners = patches.iter().flat_map(Patch::corners).copied();
                    as_hull(corners.collect(), 0.0).ball()
                }
            };
            [limit, mesh]
        };
        let balls = in_threads(&numbers, around);
        Whole { sets, balls }
    }

    /// Whether a point of one set is surely farther than this from the other set.
    pub(crate) fn is_beyond(&self, point: &Point<f64>, from: SetKind, distance: f64) -> bool {
        let enough = distance + self.sets.slack();
        let mut steps = STEPS;
        let of_mesh = from == SetKind::Limit;
        let near = |(centre, radius): &(Point<f64>, f64)| {
            let reach = enough + radius;
            squared(point, centre) <= reach * reach * (1.0 + 1e-9)
        };
        let ball = |number: usize| &self.balls[number][usize::from(of_mesh)];
        (0..self.balls.len()).filter(|number| near(ball(*number))).all(|number| {
            let root = self.sets.root(number, of_mesh);
            if of_mesh {
                self.mesh_is_beyond(number, root, point, enough, &mut steps)
            } else {
                self.limit_is_beyond(root, point, enough, &mut steps)
            }
        })
    }

    fn limit_is_beyond(
        &self,
        root: S::Piece,
        point: &Point<f64>,
        enough: f64,
        steps: &mut u64,
    ) -> bool {
        all_beyond(root, steps, |piece, _| {
            let hull = self.sets.hull(&piece);
            let (centre, radius) = hull.ball();
            if reach(point, &hull, &centre, radius) > enough {
                return Some(Vec::new());
            }
            let wide = radius >= enough * 1e-6 && hull.level <= DEEPEST;
            wide.then(|| self.sets.parts(&piece))
        })
    }

    fn mesh_is_beyond(
        &self,
        number: usize,
        root: S::Piece,
        point: &Point<f64>,
        enough: f64,
        steps: &mut u64,
    ) -> bool {
        all_beyond(root, steps, |piece, steps| match self.sets.mesh_part(number, &piece) {
            MeshPart::Within(points, extra) => {
                let hull = as_hull(points, extra);
                let (centre, radius) = hull.ball();
                let beyond = reach(point, &hull, &centre, radius) > enough;
                Some(if beyond { Vec::new() } else { self.sets.parts(&piece) })
            }
            MeshPart::Patches(patches) => {
                let beyond = |patch| is_beyond_patch(patch, point, enough, steps);
                patches.into_iter().all(beyond).then(Vec::new)
            }
        })
    }
}

/// Whether all of a piece is beyond: `parts` has the parts that are left to look at, and `None` where that ends the search.
fn all_beyond<P>(
    root: P,
    steps: &mut u64,
    mut parts: impl FnMut(P, &mut u64) -> Option<Vec<P>>,
) -> bool {
    let mut stack = vec![root];
    while let Some(piece) = stack.pop() {
        check();
        if *steps == 0 {
            return false;
        }
        *steps -= 1;
        let Some(parts) = parts(piece, steps) else { return false };
        stack.extend(parts);
    }
    true
}

fn as_hull(points: Vec<Point<f64>>, extra: f64) -> Hull {
    Hull { points, extra, limits: Vec::new(), level: 0 }
}

fn is_beyond_patch(patch: Patch, point: &Point<f64>, enough: f64, steps: &mut u64) -> bool {
    all_beyond(patch, steps, |patch, _| {
        let corners = patch.corners();
        let hull = as_hull(corners.to_vec(), 0.0);
        let (centre, radius) = hull.ball();
        let mut reached = reach(point, &hull, &centre, radius);
        if reached <= enough {
            let near = patch.near(point).minus(point);
            if let Some(normal) = unit(&near) {
                let heights = corners.iter().map(|x| dot(&normal, &x.minus(point)));
                reached = reached.max(heights.fold(f64::INFINITY, f64::min));
            }
        }
        if reached > enough {
            return Some(Vec::new());
        }
        (radius >= enough * 1e-6).then(|| patch.parts().into())
    })
}
