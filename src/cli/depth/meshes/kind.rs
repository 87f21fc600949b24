//! Meshes, nets and solids, in words.

use crate::cli::console::quantity::Text;

/// What the depth is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A polygon mesh, with creases, corners or holes, or without.
    Mesh { tagged: bool },
    /// A tensor net, with so many faces along a row.
    Net { faces_in_row: usize },
    /// A net with a mask on Z², linear on triangles or not.
    LatticeNet { faces_in_row: usize, triangles: bool },
    /// The boundary of a hexahedral solid.
    Boundary,
    /// A hexahedral solid, the pieces of which are cells.
    Solid,
}

impl Kind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Kind::Mesh { .. } | Kind::Solid => "mesh",
            Kind::Boundary => "boundary",
            Kind::Net { .. } | Kind::LatticeNet { .. } => "net",
        }
    }

    pub(super) fn piece(self) -> &'static str {
        if self == Kind::Solid { "cell" } else { "face" }
    }

    /// The cell (i, j) of a face of a net.
    pub(super) fn cell(self, face: usize) -> Option<[usize; 2]> {
        match self {
            Kind::Mesh { .. } | Kind::Boundary | Kind::Solid => None,
            Kind::Net { faces_in_row } | Kind::LatticeNet { faces_in_row, .. } => {
                Some([face / faces_in_row, face % faces_in_row])
            }
        }
    }

    /// Whose edges the level a priori is about.
    pub(super) fn all(self) -> &'static str {
        match self {
            Kind::Mesh { tagged: false } => "meshes with these valences and",
            Kind::Mesh { tagged: true } => "meshes with these valences and tags, and",
            Kind::Boundary => "boundaries with these valences and",
            Kind::Net { .. } | Kind::LatticeNet { .. } => "nets with",
            Kind::Solid => "meshes whose cells meet so, with",
        }
    }

    /// What the distance is.
    pub(super) fn distance(self) -> &'static str {
        match self {
            Kind::Mesh { .. } | Kind::Boundary => {
                "The distance is that of each face of the level from its own piece of the limit \
                 surface, point by point at the same parameters. Faces and vertices are numbered from 0."
            }
            Kind::LatticeNet { triangles: true, .. } => {
                "The distance is that of the net of the level, linear on triangles, from the limit surface, point \
                 by point at the same natural parameters. Cells, faces and vertices are numbered from 0, row by row."
            }
            Kind::Net { .. } | Kind::LatticeNet { .. } => {
                "The distance is that of the net of the level, bilinear on each face, from the limit \
                 surface, point by point at the same natural parameters. Cells, faces and vertices are \
                 numbered from 0, row by row."
            }
            Kind::Solid => {
                "The distance is that of each cell of the level from its own piece of the limit solid, \
                 point by point at the same parameters; the boundary is a part of it. Cells and vertices \
                 are numbered from 0."
            }
        }
    }
}

/// The vertex that a place is near, and the face of the level: ` near vertex 3, face 4 of the level`.
pub(super) fn near(vertex: Option<usize>, level_face: Option<&Text<u128>>) -> String {
    let vertex = vertex.map(|vertex| format!(" near vertex {vertex}")).unwrap_or_default();
    let face = level_face.map(|face| format!(", face {face} of the level")).unwrap_or_default();
    format!("{vertex}{face}")
}
