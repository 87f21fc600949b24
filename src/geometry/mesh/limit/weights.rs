//! The limit of a vertex as weights of the points around it.

use super::super::crease::VertexMask;
use super::super::error::MeshError;
use super::super::point::{Point, combination};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::settle::{falls, settled};
use super::{catmull_clark, dart, loops};
use crate::exact::{Rational, RealCyclotomic};
use std::collections::BTreeSet;

/// The weights of points. A point may be met twice.
pub(crate) type LimitWeights = Vec<(usize, RealCyclotomic)>;

/// The weights in the limit of a vertex. For Catmull–Clark all faces at it are quadrilaterals, and `stencils` has the
/// weights of its valence.
///
/// # Errors
/// When the faces around a vertex whose sharpness falls are too much work.
pub(crate) fn limit_weights<S>(
    mesh: &PolygonMesh<S>,
    vertex: usize,
    scheme: MeshScheme,
    stencils: &Stencils,
) -> Result<LimitWeights, MeshError> {
    let connectivity = mesh.connectivity();
    let star = connectivity.star(vertex);
    if !falls(mesh, vertex, &star) {
        let mask = mesh.tags().vertex_mask(connectivity, vertex, &star);
        return Ok(settled_weights(mesh, vertex, &star, &mask, scheme, stencils));
    }
    // Only points of faces at the vertex count. Three unit vectors at a time, as the coordinates of points.
    let around: BTreeSet<usize> =
        star.faces.iter().flat_map(|&face| &mesh.faces()[face]).copied().collect();
    let around: Vec<usize> = around.into_iter().collect();
    let mut weights = LimitWeights::new();
    for three in around.chunks(3) {
        let unit = |point: usize| -> Point<RealCyclotomic> {
            [0, 1, 2].map(|i| i64::from(three.get(i) == Some(&point)).into())
        };
        let units = mesh.with_points((0..connectivity.point_count()).map(unit).collect());
        let (part, at) = settled(&units, vertex, scheme)?;
        let own = part.connectivity().star(at);
        let mask = part.tags().vertex_mask(part.connectivity(), at, &own);
        let own = settled_weights(&part, at, &own, &mask, scheme, stencils);
        weights.extend(three.iter().copied().zip(position(&part, &own)));
    }
    Ok(weights)
}

/// The weights where no sharpness at the vertex falls.
pub(super) fn settled_weights<S>(
    mesh: &PolygonMesh<S>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
    scheme: MeshScheme,
    stencils: &Stencils,
) -> LimitWeights {
    if *mask != VertexMask::Smooth {
        return sharp_weights(vertex, mask);
    }
    let n = star.faces.len();
    let (own, edges, faces) = match dart_edge(mesh, star) {
        Some(first) => dart::weights(scheme, n, first, stencils.of(n)),
        None if scheme.is_triangular() => {
            let [own, edge] = loops::limit_weights(n, &stencils.of(n)[1]);
            (own, vec![edge; n], Vec::new())
        }
        None => {
            let [own, edge, face] = catmull_clark::limit_weights(stencils.of(n), n);
            (own, vec![edge; n], vec![face; n])
        }
    };
    let opposite = |i: usize| {
        let vertices = &mesh.faces()[star.faces[i]];
        vertices[(star.corners[i] + 2) % vertices.len()]
    };
    let edges = star.neighbours.iter().copied().zip(edges);
    let faces = faces.into_iter().enumerate().map(|(i, weight)| (opposite(i), weight));
    std::iter::once((vertex, own)).chain(edges).chain(faces).collect()
}

/// The weights by a mask that is not smooth.
pub(super) fn sharp_weights(vertex: usize, mask: &VertexMask) -> LimitWeights {
    let number = |p: usize, q: usize| RealCyclotomic::from(Rational::new(p, q));
    match mask {
        VertexMask::Crease(ends) => {
            let ends = ends.map(|end| (end, number(1, 6)));
            std::iter::once((vertex, number(4, 6))).chain(ends).collect()
        }
        _ => vec![(vertex, number(1, 1))],
    }
}

/// The point with these weights.
pub(super) fn position(
    mesh: &PolygonMesh<RealCyclotomic>,
    weights: &LimitWeights,
) -> Point<RealCyclotomic> {
    combination(weights.iter().map(|(point, weight)| (weight, &mesh.points()[*point])))
}

/// Which edge of a smooth vertex is sharp, if one is.
pub(super) fn dart_edge<S>(mesh: &PolygonMesh<S>, star: &Star) -> Option<usize> {
    let sharp = |&edge: &usize| mesh.tags().edge(mesh.connectivity(), edge).is_some();
    if mesh.tags().has_sharp() { star.edges.iter().position(sharp) } else { None }
}
