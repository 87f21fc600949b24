//! What can be wrong with a mesh.

use super::{MAX_POINTS, MAX_VALENCE};
use std::fmt;

/// What is wrong with a mesh, or keeps it from being refined.
///
/// Points and faces are numbered from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no face.
    Empty,
    /// More than [`MAX_POINTS`] points.
    TooManyPoints {
        /// How many there are, or would be.
        points: usize,
    },
    /// A face of fewer than 3 vertices.
    FewVertices {
        /// The face.
        face: usize,
        /// How many it has.
        count: usize,
    },
    /// A face with a vertex that is not a point.
    NoPoint {
        /// The face.
        face: usize,
        /// The vertex.
        point: usize,
        /// How many points there are.
        count: usize,
    },
    /// A face that has a vertex twice.
    Twice {
        /// The face.
        face: usize,
        /// The vertex.
        point: usize,
    },
    /// An edge of three faces or more.
    NonManifoldEdge {
        /// The ends of the edge.
        ends: [usize; 2],
        /// The third face.
        face: usize,
        /// The first face.
        first: usize,
    },
    /// A face that is there already, in the same order or the opposite one.
    SameFace {
        /// The second face.
        face: usize,
        /// The first face.
        first: usize,
    },
    /// Two faces that run along their common edge in the same direction.
    Orientation {
        /// The ends of the edge.
        ends: [usize; 2],
        /// The second face.
        face: usize,
        /// The first face.
        first: usize,
    },
    /// A vertex whose faces are no single fan or disc.
    NonManifoldVertex {
        /// The vertex.
        point: usize,
        /// A face of the vertex that edges at the vertex do not connect with its first face.
        face: usize,
    },
    /// A point of no face.
    Isolated {
        /// The point.
        point: usize,
    },
    /// A face that the scheme has no rules for.
    Face {
        /// The face.
        face: usize,
        /// Why not, and what would be right.
        reason: String,
    },
    /// A vertex that the scheme has no rules for.
    Vertex {
        /// The vertex.
        point: usize,
        /// Why not, and what would be right.
        reason: String,
    },
    /// A crease along no edge.
    NoEdge {
        /// The two vertices.
        ends: [usize; 2],
    },
    /// A corner at no vertex.
    NoVertex {
        /// The vertex.
        vertex: usize,
        /// How many there are.
        count: usize,
    },
    /// A hole that is no face.
    NoFace {
        /// The face.
        face: usize,
        /// How many there are.
        count: usize,
    },
    /// Texture coordinates that do not fit the faces, or tags that the scheme has no rules for.
    Attribute {
        /// What is wrong, and what would be right.
        reason: String,
    },
    /// Work beyond a cap.
    TooMuch {
        /// Which cap, and what would be right.
        reason: String,
    },
}

impl MeshError {
    /// The face that the error is about.
    #[must_use]
    pub fn face(&self) -> Option<usize> {
        match self {
            MeshError::FewVertices { face, .. }
            | MeshError::NoPoint { face, .. }
            | MeshError::Twice { face, .. }
            | MeshError::NonManifoldEdge { face, .. }
            | MeshError::SameFace { face, .. }
            | MeshError::Orientation { face, .. }
            | MeshError::NonManifoldVertex { face, .. }
            | MeshError::Face { face, .. } => Some(*face),
            _ => None,
        }
    }

    /// Another face that the error is about.
    #[must_use]
    pub fn other_face(&self) -> Option<usize> {
        match self {
            MeshError::NonManifoldEdge { first, .. }
            | MeshError::SameFace { first, .. }
            | MeshError::Orientation { first, .. } => Some(*first),
            _ => None,
        }
    }

    /// The point that the error is about.
    #[must_use]
    pub fn point(&self) -> Option<usize> {
        match self {
            MeshError::Isolated { point }
            | MeshError::NonManifoldVertex { point, .. }
            | MeshError::Vertex { point, .. } => Some(*point),
            _ => None,
        }
    }

