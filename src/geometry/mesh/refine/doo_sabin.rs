//! Doo–Sabin.

use super::super::connectivity::Connectivity;
use super::super::error::MeshError;
use super::super::point::{Point, combination};
use super::super::polygon::PolygonMesh;
use super::super::stencil::Stencils;
use crate::exact::Scalar;

/// One level: a point for each vertex of each face; a face for each face, each inner edge and
/// each inner vertex, in this order.
pub(super) fn step<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
) -> Result<PolygonMesh<S>, MeshError> {
    let connectivity = mesh.connectivity();
    let mut points = Vec::with_capacity(connectivity.corner_count());
    for face in mesh.faces() {
        points.extend((0..face.len()).map(|corner| corner_point(mesh, stencils, face, corner)));
    }
    PolygonMesh::new(points, faces(connectivity))
}

/// Σ_j a_j x_{i+j} over the vertices of the face.
fn corner_point<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
    face: &[usize],
    corner: usize,
) -> Point<S> {
    let turned = (0..face.len()).map(|j| &mesh.points()[face[(corner + j) % face.len()]]);
    combination(stencils.of(face.len()).iter().zip(turned))
}

fn faces(connectivity: &Connectivity) -> Vec<Vec<usize>> {
    let mut first = Vec::with_capacity(connectivity.faces().len());
    let mut next = 0;
    for face in connectivity.faces() {
        first.push(next);
        next += face.len();
    }
    // The point of vertex i of a face; i may be one too great.
    let point = |face: usize, i: usize| first[face] + i % connectivity.faces()[face].len();
    let mut faces: Vec<Vec<usize>> = Vec::new();
    for (face, vertices) in connectivity.faces().iter().enumerate() {
        faces.push((0..vertices.len()).map(|i| point(face, i)).collect());
    }
    for edge in connectivity.edges() {
        let Some((g, j)) = edge.other else { continue };
        let (f, i) = edge.face;
        faces.push(vec![point(f, i + 1), point(f, i), point(g, j + 1), point(g, j)]);
    }
    for vertex in 0..connectivity.point_count() {
        let star = connectivity.star(vertex);
        if !star.boundary {
            let corners = star.faces.iter().zip(&star.corners);
            faces.push(corners.map(|(&face, &corner)| point(face, corner)).collect());
        }
    }
    faces
}
