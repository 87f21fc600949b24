//! What proves a bound at all levels, or at one.

use crate::exact::RealCyclotomic;
use crate::finding::reason::Reason;

/// A sound bound of a later level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Later {
    /// Its level.
    pub later: u32,
    /// The greatest m whose constant T_m is computed.
    pub levels: usize,
    /// The block length c.
    pub block: u32,
}

/// What proves a bound at all levels: by(k + p) = q·by(k) for every k, T_c ≤ q^j for c = j·p, and
/// the bound holds at c levels, from its first one on.
///
/// Source: `proofs/THEOREMS.md`, 40.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    /// p.
    pub period: u32,
    /// q.
    pub ratio: RealCyclotomic,
    /// j.
    pub times: u32,
    /// What shows that the bound holds at these levels; the error says why certificates cannot
    /// express it.
    pub evidence: Result<LevelEvidence, Reason>,
}

/// What shows that a bound holds at finitely many levels.
#[derive(Clone, Debug, PartialEq)]
pub enum LevelEvidence {
    /// Nothing more: the suprema are maxima of finitely many values.
    Suprema,
    /// For each level a later one, such that the sound bound there and the distance between both
    /// levels are together small enough.
    Later(Vec<Later>),
    /// Flows along the edges of a ring whose costs are small enough.
    Flows {
        /// For a distance, the weights of the limit.
        weights: Vec<RealCyclotomic>,
        /// The flows that bound T_c, one for each edge.
        contraction: Vec<Vec<RealCyclotomic>>,
        /// For each level its flows: one for each point, or for a difference one for each edge.
        levels: Vec<Vec<Vec<RealCyclotomic>>>,
    },
}