    /// What would be right.
    #[must_use]
    pub fn help(&self) -> Option<&'static str> {
        Some(match self {
            MeshError::Empty => "a mesh needs at least one face",
            MeshError::TooManyPoints { .. } => "take a lower level, or a smaller mesh",
            MeshError::FewVertices { .. } | MeshError::Twice { .. } => {
                "remove the face, or give it three different vertices or more"
            }
            MeshError::NoPoint { .. } => {
                "is the file cut off, or from a program that counts differently?"
            }
            MeshError::NonManifoldEdge { .. } => "an edge has one face, at the boundary, or two",
            MeshError::SameFace { .. } => "remove one of the two",
            MeshError::Orientation { .. } => {
                "write the vertices of one of the two faces in the opposite order, so that all faces \
                 are seen counter-clockwise from the same side"
            }
            MeshError::NonManifoldVertex { .. } => {
                "give each of the surfaces that meet there only at one point a point of its own"
            }
            MeshError::Isolated { .. } => "remove the point, or use it in a face",
            MeshError::NoEdge { .. } => {
                "a crease runs along an edge of a face, from vertex to vertex; tags count vertices from 0"
            }
            MeshError::NoVertex { .. } | MeshError::NoFace { .. } => {
                "tags count vertices and faces from 0"
            }
            MeshError::Attribute { .. }
            | MeshError::Face { .. }
            | MeshError::Vertex { .. }
            | MeshError::TooMuch { .. } => {
                return None;
            }
        })
    }

    /// The message, with the first point and the first face called `base`.
    #[must_use]
    pub fn message(&self, base: usize) -> String {
        let numbered = matches!(
            self,
            MeshError::NoPoint { .. }
                | MeshError::Twice { .. }
                | MeshError::NonManifoldEdge { .. }
                | MeshError::Orientation { .. }
                | MeshError::NonManifoldVertex { .. }
                | MeshError::Isolated { .. }
                | MeshError::Vertex { .. }
        );
        let words = self.words(base);
        if numbered { format!("{words}; vertices are counted from {base}") } else { words }
    }

    fn words(&self, base: usize) -> String {
        let pair = |ends: &[usize; 2]| format!("{} and {}", ends[0] + base, ends[1] + base);
        match self {
            MeshError::Empty => "there is no face".to_owned(),
            MeshError::TooManyPoints { points } => {
                format!("a mesh of {points} points; at most {MAX_POINTS} are worked on")
            }
            MeshError::FewVertices { count, .. } => {
                format!("a face of {count} vertices; a face has 3 or more")
            }
            MeshError::NoPoint { point, count, .. } => {
                format!("point {} does not exist: there are {count} points", point + base)
            }
            MeshError::Twice { point, .. } => {
                format!("a degenerate face: it has the vertex {} twice", point + base)
            }
            MeshError::NonManifoldEdge { ends, .. } => {
                format!("a third face at the edge between the vertices {}", pair(ends))
            }
            MeshError::SameFace { .. } => "the same face for the second time".to_owned(),
            MeshError::Orientation { ends, .. } => format!(
                "two faces run from vertex {} to vertex {}: their orientations differ",
                ends[0] + base,
                ends[1] + base
            ),
            MeshError::NonManifoldVertex { point, .. } => format!(
                "the faces around vertex {} are not one disc or one fan: they hang together only \
                 at that point",
                point + base
            ),
            MeshError::Isolated { point } => {
                format!("point {} is a vertex of no face", point + base)
            }
            MeshError::NoEdge { ends } => {
                format!("there is no edge between the vertices {}", pair(ends))
            }
            MeshError::NoVertex { vertex, count } => {
                format!("vertex {} does not exist: there are {count}", vertex + base)
            }
            MeshError::NoFace { face, count } => {
                format!("face {} does not exist: there are {count}", face + base)
            }
            MeshError::Face { reason, .. }
            | MeshError::TooMuch { reason }
            | MeshError::Attribute { reason } => reason.clone(),
            MeshError::Vertex { point, reason } => format!("vertex {}: {reason}", point + base),
        }
    }

    /// A face with more vertices than rules are computed for.
    pub(super) fn large_face(face: usize, count: usize) -> MeshError {
        let reason =
            format!("a face of {count} vertices; rules are computed for up to {MAX_VALENCE}");
        MeshError::Face { face, reason }
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Some(face), true) = (self.face(), matches!(self, MeshError::Face { .. })) {
            write!(f, "face {face}: ")?;
        }
        f.write_str(&self.message(0))
    }
}

impl std::error::Error for MeshError {}
