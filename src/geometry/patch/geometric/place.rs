//! How many levels are needed, and where a point of one set is far from the other.

use crate::mesh::Point;

/// One of the two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetKind {
    /// The mesh of the level.
    Mesh,
    /// The limit surface.
    Limit,
}

impl SetKind {
    /// `mesh` or `limit`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            SetKind::Mesh => "mesh",
            SetKind::Limit => "limit",
        }
    }
}

/// A point of one set that is far from all of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricPlace {
    /// The face of the control mesh.
    pub face: usize,
    /// The vertex of that face that it is near to, where that is known.
    pub vertex: Option<usize>,
    /// The face of the level; `None` at level 0 and for Doo and Sabin.
    pub level_face: Option<u128>,
    /// The set that has the point.
    pub from: SetKind,
    /// The point, to f64.
    pub point: Point<f64>,
    /// A point of the other set that is near, to f64; no bound rests on it.
    pub other: Point<f64>,
    /// A lower bound of the distance of the point from the other set.
    pub distance: f64,
}

/// How many levels a mesh, or a control polygon, needs as a set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricDepth<P = GeometricPlace> {
    /// The least level that was found to be sufficient.
    pub level: u32,
    /// The greatest level that is certainly not sufficient, with all levels below it; `None` where even
    /// level 0 may be.
    pub too_few: Option<u32>,
    /// A point that shows that `too_few` is not sufficient.
    pub beyond: Option<P>,
}

/// What one face of the control mesh needs.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceDepth {
    /// The least level that was found to be sufficient for its part of the mesh and its part of the limit.
    pub level: u32,
    /// Whether all levels below certainly are not.
    pub is_least: bool,
    /// The last distance that was found to be too great, and its level: a lower bound.
    pub too_far: Option<(u32, f64)>,
}
