//! Theorems: control data that refute them, or the statement that proves them.

use super::block::{Block, closed};
use super::witness::{net, polygon, ring};
use crate::audit::{Control, Place, Refutation, TheoremFinding, TheoremVerdict};
use crate::claim::{Statement, Theorem};

pub(super) fn block(finding: &TheoremFinding<'_>) -> Block {
    let theorem = finding.theorem;
    let mut block = Block::new("theorem", &theorem.id);
    match (&finding.refutation, &theorem.by_hand) {
        (Some(refutation), _) => {
            restate(&mut block, theorem);
            refuted(&mut block, theorem, refutation);
        }
        (None, Some(hand)) if finding.verdict != TheoremVerdict::Open => {
            restate(&mut block, theorem);
            let word = if hand.refutes { "refuted-by" } else { "proved-by" };
            block.restate(word, &hand.text);
            block.line(finding.verdict.name());
        }
        _ if finding.verdict == TheoremVerdict::Open => block.line("open"),
        _ => block.give_up("the format has no words for a proof by finitely many levels"),
    }
    block
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
    let Refutation { scheme, values, limit, violation, .. } = refutation;
    block.restate("scheme", scheme);
    for (name, value) in values {
        block.line(format!("let {name} {value}"));
    }
    let bound = closed(&violation.bound);
    if matches!(theorem.statement, Statement::Depth(_)) {
        block.line(format!("tolerance {bound}"));
    }
    block.line(format!("level {}", violation.level));
    let place = &violation.attained.place;
    match &violation.attained.control {
        Control::Polygon(points) => polygon(block, points),
        Control::Net { first, rows } => {
            net(block, *first, rows, matches!(place, Place::Along(..)));
        }
        Control::Points(points) => {
            let heights: Vec<i64> = points.iter().map(|(_, height)| *height).collect();
            ring(block, &heights, limit);
        }
    }
    let place = match place {
        Place::Parameter(t) => t.to_string(),
        Place::Parameters([s, t]) => format!("{s} {t}"),
        Place::Point(i) | Place::Difference(i) => i.to_string(),
        Place::Points([i, j]) => format!("{i} {j}"),
        Place::Along([i, j], axis) => format!("{i} {j} {}", axis + 1),
        Place::Named(name) => name.clone(),
        Place::Edge([a, b]) => format!("{a} {b}"),
    };
    block.line(format!("at {place}"));
    block.line(format!("sides {} {bound}", closed(&violation.attained.value)));
    block.line("refuted");
}
