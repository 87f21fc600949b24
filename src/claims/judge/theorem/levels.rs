//! Bounds that hold at all levels because they hold at finitely many.

use crate::bound::{Constants, SoundBound};
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{LevelEvidence, Reason};
use crate::judge::later::{change, later};
use crate::scheme::Axes;

/// The most levels between a bound and the later sound bound that shows it.
const MAX_LATER: u32 = 12;

/// For each bound of a distance, a later level whose sound bound shows it.
pub(crate) fn sums(
    axes: &Axes<Constants>,
    sound: Option<&SoundBound>,
    bounds: &[(u32, RealCyclotomic)],
) -> Result<LevelEvidence, Reason> {
    let axes = axes.map(|axis| axis);
    let of = |(level, most): &(u32, RealCyclotomic)| {
        let most: &Rational = most.as_rational()?;
        let change = |later| change(&axes, None, *level, later);
        later(sound?, *level, MAX_LATER, change, |sum| sum <= most)
    };
    let later = bounds.iter().map(|bound| {
        let why = || Reason::NoSoundBound(bound.0);
        of(bound).ok_or_else(why)
    });
    Ok(LevelEvidence::Later(later.collect::<Result<_, Reason>>()?))
}
