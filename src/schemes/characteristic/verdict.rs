//! What is said of a surface at an extraordinary vertex or on an extraordinary face.

use super::ring::RingPoint;
use super::rules::Reason;
use crate::exact::{Enclosure, Rational, RealExpression};
use crate::spectrum::Eigenvalue;

/// Whether the limit surface is C¹ at the vertex or on the face, in Reif's sense: for generic data, with the
/// regular part's smoothness elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// C¹.
    Proved {
        /// The most bisections of a piece.
        bisections: usize,
        /// A lower bound of J where the point (1, 0) of the net has the length 1; (0, 0) on a face. Where that point is 0, the
        /// scale is another.
        least: Rational,
        /// A point next to which J is about that small.
        near: RingPoint,
    },
    /// Not C¹.
    Refuted(Refutation),
    /// A hypothesis fails, and nothing is refuted.
    Fails(Hypothesis),
    /// Not decided.
    Open(Reason),
}

/// Why a surface is not C¹.
#[derive(Clone, Debug, PartialEq)]
pub enum Refutation {
    /// Besides the simple eigenvalue 1 there is one with |λ| ≥ 1, or 1 is multiple: the rings of generic data do not contract to a
    /// point, and the surface is not continuous.
    Diverges {
        /// The eigenvalue; 1 where it is multiple.
        eigenvalue: Eigenvalue,
    },
    /// The Jacobian has both signs, at these points.
    Folds {
        /// The points, the positive one first.
        points: [RingPoint; 2],
        /// J there, in the scale of [`Verdict::Proved`].
        values: [Enclosure; 2],
    },
    /// An eigenvalue of block 0, simple or with one Jordan block, outweighs all but 1, and its eigenfunction has one sign.
    Block0 {
        /// The eigenvalue.
        value: RealExpression,
        /// The size of its Jordan block.
        size: usize,
    },
    /// λ is negative, and the Jacobian has one sign.
    Negative,
    /// The outer curve of the ring winds around the vertex or the centre of the face another number of times than once.
    Winds {
        /// The winding number of the outer curve; `None` where a part of the curve may meet the vertex or the centre of the
        /// face. It is known to be k modulo n for the blocks k and n − k, and negative for a negative Jacobian.
        number: Option<i64>,
    },
}

/// A hypothesis of the theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hypothesis {
    /// 1 is simple, and all others are below it in absolute value.
    SimpleOne,
    /// The eigenvalues next to 1 are alone of their modulus.
    Alone,
    /// λ is real.
    Real,
    /// λ is a simple eigenvalue of each of its blocks, so that there is no Jordan block.
    Simple,
    /// λ is of two blocks k and n − k.
    Blocks,
    /// λ is positive, of the blocks 1 and n − 1.
    First,
}
