//! What the search needs to know of a surface: pieces of the limit with hulls, and a mesh that is compared with it.

use super::patch::{Patch, ball};
use crate::mesh::Point;

/// Where a piece of the limit is.
pub(crate) struct Hull {
    /// The piece is in the hull of these points, or as near to it as `extra`.
    pub(crate) points: Vec<Point<f64>>,
    pub(crate) extra: f64,
    /// Limit points: those at the corners, in turn.
    pub(crate) limits: Vec<Point<f64>>,
    pub(crate) level: u32,
}

impl Hull {
    /// A ball around the piece.
    pub(crate) fn ball(&self) -> (Point<f64>, f64) {
        let (centre, radius) = ball(&self.points);
        (centre, radius + self.extra)
    }
}

/// Pieces of a limit that can be divided.
pub(crate) trait Pieces: Sync {
    type Piece: Clone + Send + Sync;

    fn hull(&self, piece: &Self::Piece) -> Hull;

    /// The pieces that together are this one.
    fn parts(&self, piece: &Self::Piece) -> Vec<Self::Piece>;
}

/// A part of the mesh, together with the part of the limit that has the same parameters: a quarter of a quadrilateral at a
/// vertex, a quarter of a triangle, a cell of a net.
pub(crate) struct Unit {
    pub(crate) patches: Vec<Patch>,
    /// A closed chain around it, of points of the mesh at the corners, and their numbers: units with a corner in common
    /// touch there.
    pub(crate) base: Vec<Point<f64>>,
    pub(crate) corners: Vec<usize>,
}

/// The mesh of a level, in units that each have a piece of the limit.
pub(crate) trait Units: Pieces {
    fn piece(&self, number: usize) -> Self::Piece;

    /// Whether mesh and limit are within the tolerance on a unit, point by point at equal parameters.
    fn is_near_by_parameter(&self, number: usize, unit: &Unit) -> bool;

    /// How far the limit is at most from the chain around a unit, at equal parameters.
    fn moved(&self, number: usize, unit: &Unit) -> f64;

    /// A f64 that is at most the tolerance.
    fn tolerance(&self) -> f64;
}

/// The part of a mesh that belongs to a piece.
pub(crate) enum MeshPart {
    /// It is somewhere in the hull of these points, or as near to it as that: pieces of a later level show it.
    Within(Vec<Point<f64>>, f64),
    /// Here.
    Patches(Vec<Patch>),
}

/// All of a mesh of a level, and of its limit.
pub(crate) trait Sets: Pieces {
    /// How many roots there are: the pieces of the roots make up the limit, and their meshes the mesh.
    fn count(&self) -> usize;

    /// The root, for a search in the limit or in the mesh.
    fn root(&self, number: usize, of_mesh: bool) -> Self::Piece;

    fn mesh_part(&self, number: usize, piece: &Self::Piece) -> MeshPart;

    /// How far lengths may be off.
    fn slack(&self) -> f64;
}
