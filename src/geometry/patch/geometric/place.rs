//! Where a point of one set is far from the other.

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
