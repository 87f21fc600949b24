//! What proves a bound at all levels, or at one.

use crate::exact::RealCyclotomic;

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

/// What proves a bound at all levels: by(k + period) = ratio·by(k), T_c ≤ ratio^times for c = times·period,
/// and the bound holds at so many levels.
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
    /// What shows that the bound holds at the levels; or why certificates have no words for it.
    pub evidence: Result<LevelEvidence, String>,
}

/// What shows that a bound holds at finitely many levels.
#[derive(Clone, Debug, PartialEq)]
pub enum LevelEvidence {
    /// The suprema are finite maxima.
    Suprema,
    /// Of each level a later one whose sound bound, with how far it is, is small enough.
    Later(Vec<Later>),
    /// Flows along the edges of a ring that cost little enough.
    Flows {
        /// Of a distance, the weights of the limit.
        weights: Vec<RealCyclotomic>,
        /// For T_c one for each edge.
        contraction: Vec<Vec<RealCyclotomic>>,
        /// For each level one for each point, or of a difference for each edge.
        levels: Vec<Vec<Vec<RealCyclotomic>>>,
    },
}
