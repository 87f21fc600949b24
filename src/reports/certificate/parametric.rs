//! Closed forms in a free parameter, and ranges of one: signs on the pieces of the line.

use super::block::{Block, Certified, words};
use crate::audit::{
    Direction, EndFinding, EndRelation, FunctionFinding, FunctionVerdict, RangeFinding, Word,
};
use crate::claim::{Limit, LocatedReference, Paper};
use crate::exact::{IntervalSet, RealAlgebraic};
use std::fmt::Display;
use std::ops::Bound;

impl Certified for FunctionFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let claim = self.claim;
        let mut block = Block::new("function", &claim.id);
        head(&mut block, &claim.variable, claim.scheme.as_ref());
        block.restate("left", &claim.left.text);
        block.restate("right", &claim.right.text);
        match &self.verdict {
            FunctionVerdict::Holds => {
                pieces(&mut block, &self.below, &self.above);
                block.line(Word::Holds);
            }
            FunctionVerdict::Fails { example, .. } => {
                pieces(&mut block, &self.below, &self.above);
                block.line(format!("fails {} {} {}", example.at, example.left, example.right));
            }
            FunctionVerdict::BeyondCap(cap) => block.give_up(cap.to_string()),
        }
        block
    }
}

impl Certified for RangeFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let claim = self.claim;
        let mut block = Block::new("range", &claim.id);
        head(&mut block, &claim.variable, claim.scheme.as_ref());
        block.restate("value", &claim.value.text);
        let relation = match claim.limit {
            Limit::Below(_) => "below",
            Limit::AtMost(_) => "at-most",
        };
        block.restate(relation, &claim.limit.formula().text);
        let found = match &self.found {
            Ok(found) => found,
            Err(cap) => {
                block.give_up(cap.to_string());
                return block;
            }
        };
        pieces(&mut block, &found.below, &found.above);
        let sides = [("from", &claim.from), ("to", &claim.to)];
        let printed = sides.into_iter().filter(|(_, printed)| printed.is_some());
        for ((side, _), end) in printed.zip(&found.ends) {
            let exact = end.exact.as_ref().map_or("none".to_owned(), place);
            block.line(format!("end {side} \"{}\" {exact} {}", end.printed, self::relation(end)));
        }
        block.line(found.verdict.word());
        block
    }
}

fn head(block: &mut Block, variable: &str, scheme: Option<&LocatedReference>) {
    block.line(format!("variable {variable}"));
    if let Some(scheme) = scheme {
        block.restate("scheme", &scheme.reference.to_string());
    }
}

/// The lines `breaks` and `signs` of a function that is negative on one set and positive on
/// another, and 0 elsewhere.
pub(super) fn pieces(block: &mut Block, below: &IntervalSet, above: &IntervalSet) {
    let intervals = below.intervals().iter().chain(above.intervals());
    let ends = intervals.flat_map(|interval| [&interval.low, &interval.high]);
    let mut breaks: Vec<RealAlgebraic> = ends
        .filter_map(|end| match end {
            Bound::Included(place) | Bound::Excluded(place) => Some(place.clone()),
            Bound::Unbounded => None,
        })
        .collect();
    breaks.sort();
    breaks.dedup();
    let sign = |x: &RealAlgebraic| match (contains(below, x), contains(above, x)) {
        (true, _) => "-",
        (_, true) => "+",
        _ => "0",
    };
    let mut signs = Vec::new();
    for (i, between) in RealAlgebraic::rationals_between(&breaks).into_iter().enumerate() {
        signs.push(sign(&between.into()));
        signs.extend(breaks.get(i).map(sign));
    }
    let places: Vec<String> = breaks.iter().map(place).collect();
    block.line(words(&format!("breaks {}", places.join(" "))));
    block.line(format!("signs {}", signs.join(" ")));
}

fn contains(set: &IntervalSet, place: &RealAlgebraic) -> bool {
    set.intervals().iter().any(|interval| {
        let above = match &interval.low {
            Bound::Unbounded => true,
            Bound::Included(low) => low <= place,
            Bound::Excluded(low) => low < place,
        };
        above
            && match &interval.high {
                Bound::Unbounded => true,
                Bound::Included(high) => place <= high,
                Bound::Excluded(high) => place < high,
            }
    })
}

/// `3/2`, or `root:-2,0,1:1:2`: a polynomial, and an interval with exactly one root of it.
pub(super) fn place(place: &RealAlgebraic) -> String {
    if let Some(rational) = place.as_rational() {
        return rational.to_string();
    }
    let polynomial = place.minimal_polynomial().unwrap_or_else(|| place.polynomial());
    let coefficients: Vec<String> =
        polynomial.coefficients().iter().map(ToString::to_string).collect();
    let (low, high) = place.bounds();
    format!("root:{}:{low}:{high}", coefficients.join(","))
}

fn relation(end: &EndFinding) -> impl Display {
    match end.relation {
        EndRelation::Equal => "equal",
        EndRelation::Belonging => "belonging",
        EndRelation::Nearest => "nearest",
        EndRelation::Rounded(Direction::Cut | Direction::DepthDown) => "cut",
        EndRelation::Rounded(Direction::Away | Direction::DepthNearest) => "away",
        EndRelation::LastInside => "last-inside",
        EndRelation::FewDigits | EndRelation::Apart => "apart",
    }
}
