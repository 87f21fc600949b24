//! Catmull–Clark, and the rules that differ from it in the weights of vertices.

use super::super::point::{Point, combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::circle::{circular, cosine};
use super::normal::Normal;
use super::weights::bicubic;
use crate::exact::{RealCyclotomic, Scalar};

/// The limit and the normal of a vertex between quadrilaterals without sharp edges.
pub(super) fn smooth(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    stencils: &Stencils,
) -> (Point<RealCyclotomic>, Option<Normal>) {
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
    (ring.position(stencils.of(ring.faces.len())), ring.normal())
}

/// The points around a vertex; face point i is between the edge points i and i + 1.
struct Ring<'a> {
    vertex: &'a Point<RealCyclotomic>,
    edges: Vec<&'a Point<RealCyclotomic>>,
    faces: Vec<&'a Point<RealCyclotomic>>,
}

impl Ring<'_> {
    /// The limit of the vertex, whose new point has these weights.
    fn position(&self, stencil: &[RealCyclotomic]) -> Point<RealCyclotomic> {
        let [v, e, f] = bicubic(stencil, self.faces.len());
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
}
