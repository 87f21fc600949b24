//! Catmull–Clark.

use super::super::error::MeshError;
use super::super::point::{Point, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::super::texture::Texture;
use super::tagged::{self, midpoint};
use super::triangles::vertex_point;
use crate::exact::{Rational, Scalar};

/// One level: the points of vertices, edges and faces in this order, and a quadrilateral for
/// each vertex of each face.
pub(super) fn step<S: Scalar>(
    mesh: &PolygonMesh<S>,
    stencils: &Stencils<S>,
) -> Result<PolygonMesh<S>, MeshError> {
    let connectivity = mesh.connectivity();
    let (vertices, edges) = (connectivity.point_count(), connectivity.edges().len());
    let centres: Vec<Point<S>> =
        mesh.faces().iter().map(|face| mean(face.iter().map(|&v| &mesh.points()[v]))).collect();
    let mut points = Vec::with_capacity(vertices + edges + centres.len());
    let around = |star: &Star| Some(sum(star.faces.iter().map(|&face| &centres[face])));
    points.extend((0..vertices).map(|vertex| vertex_point(mesh, stencils, vertex, around)));
    points.extend((0..edges).map(|edge| edge_point(mesh, &centres, edge)));
    points.extend(centres);
    let mut faces = Vec::with_capacity(connectivity.corner_count());
    for (face, corners) in mesh.faces().iter().enumerate() {
        let own = connectivity.face_edges(face);
        for (i, &vertex) in corners.iter().enumerate() {
            let before = own[(i + own.len() - 1) % own.len()];
            let face = vertices + edges + face;
            faces.push(vec![vertex, vertices + own[i], face, vertices + before]);
        }
    }
    let mut first = Vec::with_capacity(mesh.faces().len() + 1);
    first.push(0);
    first.extend(mesh.faces().iter().scan(0, |total, face| {
        *total += face.len();
        Some(*total)
    }));
    let refined = PolygonMesh::new(points, faces)?;
    tagged::carry(mesh, refined, |face| first[face]..first[face + 1], Texture::quadrilaterals)
}

fn mean<'a, S: Scalar + 'a>(points: impl ExactSizeIterator<Item = &'a Point<S>>) -> Point<S> {
    let share = S::from_rational(&Rational::new(1, points.len()));
    sum(points).map(|x| x.times(&share))
}

fn edge_point<S: Scalar>(mesh: &PolygonMesh<S>, centres: &[Point<S>], index: usize) -> Point<S> {
    let edge = &mesh.connectivity().edges()[index];
    let [p, q] = edge.ends.map(|end| &mesh.points()[end]);
    let Some((other, _)) = edge.other else { return midpoint(p, q) };
    tagged::edge_point(mesh, index, || {
        mean([p, q, &centres[edge.face.0], &centres[other]].into_iter())
    })
}
