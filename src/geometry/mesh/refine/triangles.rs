//! Loop's refinement of triangles, and the boundary rules that Catmull–Clark shares with it.

use super::super::error::MeshError;
use super::super::point::{Point, combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::super::stencil::Stencils;
use crate::exact::{Rational, Scalar};

/// One level: the points of vertices and edges in this order, and four triangles for each.
pub(super) fn step<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
) -> Result<PolygonMesh<S>, MeshError> {
    let connectivity = mesh.connectivity();
    let (vertices, edges) = (connectivity.point_count(), connectivity.edges().len());
    let mut points = Vec::with_capacity(vertices + edges);
    points.extend((0..vertices).map(|vertex| vertex_point(mesh, stencils, vertex, |_| None)));
    points.extend((0..edges).map(|edge| edge_point(mesh, edge)));
    let mut faces = Vec::with_capacity(4 * connectivity.faces().len());
    for (face, corners) in mesh.faces().iter().enumerate() {
        let own = connectivity.face_edges(face);
        for i in 0..3 {
            faces.push(vec![corners[i], vertices + own[i], vertices + own[(i + 2) % 3]]);
        }
        faces.push(own.iter().map(|edge| vertices + edge).collect());
    }
    PolygonMesh::new(points, faces)
}

/// (3, 3, 1, 1)/8 of the ends and the opposite vertices; at the boundary the midpoint.
fn edge_point<S: Scalar>(mesh: &PolygonMesh<S>, edge: usize) -> Point<S> {
    let edge = &mesh.connectivity().edges()[edge];
    let [p, q] = edge.ends.map(|end| &mesh.points()[end]);
    let Some(other) = edge.other else { return midpoint(p, q) };
    let opposite = |(face, i): (usize, usize)| &mesh.points()[mesh.faces()[face][(i + 2) % 3]];
    let [three, one] = [3, 1].map(|p| S::from_rational(&Rational::new(p, 8)));
    let wings = sum([opposite(edge.face), opposite(other)]);
    combination([(&three, &sum([p, q])), (&one, &wings)])
}

/// The new point of a vertex. Inside, it combines the vertex, the sum of its neighbours and, if the
/// rule has one, the `further` point, by the weights of the valence.
pub(super) fn vertex_point<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
    vertex: usize,
    further: impl FnOnce(&Star) -> Option<Point<S>>,
) -> Point<S> {
    let star = mesh.connectivity().star(vertex);
    if star.boundary {
        return boundary_vertex(mesh, vertex, &star);
    }
    let weights = stencils.of(star.valence());
    let neighbours = sum(star.neighbours.iter().map(|&v| &mesh.points()[v]));
    let further = further(&star);
    let points = [&mesh.points()[vertex], &neighbours].into_iter().chain(&further);
    combination(weights.iter().zip(points))
}

/// (p + q)/2.
pub(super) fn midpoint<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Point<S> {
    let half = S::from_rational(&Rational::new(1, 2));
    combination([(&half, p), (&half, q)])
}

/// (1, 6, 1)/8 of the boundary polygon: the cubic B-spline.
pub(super) fn boundary_vertex<S: Scalar>(
    mesh: &PolygonMesh<S>,
    vertex: usize,
    star: &Star,
) -> Point<S> {
    let [six, one] = [6, 1].map(|p| S::from_rational(&Rational::new(p, 8)));
    let ends = star.boundary_neighbours().map(|end| &mesh.points()[end]);
    combination([(&six, &mesh.points()[vertex]), (&one, &sum(ends))])
}
