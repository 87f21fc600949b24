//! The shape of a piece: what does not depend on its points.

use super::rules::Rules;
use super::scheme::PieceScheme;
use super::surroundings::Surroundings;
use crate::exact::RealCyclotomic;
use std::sync::OnceLock;

/// What sums and products of a few bounds are multiplied by for their rounding.
pub(crate) const UP: f64 = 1.0 + 1e-14;

/// 4^−i.
pub(crate) fn quarter(i: u32) -> f64 {
    0.25_f64.powi(i32::try_from(i).unwrap_or(i32::MAX))
}

/// One part of a piece at the next level.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// Its shape.
    pub(crate) shape: usize,
    /// Its points, among those that the piece makes.
    pub(crate) points: Vec<usize>,
}

/// A piece with the faces around it, whatever its points are.
pub(crate) struct Shape {
    /// How many points there are.
    pub(crate) points: usize,
    pub(crate) parts: Vec<Part>,
    pub(crate) rules: Rules<f64>,
    /// How fast pieces of this shape tend to the limit.
    pub(crate) convergence: Convergence,
    pub(crate) scheme: PieceScheme,
    pub(crate) surroundings: Surroundings,
    /// The points of the next level that the parts need.
    pub(super) wanted: Vec<usize>,
    pub(crate) exact: OnceLock<Rules<RealCyclotomic>>,
}

impl Shape {
    /// The exact weights, computed when they are first needed.
    pub(crate) fn exact(&self) -> &Rules<RealCyclotomic> {
        self.exact.get_or_init(|| self.surroundings.rules(&self.wanted, &self.part_points()))
    }

    /// The points of the parts, among all points that the next level makes.
    pub(super) fn part_points(&self) -> Vec<Vec<usize>> {
        let points = |part: &Part| part.points.iter().map(|&at| self.wanted[at]).collect();
        self.parts.iter().map(points).collect()
    }

    pub(crate) fn is_regular(&self) -> bool {
        self.rules.regular.is_some()
    }

    /// The bound of a piece of this size, for the level that many levels later and all after it.
    pub(crate) fn bound(&self, size: f64, later: u32) -> f64 {
        let factor = if self.is_regular() { quarter(later) } else { self.convergence.bound(later) };
        factor * size * UP
    }

    /// The part that has the same shape, and the bound of [`bound`](Self::bound) for all other parts
    /// together: the piece itself has this size, and the level is that many levels after its own.
    pub(crate) fn others(&self, size: f64, later: u32) -> Option<(usize, f64)> {
        let (part, bounds) = self.convergence.repeated.as_ref()?;
        let bound = entry(bounds, later.checked_sub(1)?);
        Some((*part, bound * size * UP))
    }

    /// The longest row of weights.
    pub(crate) fn longest(&self) -> usize {
        self.rules.refined.iter().chain(&self.rules.limits).map(Vec::len).max().unwrap_or(0)
    }
}

/// G_0, G_1, … with D_i ≤ G_i N for every piece of the shape: D_i is the distance of the polygons of the
/// i-th level after it from the limit on the piece, N the greatest distance of its points from its
/// first point.
#[derive(Clone, Debug, Default)]
pub(crate) struct Convergence {
    pub(super) bounds: Vec<f64>,
    /// The part that has the same shape, and the same bounds for all other parts.
    pub(super) repeated: Option<(usize, Vec<f64>)>,
}

/// Entry i of a list. Beyond its end nothing is known.
fn entry(bounds: &[f64], i: u32) -> f64 {
    bounds.get(i as usize).copied().unwrap_or(f64::INFINITY)
}

impl Convergence {
    /// G_i; infinite beyond those that are known.
    pub(crate) fn bound(&self, i: u32) -> f64 {
        entry(&self.bounds, i)
    }

    pub(super) fn is_known(&self) -> bool {
        !self.bounds.is_empty()
    }
}
