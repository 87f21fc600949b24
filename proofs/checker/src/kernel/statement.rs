//! The statements of theorems of Coq, and their arguments.

use crate::numbers::Q;
use std::fmt;

/// The statements, each with its arguments: a mask, a difference mask, a ring, a number of levels, or a
/// rational number. Definitions.v says what they mean.
pub const STATEMENTS: [(&str, &str); 13] = [
    ("contraction_constant", "mask level number"),
    ("backwards_constant", "mask difference level number"),
    ("scheme_norm", "reversed level number"),
    ("bounds_distance", "mask number level number"),
    ("sufficient_depth", "mask number number number level"),
    ("exceeds_difference", "mask level number number"),
    ("exceeds_step", "mask number level number number"),
    ("exceeds_distance", "mask number level number number"),
    ("exceeds_net_step", "mask mask number number level number number"),
    ("exceeds_net_distance", "mask mask number number level number number"),
    ("exceeds_ring_difference", "ring level number number"),
    ("exceeds_ring_step", "ring ring level number number"),
    ("exceeds_ring_distance", "ring level number number"),
];

/// A mask at an offset, or the weights of a ring with its edges.
#[derive(Clone, Debug, PartialEq)]
pub enum Object {
    /// The rules of a mask.
    Mask(i64, Vec<Vec<Q>>),
    /// The weights and the edges of a ring.
    Ring(Vec<Vec<Q>>, Vec<[usize; 2]>),
}

/// An argument of a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// A mask or ring.
    Object(Object),
    /// A mask whose rules are read from their other end.
    Backwards(Object),
    /// A number of levels.
    Level(u32),
    /// A rational number.
    Number(Q),
}

impl fmt::Display for Object {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let row = |row: &Vec<Q>| row.iter().map(Q::to_string).collect::<Vec<_>>().join(" ");
        let rows = |rows: &[Vec<Q>]| rows.iter().map(row).collect::<Vec<_>>().join("; ");
        match self {
            Object::Mask(offset, mask) => write!(f, "the mask {} at {offset}", rows(mask)),
            Object::Ring(weights, edges) => write!(f, "the ring {}, {edges:?}", rows(weights)),
        }
    }
}

impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Argument::Object(object) => write!(f, "{object}"),
            Argument::Backwards(object) => write!(f, "backwards {object}"),
            Argument::Level(level) => write!(f, "level {level}"),
            Argument::Number(number) => write!(f, "{number}"),
        }
    }
}

/// A theorem. Coq checks that it is true.
pub struct Theorem {
    /// The line of its first comment.
    pub line: usize,
    /// Where the claim stands, as the first comment says.
    pub place: String,
    /// What the theorem says of it, as the second comment says.
    pub about: String,
    /// The statement of Definitions.v.
    pub statement: String,
    /// Its arguments.
    pub arguments: Vec<Argument>,
    /// The last two arguments of its lemma, if these are natural numbers.
    pub evidence: [Option<i64>; 2],
}
