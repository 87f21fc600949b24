//! What is known of the limits of one mask, of curves or on Z^d, in the block of a claim.

use super::block::Block;
use super::lattice::lattice_limits;
use super::radius::radius;
use super::shown::Shown;
use crate::audit::KnownLimits;

/// Why a finding has no certificate: the radius is enclosed by rational numbers.
pub(super) const NOT_SHOWN: &str =
    "the rational bounds of the joint spectral radius do not show this";

/// The lines about the limits of one mask, and what they show.
pub(super) fn known_limits(block: &mut Block, known: &KnownLimits) -> Option<Shown> {
    match known {
        KnownLimits::Limits(known) => {
            let lines = radius(block, known)?;
            Some(Shown::of_curve(&lines, known.mask.arity()))
        }
        KnownLimits::Lattice(known) => match lattice_limits(&known.mask, &known.smoothness) {
            Ok((lines, shown)) => {
                lines.lines().for_each(|line| block.line(line));
                Some(shown)
            }
            Err(why) => {
                block.give_up(why);
                None
            }
        },
        _ => {
            block.give_up("nothing is known of the limits");
            None
        }
    }
}
