//! Theorems: control data that refute them, levels that prove them, or the statement that is cited.

use super::block::{Block, Certified, closed};
use super::constant::searched;
use super::promise::{flows, later};
use super::witness::{attained, list, unshiftable};
use crate::audit::{
    EveryShift, LevelEvidence, Levels, Naturally, Refutation, TheoremFinding, TheoremVerdict,
    Violation, Word, theorem_evidence,
};
use crate::claim::{Paper, Statement, Theorem};
use crate::exact::{Rational, RealCyclotomic};

impl Certified for TheoremFinding<'_> {
    fn block(&self, paper: &Paper) -> Block {
        let theorem = self.theorem;
        let mut block = Block::new("theorem", &theorem.id);
        match theorem_evidence(paper, self) {
            Ok(constants) => constants.iter().for_each(|constant| searched(&mut block, constant)),
            Err(error) => {
                block.give_up(error.message);
                return block;
            }
        }
        match (&self.refutation, &theorem.by_hand) {
            (Some(refutation), _) => {
                restate(&mut block, theorem);
                refuted(&mut block, theorem, refutation);
            }
            (None, Some(hand)) if self.verdict != TheoremVerdict::Open => {
                restate(&mut block, theorem);
                let word = if hand.refutes { "refuted-by" } else { "proved-by" };
                block.restate(word, &hand.text);
                block.line(self.verdict.word());
            }
            _ if self.verdict == TheoremVerdict::Open => block.line(Word::Open),
            _ => {
                restate(&mut block, theorem);
                match &self.levels {
                    Some(levels) => proved(&mut block, theorem, levels),
                    None => block.give_up("the levels that prove it are not known"),
                }
            }
        }
        block
    }
}

fn proved(block: &mut Block, theorem: &Theorem, levels: &Levels) {
    let Levels { period, ratio, times, evidence } = levels;
    let scheme = theorem.scheme.as_ref().map(|scheme| scheme.reference.to_string());
    block.restate("scheme", &scheme.unwrap_or_default());
    block.line(format!("grows {period} {}", closed(ratio)));
    block.line(format!("times {times}"));
    let evidence = match evidence {
        Ok(evidence) => evidence,
        Err(why) => return block.give_up(why.to_string()),
    };
    if let LevelEvidence::Flows { weights, contraction, .. } = evidence {
        if !weights.is_empty() {
            block.line(format!("weights {}", list(weights)));
        }
        flows(block, contraction);
    }
    let from = match &theorem.statement {
        Statement::Bound { from, .. } => *from,
        _ => 0,
    };
    for (i, level) in (from..).take((period * times) as usize).enumerate() {
        match evidence {
            LevelEvidence::Suprema => block.line(format!("level {level}")),
            LevelEvidence::Later(sums) => block.line(format!("level {level} {}", later(&sums[i]))),
            LevelEvidence::Flows { levels, .. } => {
                block.line(format!("level {level}"));
                flows(block, &levels[i]);
            }
        }
    }
    block.line(Word::Proved);
}

fn restate(block: &mut Block, theorem: &Theorem) {
    match &theorem.statement {
        Statement::Bound { quantity, by, .. } => {
            block.restate("bounds", quantity.name());
            block.restate("by", &by.text);
        }
        Statement::Depth(by) => {
            block.restate("bounds", "depth");
            block.restate("by", &by.text);
        }
        Statement::Other(says) => block.restate("says", says),
    }
}

fn refuted(block: &mut Block, theorem: &Theorem, refutation: &Refutation) {
    let Refutation { scheme, values, limit, violation, natural, every_shift, .. } = refutation;
    data(block, theorem, (scheme, values), limit, violation);
    if let Some(Naturally::Refuted { scheme, values, violation, certifiable: true, .. }) = natural {
        block.line("naturally");
        data(block, theorem, (scheme, values), &[], violation);
    }
    if let Some(EveryShift::Refuted { scheme, values, data, .. }) = every_shift {
        block.line("in-every-shift");
        case(block, (scheme, values));
        if matches!(theorem.statement, Statement::Depth(_)) {
            block.line(format!("tolerance {}", closed(&data.bound)));
        }
        unshiftable(block, data);
    }
    block.line(Word::Refuted);
}

fn case(block: &mut Block, (scheme, values): (&str, &[(String, Rational)])) {
    block.restate("scheme", scheme);
    for (name, value) in values {
        block.line(format!("let {name} {value}"));
    }
}

/// Writes the lines of an instance, of its control data, and of both sides.
fn data(
    block: &mut Block,
    theorem: &Theorem,
    of: (&str, &[(String, Rational)]),
    limit: &[RealCyclotomic],
    violation: &Violation,
) {
    case(block, of);
    let bound = closed(&violation.bound);
    if matches!(theorem.statement, Statement::Depth(_)) {
        block.line(format!("tolerance {bound}"));
    }
    block.line(format!("level {}", violation.level));
    attained(block, &violation.attained, limit);
    block.line(format!("sides {} {bound}", closed(&violation.attained.value)));
}
