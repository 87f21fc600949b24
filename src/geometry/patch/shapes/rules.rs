//! What one level makes of a piece and the faces around it, as rows of weights.

use super::bezier::Bezier;
use super::neighbourhood::{Neighbourhood, Piece};
use super::regular::{Bends, Layout, from_first, weighted};
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::mesh::{
    Connectivity, MeshScheme, Point, PolygonMesh, Star, Stencils, limit_weights, step_with,
    weighted_valences,
};
use crate::patch::hexes::Across;
use crate::patch::number::{Number, Row, index};
use std::collections::BTreeMap;

/// The weights of a shape.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rules<W> {
    /// The points of the next level that its parts need.
    pub(crate) refined: Vec<Row<W>>,
    /// For each part, the polygons of this level at the corners of the part.
    pub(crate) base: Vec<Vec<Row<W>>>,
    /// The same where the polygons of an earlier level are given at the corners of the piece.
    pub(crate) split: Vec<Vec<Row<W>>>,
    /// The corners between which the polygon of this level is linear or bilinear; `None` where it is so
    /// on the parts only.
    pub(crate) own: Option<Vec<Row<W>>>,
    /// Points of the polygon of this level between which it is linear or bilinear, each with its weights
    /// over the corners of the piece.
    pub(crate) nodes: Vec<(Row<W>, Row<W>)>,
    /// The limits at the corners of the piece.
    pub(crate) limits: Vec<Row<W>>,
    /// Of a piece of a solid that is the same in each layer, and not regular.
    pub(crate) across: Option<Across<W>>,
    /// Of a regular piece.
    pub(crate) regular: Option<(Bezier<W>, Bends<W>)>,
}

/// The faces around a piece, in numbers of their own.
pub(crate) struct Local {
    scheme: MeshScheme,
    mesh: PolygonMesh<()>,
    stencils: Stencils,
}

impl Local {
    /// # Panics
    /// Never: the faces around a piece are a disc.
    pub(crate) fn new(scheme: MeshScheme, neighbourhood: &Neighbourhood) -> Local {
        let points = vec![[(); 3]; neighbourhood.points.len()];
        let mesh = PolygonMesh::new(points, neighbourhood.faces.clone()).expect("a disc");
        let stencils = Stencils::new(scheme, weighted_valences(mesh.connectivity(), scheme));
        let tags = neighbourhood.sharp.tags(mesh.connectivity());
        Local { scheme, mesh: mesh.with_tags(tags), stencils }
    }

    /// The next level.
    pub(crate) fn refined(&self) -> PolygonMesh<f64> {
        self.step(vec![[0.0; 3]; self.mesh.points().len()])
    }

    /// The parts in the mesh of the next level.
    pub(crate) fn parts(&self, refined: &PolygonMesh<f64>) -> Vec<Piece> {
        match self.scheme {
            // The faces of the first face come first.
            MeshScheme::CatmullClark | MeshScheme::Bajaj => {
                (0..self.mesh.faces()[0].len()).map(Piece::Face).collect()
            }
            MeshScheme::Loop | MeshScheme::LoopWarren => (0..4).map(Piece::Face).collect(),
            MeshScheme::DooSabin => {
                // The only inner vertex has the last face, and its faces come in turn.
                let star = from_first(self.mesh.connectivity(), 0);
                let last = refined.faces().len() - 1;
                let mut first = vec![0];
                for face in self.mesh.faces() {
                    first.push(first[first.len() - 1] + face.len());
                }
                let vertex = |(face, corner): (&usize, &usize)| first[*face] + corner;
                let vertices = star.faces.iter().zip(&star.corners).map(vertex);
                vertices.map(|vertex| Piece::Vertex(vertex, last)).collect()
            }
        }
    }

    fn step<S: Number>(&self, points: Vec<Point<S>>) -> PolygonMesh<S> {
        let mesh = self.mesh.with_points(points);
        step_with(&mesh, self.scheme, &self.stencils.map(S::of)).expect("a small mesh")
    }

    /// The weights, where the parts need these points of the next level.
    pub(crate) fn rules<W: Number>(&self, wanted: &[usize]) -> Rules<W> {
        let corners = self.mesh.faces()[0].len();
        let plain = !self.mesh.tags().has_sharp();
        let layout = plain.then(|| Layout::of(self.scheme, self.mesh.connectivity(), corners));
        let layout = layout.flatten();
        let regular = layout.map(|layout| (layout.bezier(), layout.bends()));
        let refined =
            rows(self.mesh.points().len(), wanted, |units| self.step(units).points().to_vec());
        if self.scheme == MeshScheme::DooSabin {
            let star = from_first(self.mesh.connectivity(), 0);
            let around = VertexFaces { connectivity: self.mesh.connectivity(), star: &star };
            let base = (0..star.faces.len()).map(|i| around.quarter(i)).collect();
            let squares = star.faces.len() == 4;
            let split = if squares { (0..4).map(turned_quarter).collect() } else { Vec::new() };
            let nodes = if squares { around.nodes() } else { Vec::new() };
            let limits = (0..star.faces.len()).map(|i| around.centroid(i)).collect();
            return Rules { refined, base, split, own: None, nodes, limits, across: None, regular };
        }
        let corner = |i: usize| mean_of(&[i]);
        let split: Vec<Vec<Row<W>>> = parts_of_face(corners);
        let own: Vec<Row<W>> = (0..corners).map(corner).collect();
        let nodes = (0..corners).map(|i| (corner(i), corner(i))).collect();
        let limits = (0..corners).map(|i| self.limit(i)).collect();
        let base = split.clone();
        Rules { refined, base, split, own: Some(own), nodes, limits, across: None, regular }
    }

