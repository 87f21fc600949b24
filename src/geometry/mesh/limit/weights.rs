//! The limit of a vertex as weights of the points around it.

use super::super::crease::VertexMask;
use super::super::error::MeshError;
use super::super::point::{Point, combination};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::dart;
use super::settle::{falls, settled};
use crate::exact::{Rational, Real as _, RealCyclotomic, Scalar as _};
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
            let [own, edge] = triangular(n, &stencils.of(n)[1]);
            (own, vec![edge; n], Vec::new())
        }
        None => {
            let [own, edge, face] = bicubic(stencils.of(n), n);
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

/// The weights of a vertex of valence n, of each edge point and of each opposite vertex of its quadrilaterals in
/// its limit: the left eigenvector for 1.
///
/// With b and g, n times the weights of an edge point and of a face point in the new vertex, the weights 1 of the
/// vertex, y of all edge points and z of all opposite vertices satisfy y = 2b + g + z and 5z = 2b + 3g.
pub(super) fn bicubic(stencil: &[RealCyclotomic], n: usize) -> [RealCyclotomic; 3] {
    let times = |x: &RealCyclotomic, p: usize, q: usize| x.times(&Rational::new(p, q).into());
    let (b, g) = (times(&stencil[1], n, 1), times(&stencil[2], n, 1));
    let z = times(&b, 2, 5).plus(&times(&g, 3, 5));
    let y = times(&b, 2, 1).plus(&g).plus(&z);
    let one = RealCyclotomic::from(1);
    let total = one.plus(&y).plus(&z);
    let share = one.over(&total);
    [share.clone(), times(&y.times(&share), 1, n), times(&z.times(&share), 1, n)]
}

/// The weights of a vertex and of each neighbour in the limit: 1 − nω and
/// ω = 1/(n + 3/(8β)) = 8β/(8nβ + 3).
pub(super) fn triangular(n: usize, beta: &RealCyclotomic) -> [RealCyclotomic; 2] {
    let number = |n: usize| RealCyclotomic::from(Rational::from(n));
    let eight = beta.times(&number(8));
    let omega = eight.over(&eight.times(&number(n)).plus(&number(3)));
    [number(1).minus(&omega.times(&number(n))), omega]
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
