//! The joint spectral radius of a mask, in a block of a claim.

use super::block::Block;
use super::radius::{LimitLines, limits};
use crate::audit::Limits;

/// Writes the lines about the radius.
pub(super) fn radius(block: &mut Block, known: &Limits) -> Option<LimitLines> {
    let found = limits(&known.mask, &known.smoothness);
    match &found {
        Some(lines) => lines.text.lines().for_each(|line| block.line(line)),
        None => block.give_up("no invariant hull is found"),
    }
    found
}
