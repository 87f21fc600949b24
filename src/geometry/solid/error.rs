//! What can be wrong with a hexahedral mesh.

use super::{MAX_CELLS_AT_POINT, MAX_POINTS};
use std::fmt;

/// What is wrong with a hexahedral mesh, or keeps it from being refined.
///
/// Points and cells are numbered from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SolidError {
    /// There is no cell.
    Empty,
    /// More than [`MAX_POINTS`] points.
    TooManyPoints {
        /// How many there are, or would be.
        points: usize,
    },
    /// A cell with a corner that is not a point.
    NoPoint {
        /// The cell.
        cell: usize,
        /// The corner.
        point: usize,
        /// How many points there are.
        count: usize,
    },
    /// A cell that has a corner twice.
    Twice {
        /// The cell.
        cell: usize,
        /// The corner.
        point: usize,
    },
    /// A face of three cells.
    ThirdCell {
        /// The corners of the face.
        corners: [usize; 4],
        /// The third cell.
        cell: usize,
        /// The first cell.
        first: usize,
    },
    /// Two cells that have the same four corners of a face in a different order around it.
    Twisted {
        /// The corners as the second cell has them.
        corners: [usize; 4],
        /// The second cell.
        cell: usize,
        /// The first cell.
        first: usize,
    },
    /// Two cells that are on the same side of their common face, by the order of their corners.
    Orientation {
        /// The corners of the face.
        corners: [usize; 4],
        /// The second cell.
        cell: usize,
        /// The first cell.
        first: usize,
    },
    /// An edge or a point whose cells do not hang together by faces that have it, or enclose a hole.
    Loose {
        /// The point, or one end of the edge.
        point: usize,
        /// One of the cells.
        cell: usize,
    },
    /// A point of no cell.
    Isolated {
        /// The point.
        point: usize,
    },
    /// A point of more than [`MAX_CELLS_AT_POINT`] cells.
    Crowded {
        /// The point.
        point: usize,
        /// How many cells have it.
        cells: usize,
    },
    /// Work beyond a cap.
    TooMuch {
        /// Which cap, and what would be right.
        reason: String,
    },
}

impl SolidError {
    /// The cell that it is about.
    #[must_use]
    pub fn cell(&self) -> Option<usize> {
        match self {
            SolidError::NoPoint { cell, .. }
            | SolidError::Twice { cell, .. }
            | SolidError::ThirdCell { cell, .. }
            | SolidError::Twisted { cell, .. }
            | SolidError::Orientation { cell, .. }
            | SolidError::Loose { cell, .. } => Some(*cell),
            _ => None,
        }
    }

    /// Another cell that it is about.
    #[must_use]
    pub fn other_cell(&self) -> Option<usize> {
        match self {
            SolidError::ThirdCell { first, .. }
            | SolidError::Twisted { first, .. }
            | SolidError::Orientation { first, .. } => Some(*first),
            _ => None,
        }
    }

    /// The point that it is about.
    #[must_use]
    pub fn point(&self) -> Option<usize> {
        match self {
            SolidError::Isolated { point }
            | SolidError::Loose { point, .. }
            | SolidError::Crowded { point, .. } => Some(*point),
            _ => None,
        }
    }

    /// What would be right.
    #[must_use]
    pub fn help(&self) -> Option<&'static str> {
        Some(match self {
            SolidError::Empty => "a solid needs at least one hexahedron",
            SolidError::TooManyPoints { .. } => "take a lower level, or a smaller mesh",
            SolidError::NoPoint { .. } => {
                "is the file cut off, or from a program that counts differently?"
            }
            SolidError::Twice { .. } => "remove the cell, or give it eight different corners",
            SolidError::ThirdCell { .. } => {
                "a face has one cell, at the boundary, or two; remove the cells that overlap"
            }
            SolidError::Twisted { .. } => {
                "write the corners around the bottom of the cell, then those of the top above them"
            }
            SolidError::Orientation { .. } => {
                "if one of the cells is inside out, exchange its bottom and its top: its last four \
                 corners before its first four; if the cells overlap, remove one"
            }
            SolidError::Loose { .. } => {
                "give the parts that meet there points of their own, or fill the gap between them"
            }
            SolidError::Isolated { .. } => "remove the point, or use it in a cell",
            SolidError::Crowded { .. } => "divide the solid so that fewer cells meet at the point",
            SolidError::TooMuch { .. } => return None,
        })
    }

    /// The message, with the first point called `base`.
    #[must_use]
    pub fn message(&self, base: usize) -> String {
        let all = |corners: &[usize; 4]| {
            let [a, b, c, d] = corners.map(|corner| corner + base);
            format!("{a}, {b}, {c} and {d}")
        };
        match self {
            SolidError::Empty => "there is no hexahedron".to_owned(),
            SolidError::TooManyPoints { points } => {
                format!("a mesh of {points} points; at most {MAX_POINTS} are worked on")
            }
            SolidError::NoPoint { point, count, .. } => {
                format!("point {} does not exist: there are {count} points", point + base)
            }
            SolidError::Twice { point, .. } => {
                format!("a degenerate cell: it has the corner {} twice", point + base)
            }
            SolidError::ThirdCell { corners, .. } => {
                format!("a third cell at the face of the points {}", all(corners))
            }
            SolidError::Twisted { corners, .. } => format!(
                "two cells share the points {}, but go around them in different orders",
                all(corners)
            ),
            SolidError::Orientation { corners, .. } => format!(
                "two cells are on the same side of their face of the points {}: their orientations \
                 differ, or they overlap",
                all(corners)
            ),
            SolidError::Loose { point, .. } => format!(
                "the cells around point {} do not fill a ball or a part of one: they hang together \
                 only at the point or at an edge, or leave a gap in between",
                point + base
            ),
            SolidError::Isolated { point } => {
                format!("point {} is a corner of no cell", point + base)
            }
            SolidError::Crowded { point, cells } => format!(
                "{cells} cells meet at point {}; there are rules for up to {MAX_CELLS_AT_POINT}",
                point + base
            ),
            SolidError::TooMuch { reason } => reason.clone(),
        }
    }
}

impl fmt::Display for SolidError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message(0))
    }
}

impl std::error::Error for SolidError {}
