//! Loop.

use super::super::crease::VertexMask;
use super::super::field::inner_valences;
use super::super::point::{Point, combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::{LimitPoint, Normal, circular, dart, sharp_limit};
use crate::exact::{Rational, Real, RealCyclotomic, Scalar};

/// Limits of the vertices of a mesh.
pub(super) struct Limits {
    stencils: Stencils,
}

impl Limits {
    pub(super) fn new(mesh: &PolygonMesh<RealCyclotomic>, scheme: MeshScheme) -> Limits {
        let valences = inner_valences(mesh.connectivity()).map(|(_, n)| n);
        Limits { stencils: Stencils::new(scheme, valences) }
    }

    /// The limit of a vertex whose sharp edges are infinitely sharp.
    pub(super) fn limit(
        &self,
        mesh: &PolygonMesh<RealCyclotomic>,
        vertex: usize,
        star: &Star,
        mask: &VertexMask,
    ) -> LimitPoint {
        if *mask != VertexMask::Smooth {
            return sharp_limit(mesh, vertex, star, mask, false);
        }
        let point = &mesh.points()[vertex];
        let mut around: Vec<_> = star.neighbours.iter().map(|&v| &mesh.points()[v]).collect();
        let n = star.valence();
        let beta = &self.stencils.of(n)[1];
        if let Some(first) = dart(mesh, star) {
            around.rotate_left(first);
            let position = dart_limit(point, &around, beta);
            return LimitPoint { position, normal: None, sectors: Vec::new() };
        }
        let weights = limit_weights(n, beta);
        let position = combination(weights.iter().zip([point, &sum(around.iter().copied())]));
        LimitPoint { position, normal: Normal::of(&circular(&around)), sectors: Vec::new() }
    }
}

/// The limit where the first edge is sharp.
fn dart_limit(
    point: &Point<RealCyclotomic>,
    around: &[&Point<RealCyclotomic>],
    beta: &RealCyclotomic,
) -> Point<RealCyclotomic> {
    let weights = super::dart::loops(around.len());
    let edges: Vec<RealCyclotomic> = weights.into_iter().map(RealCyclotomic::from).collect();
    let one = RealCyclotomic::from(1);
    let total = edges.iter().fold(RealCyclotomic::zero(), |sum, x| sum.plus(x));
    let total = one.plus(&total.times(beta));
    let edges = combination(edges.iter().zip(around.iter().copied()));
    combination([(&one.over(&total), point), (&beta.over(&total), &edges)])
}

/// The weights of a vertex and of each neighbour in the limit: 1 − nω and
/// ω = 1/(n + 3/(8β)) = 8β/(8nβ + 3).
pub(crate) fn limit_weights(n: usize, beta: &RealCyclotomic) -> [RealCyclotomic; 2] {
    let number = |n: usize| RealCyclotomic::from(Rational::from(n));
    let eight = beta.times(&number(8));
    let omega = eight.over(&eight.times(&number(n)).plus(&number(3)));
    [number(1).minus(&omega.times(&number(n))), omega]
}
