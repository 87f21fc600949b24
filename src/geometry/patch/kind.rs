//! What pieces are pieces of.

use crate::mesh::MeshScheme;

/// A surface of one of the schemes for polygon meshes, or a solid of Bajaj's scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Surface(MeshScheme),
    Solid,
}

impl Kind {
    /// Whether regular pieces are bicubic or tricubic.
    pub(super) fn is_cubic(self) -> bool {
        matches!(self, Kind::Surface(MeshScheme::CatmullClark) | Kind::Solid)
    }

    /// Whether pieces are triangles.
    pub(super) fn is_triangular(self) -> bool {
        matches!(self, Kind::Surface(MeshScheme::Loop | MeshScheme::LoopWarren))
    }

    /// The bound of 92 and 101 for a regular piece, from the sum of the greatest second differences of all
    /// directions, and that across edges.
    pub(super) fn bend_bound(self, straight: f64, across: f64) -> f64 {
        match self {
            Kind::Surface(MeshScheme::Loop | MeshScheme::LoopWarren) => {
                (straight / 12.0).max(across / 6.0)
            }
            Kind::Surface(MeshScheme::DooSabin) => straight / 8.0,
            Kind::Surface(MeshScheme::CatmullClark) | Kind::Solid => straight / 6.0,
        }
    }
}