    /// The limit at a corner of a face.
    fn limit<W: Number>(&self, corner: usize) -> Row<W> {
        let weights = limit_weights(&self.mesh, corner, self.scheme, &self.stencils);
        let mut row: BTreeMap<usize, RealCyclotomic> = BTreeMap::new();
        for (point, weight) in weights.expect("a small mesh") {
            row.entry(point).and_modify(|sum| sum.accumulate(&weight)).or_insert(weight);
        }
        row.into_iter().map(|(point, weight)| (index(point), W::of(&weight))).collect()
    }
}

/// The rows of these points of the next level, which `refine` makes of `count` points.
pub(crate) fn rows<S: Number>(
    count: usize,
    wanted: &[usize],
    refine: impl Fn(Vec<Point<S>>) -> Vec<Point<S>>,
) -> Vec<Row<S>> {
    let mut rows: Vec<Row<S>> = vec![Vec::new(); wanted.len()];
    // Three unit vectors at a time, as the coordinates of points.
    for first in (0..count).step_by(3) {
        let unit = |point: usize| -> Point<S> {
            [0, 1, 2].map(|i| S::from_rational(&Rational::from(i64::from(point == first + i))))
        };
        let refined = refine((0..count).map(unit).collect());
        for (row, &point) in rows.iter_mut().zip(wanted) {
            for (i, weight) in (first..).zip(&refined[point]) {
                if !weight.vanishes() {
                    row.push((index(i), weight.clone()));
                }
            }
        }
    }
    rows
}

/// The mean of these points.
pub(crate) fn mean_of<W: Number>(points: &[usize]) -> Row<W> {
    let share = Rational::new(1, points.len());
    let row = |&point: &usize| (index(point), W::from_rational(&share));
    let single: Vec<Row<W>> = points.iter().map(|point| vec![row(point)]).collect();
    let one = W::from_rational(&Rational::one());
    weighted(&single.iter().map(|row| (one.clone(), row)).collect::<Vec<_>>())
}

/// The corners of the parts of a face: of a triangle three and the middle one, else one for each
/// vertex.
pub(crate) fn parts_of_face<W: Number>(corners: usize) -> Vec<Vec<Row<W>>> {
    let n = corners;
    let all: Vec<usize> = (0..n).collect();
    if n == 3 {
        let part =
            |i: usize| vec![mean_of(&[i]), mean_of(&[i, (i + 1) % 3]), mean_of(&[i, (i + 2) % 3])];
        let middle = (0..3).map(|i| mean_of(&[i, (i + 1) % 3])).collect();
        return (0..3).map(part).chain([middle]).collect();
    }
    quadrilaterals_of_face(n, &all)
}

/// The corners of the quadrilaterals of a face of n vertices.
pub(crate) fn quadrilaterals_of_face<W: Number>(n: usize, all: &[usize]) -> Vec<Vec<Row<W>>> {
    let part = |i: usize| {
        vec![
            mean_of(&[i]),
            mean_of(&[i, (i + 1) % n]),
            mean_of(all),
            mean_of(&[i, (i + n - 1) % n]),
        ]
    };
    (0..n).map(part).collect()
}

/// Part i of a square around a vertex, from the vertex to corner i.
fn turned_quarter<W: Number>(i: usize) -> Vec<Row<W>> {
    vec![
        mean_of(&[0, 1, 2, 3]),
        mean_of(&[i, (i + 3) % 4]),
        mean_of(&[i]),
        mean_of(&[i, (i + 1) % 4]),
    ]
}

/// The faces around a vertex, of Doo and Sabin's scheme.
struct VertexFaces<'a> {
    connectivity: &'a Connectivity,
    star: &'a Star,
}

impl VertexFaces<'_> {
    fn centroid<W: Number>(&self, i: usize) -> Row<W> {
        mean_of(&self.connectivity.faces()[self.star.faces[i]])
    }

    fn middle<W: Number>(&self, i: usize) -> Row<W> {
        mean_of(&[0, self.star.neighbours[i % self.star.faces.len()]])
    }

    /// The quarter of face i: the vertex, the middles of its edges, the centroid.
    fn quarter<W: Number>(&self, i: usize) -> Vec<Row<W>> {
        vec![mean_of(&[0]), self.middle(i), self.centroid(i), self.middle(i + 1)]
    }

    fn nodes<W: Number>(&self) -> Vec<(Row<W>, Row<W>)> {
        let corners = (0..4).map(|i| (self.centroid(i), mean_of(&[i])));
        let middles = (0..4).map(|i| (self.middle(i), mean_of(&[i, (i + 3) % 4])));
        corners.chain(middles).chain([(mean_of(&[0]), mean_of(&[0, 1, 2, 3]))]).collect()
    }
}
