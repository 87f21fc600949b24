//! What can be wrong with a net.

use crate::limit::LimitError;
use crate::mesh::MAX_POINTS;
use crate::scheme::SchemeError;

/// Why there is no net, or no refined one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NetError {
    /// The last row is not whole.
    #[error("{points} points are not whole rows of {columns}")]
    Ragged {
        /// How many there are.
        points: usize,
        /// How long a row is.
        columns: usize,
    },
    /// A direction of too few points to be a net.
    #[error(
        "the net has {found} {}; {} direction needs {needed} at least",
        things(*.direction), if *.closed { "a closed" } else { "an open" },
    )]
    Small {
        /// 0: from row to row; 1: along the rows.
        direction: usize,
        /// How many points it has.
        found: usize,
        /// How many it needs.
        needed: usize,
        /// Whether it is closed.
        closed: bool,
    },
    /// More than [`MAX_POINTS`] points.
    #[error(
        "a net of {0} points; at most {MAX_POINTS} are worked on: take a lower level, or a smaller net"
    )]
    TooManyPoints(usize),
    /// An open net that determines no piece of the surface.
    #[error(
        "the net has {found} {}, and one piece of the surface of this scheme depends on {needed}: \
         add {0}, or close the net in this direction",
        things(*.direction)
    )]
    TooFew {
        /// 0: from row to row; 1: along the rows.
        direction: usize,
        /// How many points it has.
        found: usize,
        /// How many it needs.
        needed: usize,
    },
    /// A level beyond the cap.
    #[error("level {level} is too high; at most {most} is")]
    Level {
        /// The level.
        level: u32,
        /// The highest one.
        most: u32,
    },
    /// A name that no scheme has.
    #[error(transparent)]
    Scheme(#[from] SchemeError),
    /// A scheme for polygon meshes.
    #[error(
        "`{0}` is for polygon meshes, and this is a net: take a curve scheme, such as \
         b-spline:degree=3 (bicubic) or chaikin (biquadratic), or two with ` x ` between them"
    )]
    ForMeshes(String),
    /// What a curve scheme is refused for.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// Work beyond a cap.
    #[error("{0}")]
    TooMuch(String),
}

fn things(direction: usize) -> &'static str {
    if direction == 0 { "rows" } else { "points in a row" }
}
