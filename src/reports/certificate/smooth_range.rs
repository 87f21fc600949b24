//! Ranges of a parameter for which limits are C^m: a contraction, or a value that refutes the range.

use super::block::Block;
use super::limits::radius;
use super::parametric::pieces;
use crate::audit::{RangeOfLimits, SmoothnessVerdict, Word};
use crate::claim::SmoothRangeStatement;

pub(super) fn lines(
    block: &mut Block,
    said: &SmoothRangeStatement,
    scheme: &str,
    known: &RangeOfLimits,
    verdict: SmoothnessVerdict,
) {
    block.line(format!("variable {}", said.variable));
    block.restate("scheme", scheme);
    block.line(format!("smoothness {}", said.m));
    match (verdict, &known.contraction, &known.witness) {
        (SmoothnessVerdict::Confirmed, Some(contraction), _) if !said.only => {
            block.line(format!("contraction {}", contraction.levels));
            for g in &contraction.reduction {
                let g: Vec<String> = g.iter().map(ToString::to_string).collect();
                block.line(format!("shifts {}", g.join(" ")));
            }
            pieces(block, &contraction.below, &contraction.above);
            block.line(Word::Confirmed);
        }
        (SmoothnessVerdict::Confirmed, ..) if said.only => {
            block.give_up("that the limits are less smooth for all other values is not certified");
        }
        (SmoothnessVerdict::Confirmed, ..) => {
            block.give_up("the proof by hulls on many intervals is not certified");
        }
        (SmoothnessVerdict::Refuted, _, Some(witness)) => {
            block.line(format!("at {}", witness.at));
            if let Some(shown) = radius(block, &witness.limits) {
                let refutes = if witness.inside {
                    shown.not_continuous.is_some_and(|fails| fails <= said.m)
                } else {
                    shown.continuous.is_some_and(|holds| said.m <= holds)
                };
                if !refutes {
                    block.give_up(
                        "the rational bounds of the joint spectral radius do not show this",
                    );
                }
            }
            block.line(Word::Refuted);
        }
        (SmoothnessVerdict::RoundedEnds, ..) => {
            block.give_up("that a range is right up to rounding is not certified");
        }
        _ => block.give_up("there is no rational value that refutes it"),
    }
}
