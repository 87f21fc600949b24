//! Ranges of one parameter or two for which limits are C^m: a contraction, or values that refute the range.

use super::block::Block;
use super::lattice::cover;
use super::limits::{NOT_SHOWN, known_limits};
use super::parametric::pieces;
use crate::audit::{RangeOfLimits, RegionOfLimits, SmoothSets, SmoothnessVerdict, Witness, Word};
use crate::claim::{SmoothRangeStatement, SmoothRegionStatement};
use crate::exact::Rational;

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
            shifts(block, &contraction.reduction);
            pieces(block, &contraction.below, &contraction.above);
            block.line(Word::Confirmed);
        }
        (SmoothnessVerdict::Confirmed, ..) if said.only => {
            block.give_up("that the limits are less smooth for all other values is not certified");
        }
        (SmoothnessVerdict::Confirmed, ..) => {
            confirming(block, known);
        }
        (SmoothnessVerdict::Refuted, _, Some(witness)) => {
            block.line(format!("at {}", witness.at));
            refuting(block, witness, said.m);
        }
        (SmoothnessVerdict::RoundedEnds, ..) => {
            block.give_up("that a range is right up to rounding is not certified");
        }
        _ => block.give_up("there is no rational value that refutes it"),
    }
}

/// What shows that all limits are C^m in the whole range, of a mask on Z^d.
fn confirming(block: &mut Block, known: &RangeOfLimits) {
    let Some(SmoothSets::Lattice(range)) = &known.sets else {
        block.give_up("the proof by hulls on many intervals is not certified");
        return;
    };
    match range.proof(&known.printed) {
        Some(proof) => {
            cover(&proof, range.dimension()).lines().for_each(|line| block.line(line));
            block.line(Word::Confirmed);
        }
        None => block.give_up("no hulls on pieces of the range are found"),
    }
}

/// A region of two parameters.
pub(super) fn region_lines(
    block: &mut Block,
    said: &SmoothRegionStatement,
    scheme: &str,
    known: &RegionOfLimits,
    verdict: SmoothnessVerdict,
) {
    block.line(format!("variables {}", said.variables.join(" ")));
    block.restate("scheme", scheme);
    block.line(format!("smoothness {}", said.m));
    for text in &said.texts {
        block.restate("where", text);
    }
    match (verdict, &known.proof, &known.witness) {
        (SmoothnessVerdict::Refuted, _, Some(witness)) => {
            let [x, y] = &witness.at;
            block.line(format!("at {x} {y}"));
            refuting(block, witness, said.m);
        }
        (SmoothnessVerdict::Confirmed, Some(proof), _) => {
            block.line(format!("contraction {}", proof.levels));
            shifts(block, &proof.reduction);
            block.line(Word::Confirmed);
        }
        _ => block.give_up("there is neither a proof nor a point that refutes it"),
    }
}

/// The polynomials by which the symbol is reduced.
fn shifts(block: &mut Block, reduction: &[Vec<Rational>]) {
    for g in reduction {
        let g: Vec<String> = g.iter().map(ToString::to_string).collect();
        block.line(format!("shifts {}", g.join(" ")));
    }
}

/// What is known of the limits at a value that refutes a range.
fn refuting<P>(block: &mut Block, witness: &Witness<P>, m: usize) {
    if let Some(shown) = known_limits(block, &witness.limits) {
        let order = Some(m);
        let [holds, fails] = if witness.inside { [None, order] } else { [order, None] };
        if shown.continuity(holds, fails) != Some(SmoothnessVerdict::Confirmed) {
            block.give_up(NOT_SHOWN);
        }
    }
    block.line(Word::Refuted);
}
