//! Bounds that hold at all levels since they hold at finitely many.

use crate::audit::promised::{Later, change, later};
use crate::bound::{Constants, SoundBound};
use crate::exact::{Rational, RealCyclotomic};

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

/// The most levels by which a sound bound is taken later than a bound that it shows.
const MAX_LATER: u32 = 12;

/// Of each bound of a distance, a later level whose sound bound shows it.
pub(super) fn sums(
    axes: &[&Constants],
    sound: Option<&SoundBound>,
    bounds: &[(u32, RealCyclotomic)],
) -> Result<LevelEvidence, String> {
    let of = |(level, most): &(u32, RealCyclotomic)| {
        let most: &Rational = most.as_rational()?;
        let change = |later| change(axes, None, *level, later);
        later(sound?, *level, MAX_LATER, change, |sum| sum <= most)
    };
    let later = bounds.iter().map(|bound| {
        let why = || format!("no sound bound is as small as the bound at level {}", bound.0);
        of(bound).ok_or_else(why)
    });
    Ok(LevelEvidence::Later(later.collect::<Result<_, String>>()?))
}
