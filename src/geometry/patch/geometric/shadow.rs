//! Projections along a direction, and the gap between two things of which one is over the other
//! (`proofs/THEOREMS.md`, 160).

use super::super::number::Vector as _;
use super::patch::{Patch, cross, dot, unit};
use crate::mesh::Point;
use crate::patch::shapes::shape::UP;

type Flat = [f64; 2];

/// A direction of length 1, with two across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    pub(super) along: Point<f64>,
    across: [Point<f64>; 2],
}

impl Direction {
    /// `None` for the vector of length 0.
    pub(super) fn new(along: &Point<f64>) -> Option<Direction> {
        let along = unit(along)?;
        let least = (0..3).min_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs()))?;
        let axis = [0, 1, 2].map(|i| if i == least { 1.0 } else { 0.0 });
        let first = unit(&cross(&along, &axis))?;
        let second = cross(&along, &first);
        Some(Direction { along, across: [first, second] })
    }

    fn shadow(&self, point: &Point<f64>) -> Flat {
        [dot(&self.across[0], point), dot(&self.across[1], point)]
    }

    /// Whether the shadow of the hull of some points and that of a patch have surely no point in common.
    pub(super) fn separates(&self, points: &[Point<f64>], patch: &Patch, slack: f64) -> bool {
        let corners = patch.corners();
        let mut shadows = [[0.0; 2]; 4];
        for (shadow, corner) in shadows.iter_mut().zip(corners) {
            *shadow = self.shadow(corner);
        }
        let shadows = &shadows[..corners.len()];
        // Boxes first.
        for i in 0..2 {
            let across = &self.across[i];
            let [low, high] = range(shadows.iter().map(|shadow| shadow[i]));
            let [least, most] = range(points.iter().map(|point| dot(across, point)));
            if least > high + slack || most < low - slack {
                return true;
            }
        }
        (0..shadows.len()).any(|i| {
            let (from, to) = (shadows[i], shadows[(i + 1) % shadows.len()]);
            let normal = [to[1] - from[1], from[0] - to[0]];
            let size = normal[0].hypot(normal[1]);
            if size == 0.0 {
                return false;
            }
            let normal = normal.map(|x| x / size);
            let height = |shadow: &Flat| {
                normal[0] * (shadow[0] - from[0]) + normal[1] * (shadow[1] - from[1])
            };
            let way =
                [0, 1, 2].map(|k| normal[0] * self.across[0][k] + normal[1] * self.across[1][k]);
            let start = normal[0] * from[0] + normal[1] * from[1];
            let [low, high] = range(shadows.iter().map(height));
            let [least, most] = range(points.iter().map(|point| dot(&way, point) - start));
            least > high + slack || most < low - slack
        })
    }

    /// A bound of |p − q| for all points p of the hull of the points and q of that of a patch that
    /// differ by a multiple of the direction; infinite where the patch is steep.
    pub(super) fn gap(&self, points: &[Point<f64>], patch: &Patch, slack: f64) -> f64 {
        let Some(normal) = patch.normal() else { return f64::INFINITY };
        let steep = dot(&normal, &self.along).abs();
        if steep < 0.05 {
            return f64::INFINITY;
        }
        let from = &patch.corners[0];
        let height = |point: &Point<f64>| dot(&normal, &point.minus(from));
        let [low, high] = range(patch.corners().iter().map(height));
        let [least, most] = range(points.iter().map(height));
        ((most - low).max(high - least) + slack) / (steep - 1e-15) * UP
    }

    /// Whether the shadow of a closed chain of segments winds around every point that is at most `radius` from
    /// the shadow of the centre. Each segment may be moved by its own distance.
    pub(super) fn winds(&self, chain: &[Segment], centre: &Point<f64>, radius: f64) -> bool {
        let centre = self.shadow(centre);
        let mut angle = 0.0_f64;
        for Segment { ends, moved } in chain {
            let [p, q] = ends.map(|end| {
                let shadow = self.shadow(&end);
                [shadow[0] - centre[0], shadow[1] - centre[1]]
            });
            if from_origin(p, q) <= radius + moved {
                return false;
            }
            angle += (p[0] * q[1] - p[1] * q[0]).atan2(p[0] * q[0] + p[1] * q[1]);
        }
        // A multiple of 2π, up to rounding.
        angle.abs() > std::f64::consts::PI
    }
}

/// A segment of the boundary of a part of a mesh, and how far the limit may be from it at its own
/// parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub(super) ends: [Point<f64>; 2],
    pub(super) moved: f64,
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// The distance of a segment from the origin.
fn from_origin(p: Flat, q: Flat) -> f64 {
    let way = [q[0] - p[0], q[1] - p[1]];
    let square = way[0] * way[0] + way[1] * way[1];
    let t = if square > 0.0 {
        (-(p[0] * way[0] + p[1] * way[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p[0] + t * way[0]).hypot(p[1] + t * way[1]) * (1.0 - 1e-12)
}
