//! Loop.

use super::super::point::{Point, combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::circle::circular;
use super::normal::Normal;
use super::weights::triangular;
use crate::exact::RealCyclotomic;

/// The limit and the normal of a vertex without sharp edges.
pub(super) fn smooth(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    stencils: &Stencils,
) -> (Point<RealCyclotomic>, Option<Normal>) {
    let around: Vec<_> = star.neighbours.iter().map(|&v| &mesh.points()[v]).collect();
    let n = star.valence();
    let weights = triangular(n, &stencils.of(n)[1]);
    let points = [&mesh.points()[vertex], &sum(around.iter().copied())];
    (combination(weights.iter().zip(points)), Normal::of(&circular(&around)))
}
