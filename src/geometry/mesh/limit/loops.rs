//! Loop.

use super::super::field::inner_valences;
use super::super::point::{Point, combination, difference, sum};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::{LimitPoint, Normal, boundary_limit, circular};
use crate::exact::{Rational, Real, RealCyclotomic, Scalar};

pub(super) fn limits(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
) -> Vec<Option<LimitPoint>> {
    let connectivity = mesh.connectivity();
    let stencils = Stencils::new(scheme, inner_valences(connectivity).map(|(_, n)| n));
    let limit = |vertex| {
        let star = connectivity.star(vertex);
        let point = &mesh.points()[vertex];
        let around: Vec<_> = star.neighbours.iter().map(|&v| &mesh.points()[v]).collect();
        if star.boundary {
            let position = boundary_limit(mesh, vertex, star.boundary_neighbours());
            let tangents = at_boundary(point, &around, &star);
            return Some(LimitPoint { position, normal: tangents.as_ref().and_then(Normal::of) });
        }
        let weights = limit_weights(star.valence(), &stencils.of(star.valence())[1]);
        let position = combination(weights.iter().zip([point, &sum(around.iter().copied())]));
        Some(LimitPoint { position, normal: Normal::of(&circular(&around)) })
    };
    (0..mesh.points().len()).map(limit).collect()
}

/// The weights of a vertex and of each neighbour in the limit: 1 − nω and
/// ω = 1/(n + 3/(8β)) = 8β/(8nβ + 3).
pub(crate) fn limit_weights(n: usize, beta: &RealCyclotomic) -> [RealCyclotomic; 2] {
    let number = |n: usize| RealCyclotomic::from(Rational::from(n));
    let eight = beta.times(&number(8));
    let omega = eight.over(&eight.times(&number(n)).plus(&number(3)));
    [number(1).minus(&omega.times(&number(n))), omega]
}

/// At a boundary vertex of three triangles, e₀ − e₃ along the boundary, and across it
/// 2(e₁ + e₂) − 2v − e₀ − e₃: both are halved by each refinement.
fn at_boundary(
    point: &Point<RealCyclotomic>,
    around: &[&Point<RealCyclotomic>],
    star: &Star,
) -> Option<[Point<RealCyclotomic>; 2]> {
    if star.faces.len() != 3 {
        return None;
    }
    let inner = sum([around[1], around[2], around[1], around[2]]);
    let outer = sum([point, point, around[0], around[3]]);
    Some([difference(around[0], around[3]), difference(&inner, &outer)])
}
