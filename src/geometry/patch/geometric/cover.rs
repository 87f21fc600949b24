//! Whether the two parts of a unit are near the other set (`proofs/THEOREMS.md`, 161 and 162).

use super::super::number::{Vector as _, squared};
use super::node::Nodes;
use super::patch::{Patch, ball, cross, dot, length, unit};
use super::pieces::{Hull, Units};
use super::place::{Nearness, SetKind};
use super::scene::{Ring, Scene};
use super::shadow::Direction;
use crate::mesh::Point;

/// How often a patch or a piece of the limit is divided.
const MAX_DIVISIONS: u32 = 16;

/// How many pairs are looked at for one unit.
const UNIT_PAIRS: u64 = 400_000;

/// How many points of one unit are handed to `is_far`.
const MAX_TRIED: u32 = 24;

/// A point of one set, and one that is near it of the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FarPoint {
    pub(crate) unit: usize,
    pub(crate) from: SetKind,
    pub(crate) point: Point<f64>,
    pub(crate) other: Point<f64>,
}

/// The search on one unit. `is_far` says whether a point of a set is surely beyond the tolerance from the other
/// set, all of it.
pub(super) struct Cover<'a, P: Units, F> {
    scene: &'a Scene<P>,
    nodes: Nodes<'a, P>,
    unit: usize,
    ring: Ring,
    /// For the units of the ring, their pieces of the limit.
    roots: Vec<usize>,
    patches: Vec<Patch>,
    /// A direction in which the ring surrounds the whole unit.
    direction: Option<Direction>,
    pairs: u64,
    tried: u32,
    tolerance: f64,
    is_far: &'a F,
}

impl<'a, P: Units, F: Fn(&Point<f64>, SetKind) -> bool> Cover<'a, P, F> {
    /// Looks at one unit.
    pub(super) fn unit(scene: &'a Scene<P>, unit: usize, is_far: &'a F) -> Nearness<FarPoint> {
        if scene.is_near_by_parameter(unit) {
            return Nearness::Near;
        }
        let mut cover = Cover::around(scene, unit, is_far, 2);
        if cover.direction.is_none() {
            cover = Cover::around(scene, unit, is_far, 4);
        }
        let limit = cover.limit(cover.roots[0], 0);
        let patches = scene.units[unit].patches.iter();
        Nearness::all(std::iter::once(limit).chain(patches.map(|patch| cover.mesh(patch, 0))))
    }

    fn around(scene: &'a Scene<P>, unit: usize, is_far: &'a F, steps: usize) -> Self {
        let ring = scene.ring(unit, steps);
        let mut nodes = Nodes::new(&scene.pieces);
        let roots: Vec<usize> =
            ring.units.iter().map(|&unit| nodes.add(scene.pieces.piece(unit))).collect();
        let patches: Vec<Patch> =
            ring.units.iter().flat_map(|&unit| scene.units[unit].patches.iter().copied()).collect();
        let own = nodes.get(roots[0]);
        let corners = scene.units[unit].patches.iter().flat_map(|patch| patch.corners().to_vec());
        let all: Vec<Point<f64>> = own.hull.points.iter().copied().chain(corners).collect();
        let (centre, radius) = ball(&all);
        let radius = radius + own.hull.extra;
        let normals = scene.units[unit].patches.iter().filter_map(Patch::normal);
        let sum = normals.fold([0.0; 3], |sum, x| [0, 1, 2].map(|i| sum[i] + x[i]));
        let direction = Direction::new(&sum)
            .filter(|direction| direction.winds(&ring.boundary, &centre, radius + scene.slack));
        let tolerance = scene.pieces.tolerance();
        Cover {
            scene,
            nodes,
            unit,
            ring,
            roots,
            patches,
            direction,
            pairs: UNIT_PAIRS,
            tried: 0,
            tolerance,
            is_far,
        }
    }

    /// Whether a piece of the limit is near the mesh.
    fn limit(&mut self, node: usize, divisions: u32) -> Nearness<FarPoint> {
        let own = self.direction;
        if own.is_some_and(|direction| self.is_over_mesh(node, &direction))
            || self.is_near_patch(node)
        {
            return Nearness::Near;
        }
        if let Some(direction) = self.surrounded(node)
            && self.is_over_mesh(node, &direction)
        {
            return Nearness::Near;
        }
        for i in 0..self.nodes.get(node).hull.limits.len() {
            let point = self.nodes.get(node).hull.limits[i];
            let other = self.near_on_mesh(&point);
            if length(&other.minus(&point)) > self.tolerance && self.tries(&point, SetKind::Limit) {
                return self.far(SetKind::Limit, point, other);
            }
        }
        if divisions == MAX_DIVISIONS || self.pairs == 0 {
            return Nearness::Open;
        }
        let parts = self.nodes.parts(node);
        self.all(parts, |cover, part| cover.limit(part, divisions + 1))
    }

