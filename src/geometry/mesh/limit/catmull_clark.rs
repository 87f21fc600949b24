//! Catmull–Clark.

use super::super::error::MeshError;
use super::super::point::{Point, combination, difference, sum};
use super::super::polygon::PolygonMesh;
use super::super::refine::refine_mesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::{LimitPoint, Normal, boundary_limit, circular, cosine};
use crate::exact::{Rational, RealCyclotomic, Scalar};

pub(super) fn limits(
    mesh: &PolygonMesh<RealCyclotomic>,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    let count = mesh.points().len();
    if mesh.faces().iter().all(|face| face.len() == 4) {
        return Ok((0..count).map(|vertex| Some(limit(mesh, vertex))).collect());
    }
    // A refinement has quadrilaterals only, moves no limit, and keeps the numbers of the vertices.
    let refined = refine_mesh(mesh, MeshScheme::CatmullClark, 1)?;
    Ok((0..count).map(|vertex| Some(limit(&refined, vertex))).collect())
}

/// The limit point of a vertex of a mesh of quadrilaterals.
fn limit(mesh: &PolygonMesh<RealCyclotomic>, vertex: usize) -> LimitPoint {
    let star = mesh.connectivity().star(vertex);
    let ring = Ring {
        vertex: &mesh.points()[vertex],
        edges: star.neighbours.iter().map(|&v| &mesh.points()[v]).collect(),
        faces: star
            .faces
            .iter()
            .zip(&star.corners)
            .map(|(&face, &corner)| &mesh.points()[mesh.faces()[face][(corner + 2) % 4]])
            .collect(),
    };
    if star.boundary {
        let position = boundary_limit(mesh, vertex, star.boundary_neighbours());
        let tangents = ring.at_boundary(&star);
        return LimitPoint { position, normal: tangents.as_ref().and_then(Normal::of) };
    }
    LimitPoint { position: ring.position(), normal: ring.normal() }
}

/// The points around a vertex; face point i is between the edge points i and i + 1.
struct Ring<'a> {
    vertex: &'a Point<RealCyclotomic>,
    edges: Vec<&'a Point<RealCyclotomic>>,
    faces: Vec<&'a Point<RealCyclotomic>>,
}

impl Ring<'_> {
    /// (n² v + 4 Σ e_i + Σ f_i)/(n(n + 5)).
    fn position(&self) -> Point<RealCyclotomic> {
        let n = self.faces.len();
        let [v, e, f] = [n * n, 4, 1].map(|p| RealCyclotomic::from(Rational::new(p, n * (n + 5))));
        let (edges, faces) = (sum(self.edges.iter().copied()), sum(self.faces.iter().copied()));
        combination([(&v, self.vertex), (&e, &edges), (&f, &faces)])
    }

    /// The cross product of two tangents. The first is A Σ cos(2πi/n) e_i + Σ (cos(2πi/n) +
    /// cos(2π(i + 1)/n)) f_i, with A = 1 + c + √((1 + c)(9 + c)), c = cos(2π/n); the second has i −
    /// 1 in place of i in the cosines.
    ///
    /// For n = 4 the tangents are derivatives of the bicubic B-spline, and A = 4.
    fn normal(&self) -> Option<Normal> {
        let n = self.faces.len();
        let c = cosine(1, n);
        let edges = circular(&self.edges);
        let faces = self.face_sums();
        let one = RealCyclotomic::from(1);
        let tangents = |factor: &RealCyclotomic| {
            [0, 1].map(|i| combination([(factor, &edges[i]), (&one, &faces[i])]))
        };
        if n == 4 {
            return Normal::of(&tangents(&RealCyclotomic::from(4)));
        }
        let plain = c.plus(&one);
        let radicand = plain.times(&c.plus(&RealCyclotomic::from(9)));
        Normal::with_root(&tangents(&plain), &edges, radicand)
    }

    /// Σ (cos(2πi/n) + cos(2π(i + 1)/n)) f_i, and the sum with i − 1 in place of i in the cosines.
    /// Each is a sum of [`circular`] over f_i and over f_{i−1}, since each f_i has two cosines.
    fn face_sums(&self) -> [Point<RealCyclotomic>; 2] {
        let mut before = self.faces.clone();
        before.rotate_right(1);
        let (here, there) = (circular(&self.faces), circular(&before));
        [0, 1].map(|i| sum([&here[i], &there[i]]))
    }

    /// At a boundary vertex of two faces: e₀ − e₂ along the boundary, and across it
    /// (f₀ − e₀) + 4(e₁ − v) + (f₁ − e₂). There the surface is a bicubic B-spline with one more row of
    /// points, 2v − e₁ and so on, outside.
    fn at_boundary(&self, star: &Star) -> Option<[Point<RealCyclotomic>; 2]> {
        if star.faces.len() != 2 {
            return None;
        }
        let (four, one) = (RealCyclotomic::from(4), RealCyclotomic::from(1));
        let [e0, e1, e2] = [self.edges[0], self.edges[1], self.edges[2]];
        let sides = difference(&sum([self.faces[0], self.faces[1]]), &sum([e0, e2]));
        let across = combination([(&four, &difference(e1, self.vertex)), (&one, &sides)]);
        Some([difference(e0, e2), across])
    }
}
