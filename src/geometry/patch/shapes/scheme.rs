//! What pieces are pieces of.

use crate::mesh::MeshScheme;

/// A surface of one of the schemes for polygon meshes, or a solid of Bajaj's scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PieceScheme {
    Surface(MeshScheme),
    Solid,
}

impl PieceScheme {
    /// Whether regular pieces are bicubic or tricubic.
    pub(crate) fn is_cubic(self) -> bool {
        match self {
            PieceScheme::Surface(scheme) => scheme.is_bicubic(),
            PieceScheme::Solid => true,
        }
    }

    /// Whether pieces are triangles.
    pub(crate) fn is_triangular(self) -> bool {
        matches!(self, PieceScheme::Surface(scheme) if scheme.is_triangular())
    }

    /// The bound of 92 and 101 for a regular piece, from the sum of the greatest second differences of all
    /// directions, and that across edges.
    pub(crate) fn bend_bound(self, straight: f64, across: f64) -> f64 {
        if self.is_triangular() {
            (straight / 12.0).max(across / 6.0)
        } else if self.is_cubic() {
            straight / 6.0
        } else {
            straight / 8.0
        }
    }
}