    /// Whether all these parts are near; they are looked at while pairs are left.
    fn all<T>(
        &mut self,
        parts: impl IntoIterator<Item = T>,
        look: impl Fn(&mut Self, T) -> Nearness<FarPoint>,
    ) -> Nearness<FarPoint> {
        let mut ended = false;
        Nearness::all(parts.into_iter().map_while(|part| {
            let found = (!ended).then(|| look(self, part));
            ended = self.pairs == 0 && matches!(found, Some(Nearness::Open));
            found
        }))
    }

    fn tries(&mut self, point: &Point<f64>, from: SetKind) -> bool {
        self.tried += 1;
        self.tried <= MAX_TRIED && (self.is_far)(point, from)
    }

    fn far(&self, from: SetKind, point: Point<f64>, other: Point<f64>) -> Nearness<FarPoint> {
        Nearness::Far(FarPoint { unit: self.unit, from, point, other })
    }

    /// The normal of a piece of the limit, if the ring surrounds the piece in this direction.
    fn surrounded(&self, node: usize) -> Option<Direction> {
        let node = self.nodes.get(node);
        let direction = normal(&node.hull)?;
        let radius = node.radius + self.scene.slack;
        direction.winds(&self.ring.boundary, &node.centre, radius).then_some(direction)
    }

    /// 161 for a piece of the limit over the patches of the ring.
    fn is_over_mesh(&mut self, node: usize, direction: &Direction) -> bool {
        let node = self.nodes.get(node);
        let slack = self.scene.slack + node.hull.extra;
        let mut stack: Vec<(Patch, u32)> = self.patches.iter().map(|patch| (*patch, 0)).collect();
        while let Some((patch, divisions)) = stack.pop() {
            self.pairs = self.pairs.saturating_sub(1);
            if direction.separates(&node.hull.points, &patch, slack)
                || direction.gap(&node.hull.points, &patch, slack) <= self.tolerance
            {
                continue;
            }
            if divisions > 5 || patch.warp() < self.tolerance / 32.0 {
                return false;
            }
            stack.extend(patch.parts().map(|part| (part, divisions + 1)));
        }
        true
    }

    /// 162 for a piece of the limit and the patch that is nearest to its centre; where this is bilinear, also for its
    /// parts, as the distance of a part from its hull is a quarter.
    fn is_near_patch(&mut self, node: usize) -> bool {
        let node = self.nodes.get(node);
        let most = self.tolerance - self.scene.slack - node.hull.extra;
        let Some(mut patch) = nearest(&self.patches, &node.centre) else { return false };
        loop {
            self.pairs = self.pairs.saturating_sub(4);
            let warp = patch.warp();
            let is_near = |point| length(&patch.near(point).minus(point)) <= most - warp;
            if node.hull.points.iter().all(is_near) {
                return true;
            }
            if warp < self.tolerance / 32.0 || self.pairs == 0 {
                return false;
            }
            patch = nearest(&patch.parts(), &node.centre).unwrap_or(patch);
        }
    }

    fn near_on_mesh(&self, point: &Point<f64>) -> Point<f64> {
        let near = self.patches.iter().map(|patch| patch.near(point));
        near.min_by(|x, y| squared(x, point).total_cmp(&squared(y, point))).unwrap_or(*point)
    }

    /// Whether a patch is near the limit.
    fn mesh(&mut self, patch: &Patch, divisions: u32) -> Nearness<FarPoint> {
        let mut failed = self.roots[0];
        if let Some(direction) = self.direction {
            match self.is_over_limit(patch, &direction) {
                None => return Nearness::Near,
                Some(node) => failed = node,
            }
        }
        let (centre, radius) = ball(patch.corners());
        if divisions > 0 || self.direction.is_none() {
            let direction = normal(&self.nodes.get(failed).hull).filter(|direction| {
                direction.winds(&self.ring.boundary, &centre, radius + self.scene.slack)
            });
            if direction.is_some_and(|direction| self.is_over_limit(patch, &direction).is_none()) {
                return Nearness::Near;
            }
        }
        if self.is_near_limit_point(patch, &centre, radius) {
            return Nearness::Near;
        }
        for point in patch.corners().iter().chain([&centre]) {
            // The mean of the corners is a point of the patch.
            if let Some(other) = self.beyond_limit(point)
                && self.tries(point, SetKind::Mesh)
            {
                return self.far(SetKind::Mesh, *point, other);
            }
        }
        if divisions == MAX_DIVISIONS || self.pairs == 0 {
            return Nearness::Open;
        }
        self.all(patch.parts(), |cover, part| cover.mesh(&part, divisions + 1))
    }

