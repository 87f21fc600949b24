//! Loop's refinement of triangles, and the rules of vertices and sharp edges that Catmull–Clark shares with it.

use super::super::connectivity::Edge;
use super::super::crease::VertexMask;
use super::super::error::MeshError;
use super::super::point::{Point, combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::super::texture::Texture;
use super::tagged::{self, blended, midpoint};
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
    let refined = PolygonMesh::new(points, faces)?;
    tagged::carry(mesh, refined, |face| 4 * face..4 * face + 4, Texture::triangles)
}

/// (3, 3, 1, 1)/8 of the ends and the opposite vertices; the midpoint where the edge is sharp.
fn edge_point<S: Scalar>(mesh: &PolygonMesh<S>, index: usize) -> Point<S> {
    let edge = &mesh.connectivity().edges()[index];
    let [p, q] = edge.ends.map(|end| &mesh.points()[end]);
    let Some(other) = edge.other else { return midpoint(p, q) };
    tagged::edge_point(mesh, index, || smooth_edge_point(mesh, edge, other))
}

fn smooth_edge_point<S: Scalar>(
    mesh: &PolygonMesh<S>,
    edge: &Edge,
    other: (usize, usize),
) -> Point<S> {
    let [p, q] = edge.ends.map(|end| &mesh.points()[end]);
    let opposite = |(face, i): (usize, usize)| &mesh.points()[mesh.faces()[face][(i + 2) % 3]];
    let [three, one] = [3, 1].map(|p| S::from_rational(&Rational::new(p, 8)));
    let wings = sum([opposite(edge.face), opposite(other)]);
    combination([(&three, &sum([p, q])), (&one, &wings)])
}

/// The new point of a vertex. Where it is smooth, it combines the vertex, the sum of its neighbours and,
/// if the rule has one, the `further` point, by the weights of the valence.
pub(super) fn vertex_point<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
    vertex: usize,
    further: impl Fn(&Star) -> Option<Point<S>>,
) -> Point<S> {
    let star = mesh.connectivity().star(vertex);
    let point = |mask: &VertexMask| match mask {
        VertexMask::Corner => mesh.points()[vertex].clone(),
        VertexMask::Crease(ends) => crease_point(mesh, vertex, *ends),
        VertexMask::Smooth => {
            let weights = stencils.of(star.valence());
            let neighbours = sum(star.neighbours.iter().map(|&v| &mesh.points()[v]));
            let further = further(&star);
            let points = [&mesh.points()[vertex], &neighbours].into_iter().chain(&further);
            combination(weights.iter().zip(points))
        }
    };
    let blend = mesh.tags().vertex_blend(mesh.connectivity(), vertex, &star);
    let now = point(&blend.now);
    match blend.next {
        None => now,
        Some((mask, rest)) => blended(&now, &point(&mask), &rest),
    }
}

/// (1, 6, 1)/8 of a vertex between these on a crease: the cubic B-spline.
fn crease_point<S: Scalar>(mesh: &PolygonMesh<S>, vertex: usize, ends: [usize; 2]) -> Point<S> {
    let [six, one] = [6, 1].map(|p| S::from_rational(&Rational::new(p, 8)));
    let ends = ends.map(|end| &mesh.points()[end]);
    combination([(&six, &mesh.points()[vertex]), (&one, &sum(ends))])
}
