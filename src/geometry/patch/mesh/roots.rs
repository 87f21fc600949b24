//! A mesh as pieces of level 1.

use super::piece::LevelPiece;
use crate::mesh::{Connectivity, MeshError, MeshScheme, PolygonMesh};
use crate::patch::number::{Number, Row, Vector, index};
use crate::patch::shapes::fans::{Fans, Regular};
use crate::patch::shapes::library::Shapes;
use crate::patch::shapes::neighbourhood::{Neighbourhood, Piece};
use crate::patch::shapes::rules::{parts_of_face, quadrilaterals_of_face};
use std::collections::BTreeMap;

/// The most shapes of neighbourhoods that weights are computed for, where there are creases.
const MAX_SHAPES: usize = 5_000;

/// A piece of level 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    /// The face of the control mesh that it is on.
    pub(crate) face: usize,
    /// Which part of that face: for Doo–Sabin, which of its vertices.
    pub(crate) part: usize,
    pub(crate) shape: usize,
    /// Where its points begin in the list of all.
    pub(crate) first: usize,
}

/// The pieces of level 1, and the numbers of their points in the mesh of that level.
pub(crate) struct Roots {
    pub(crate) all: Vec<Root>,
    pub(crate) points: Vec<u32>,
}

impl Roots {
    /// The pieces of a mesh, and their shapes. Holes have none.
    ///
    /// # Errors
    /// When creases make too many different shapes.
    pub(crate) fn of<S>(
        scheme: MeshScheme,
        control: &Connectivity,
        refined: &PolygonMesh<S>,
        shapes: &mut Shapes,
    ) -> Result<Roots, MeshError> {
        let mut roots = Roots { all: Vec::new(), points: Vec::new() };
        let (connectivity, tags) = (refined.connectivity(), refined.tags());
        let holes = tags.holes(connectivity);
        let mut regular: Option<Regular> = None;
        for (face, part, piece) in pieces(scheme, control) {
            let around = match piece {
                Piece::Face(own) if holes.contains(&own) => continue,
                Piece::Face(own) => Fans::of(connectivity, tags, own),
                Piece::Vertex(..) => None,
            };
            let first = roots.points.len();
            if let (Some(regular), Some(fans)) = (&regular, &around)
                && regular.has(fans)
            {
                regular.points(connectivity, fans, &mut roots.points);
                roots.all.push(Root { face, part, shape: regular.shape, first });
                continue;
            }
            let neighbourhood = Neighbourhood::of(connectivity, tags, piece);
            let shape = shapes.shape(&neighbourhood);
            if tags.has_sharp() && shapes.count() > MAX_SHAPES {
                let reason = format!(
                    "faces meet with creases in more than {MAX_SHAPES} different ways, which is too many for bounds \
                     of distances; take fewer different values of sharpness, or a part of the mesh"
                );
                return Err(MeshError::TooMuch { reason });
            }
            if let Some(fans) = around {
                regular = Regular::new(connectivity, &fans, &neighbourhood, shape).or(regular);
            }
            roots.points.extend(neighbourhood.points.iter().map(|&point| index(point)));
            roots.all.push(Root { face, part, shape, first });
        }
        Ok(roots)
    }

    /// A piece with its points.
    pub(crate) fn cell<V: Vector>(
        &self,
        root: &Root,
        shapes: &Shapes,
        refined: &[V],
    ) -> LevelPiece<V> {
        let numbers = &self.points[root.first..root.first + shapes.get(root.shape).points];
        let points = numbers.iter().map(|&point| refined[point as usize].clone()).collect();
        LevelPiece { shape: root.shape, level: 1, points, base: None, path: 0 }
    }

    /// The numbers of the first points of a piece.
    pub(super) fn first_points(&self, root: &Root, count: usize) -> &[u32] {
        &self.points[root.first..root.first + count]
    }
}

/// For faces of each number of vertices, the corners of their parts.
pub(super) type Corners<W> = BTreeMap<usize, Vec<Vec<Row<W>>>>;

/// Those of all faces of a mesh.
pub(crate) fn corners<W: Number>(scheme: MeshScheme, control: &Connectivity) -> Corners<W> {
    let mut corners = Corners::new();
    for face in control.faces() {
        corners.entry(face.len()).or_insert_with(|| match scheme {
            MeshScheme::Loop | MeshScheme::LoopWarren => parts_of_face(3),
            _ => quadrilaterals_of_face(face.len(), &(0..face.len()).collect::<Vec<usize>>()),
        });
    }
    corners
}

/// The pieces of level 1 by their faces and parts.
fn pieces(scheme: MeshScheme, control: &Connectivity) -> Vec<(usize, usize, Piece)> {
    let mut pieces = Vec::new();
    let inner_edges = control.edges().iter().filter(|edge| edge.other.is_some()).count();
    let mut vertex_faces = vec![None; control.point_count()];
    if scheme == MeshScheme::DooSabin {
        let mut next = control.faces().len() + inner_edges;
        for (vertex, face) in vertex_faces.iter_mut().enumerate() {
            if !control.star(vertex).boundary {
                *face = Some(next);
                next += 1;
            }
        }
    }
    let mut next = 0;
    for (face, vertices) in control.faces().iter().enumerate() {
        let parts = match scheme {
            MeshScheme::Loop | MeshScheme::LoopWarren => 4,
            _ => vertices.len(),
        };
        for part in 0..parts {
            let piece = match scheme {
                MeshScheme::DooSabin => {
                    vertex_faces[vertices[part]].map(|first| Piece::Vertex(next, first))
                }
                _ => Some(Piece::Face(next)),
            };
            pieces.extend(piece.map(|piece| (face, part, piece)));
            next += 1;
        }
    }
    pieces
}