    /// 161 for a patch under the limit of the ring; else a piece that keeps it from holding.
    fn is_over_limit(&mut self, patch: &Patch, direction: &Direction) -> Option<usize> {
        let slack = self.scene.slack;
        let (_, radius) = ball(patch.corners());
        let mut stack = self.roots.clone();
        while let Some(at) = stack.pop() {
            self.pairs = self.pairs.saturating_sub(1);
            let node = self.nodes.get(at);
            let slack = slack + node.hull.extra;
            if direction.separates(&node.hull.points, patch, slack)
                || direction.gap(&node.hull.points, patch, slack) <= self.tolerance
            {
                continue;
            }
            if node.radius < radius / 2.0 || node.hull.level > MAX_DIVISIONS + 2 || self.pairs == 0
            {
                return Some(at);
            }
            stack.extend(self.nodes.parts(at));
        }
        None
    }

    /// Whether all of a patch is near one limit point, as a ball is convex: this needs no ring that surrounds the patch.
    fn is_near_limit_point(&mut self, patch: &Patch, centre: &Point<f64>, radius: f64) -> bool {
        let enough = self.tolerance - self.scene.slack;
        if radius >= enough {
            return false;
        }
        let mut stack = self.roots.clone();
        while let Some(at) = stack.pop() {
            self.pairs = self.pairs.saturating_sub(1);
            let node = self.nodes.get(at);
            let is_near = |limit: &Point<f64>| {
                patch.corners().iter().all(|corner| length(&limit.minus(corner)) <= enough)
            };
            if node.hull.limits.iter().any(is_near) {
                return true;
            }
            let far = reach(centre, &node.hull, &node.centre, node.radius) > enough;
            if far || node.radius < radius / 2.0 || node.hull.level > MAX_DIVISIONS + 2 {
                continue;
            }
            if self.pairs == 0 {
                return false;
            }
            stack.extend(self.nodes.parts(at));
        }
        false
    }

    /// A limit point that is near, if the point is farther than the tolerance from all limits of the ring.
    fn beyond_limit(&mut self, point: &Point<f64>) -> Option<Point<f64>> {
        let mut stack = self.roots.clone();
        let (mut nearest, mut least) = (*point, f64::INFINITY);
        while let Some(at) = stack.pop() {
            self.pairs = self.pairs.saturating_sub(1);
            let node = self.nodes.get(at);
            for limit in &node.hull.limits {
                let distance = length(&limit.minus(point));
                if distance < least {
                    (nearest, least) = (*limit, distance);
                }
            }
            if least <= self.tolerance {
                return None;
            }
            if reach(point, &node.hull, &node.centre, node.radius) > self.tolerance {
                continue;
            }
            if node.radius < self.tolerance * 1e-4
                || node.hull.level > MAX_DIVISIONS + 2
                || self.pairs == 0
            {
                return None;
            }
            stack.extend(self.nodes.parts(at));
        }
        Some(nearest)
    }
}

/// A lower bound, up to rounding, of the distance of a point from a piece: by its ball, and by a plane before its hull.
pub(super) fn reach(point: &Point<f64>, hull: &Hull, centre: &Point<f64>, radius: f64) -> f64 {
    let way = centre.minus(point);
    let round = length(&way) - radius;
    let nearer = |x: &&Point<f64>, y: &&Point<f64>| squared(x, point).total_cmp(&squared(y, point));
    let nearest = hull.points.iter().min_by(nearer);
    let beyond = |way: &Point<f64>| {
        let Some(normal) = unit(way) else { return 0.0 };
        let heights = hull.points.iter().map(|x| dot(&normal, &x.minus(point)));
        heights.fold(f64::INFINITY, f64::min) - hull.extra
    };
    let to_nearest = nearest.map_or(0.0, |x| beyond(&x.minus(point)));
    round.max(beyond(&way)).max(to_nearest)
}

/// The patch whose hull is nearest to a point.
fn nearest(patches: &[Patch], point: &Point<f64>) -> Option<Patch> {
    let from = |patch: &Patch| squared(&patch.near(point), point);
    patches.iter().min_by(|left, right| from(left).total_cmp(&from(right))).copied()
}

/// The normal of a piece of the limit, from its corners.
fn normal(hull: &Hull) -> Option<Direction> {
    let normal = match &hull.limits[..] {
        [a, b, c] => cross(&b.minus(a), &c.minus(a)),
        corners if corners.len() >= 4 => {
            cross(&corners[2].minus(&corners[0]), &corners[3].minus(&corners[1]))
        }
        _ => return None,
    };
    Direction::new(&normal)
}
