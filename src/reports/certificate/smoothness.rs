//! Claims about smoothness: the joint spectral radius of the matrices, and what it shows.

use super::block::{Block, Certified};
use super::limits::{NOT_SHOWN, known_limits};
use super::shown::Shown;
use super::{smooth_range, vertex};
use crate::audit::{Direction, KnownLimits, SmoothnessFinding, SmoothnessVerdict};
use crate::claim::{ExponentStatement, Paper, SmoothnessBody, SmoothnessStatement};

impl Certified for SmoothnessFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let claim = self.claim;
        let mut block = Block::new(claim.kind.name(), &claim.id);
        let (scheme, statement) = match &claim.body {
            SmoothnessBody::NotCheckable(absent) => {
                block.restate("absent", absent);
                return block;
            }
            SmoothnessBody::Statement(scheme, statement) => (scheme, &**statement),
        };
        match &self.known {
            KnownLimits::Capped(why) => block.give_up(why.to_string()),
            KnownLimits::BeyondCap(cap) => block.give_up(cap.to_string()),
            _ if self.verdict == SmoothnessVerdict::Open => block.give_up("it is open"),
            _ => {}
        }
        let scheme = scheme.reference.to_string();
        match (statement, &self.known) {
            (SmoothnessStatement::Range(range), KnownLimits::Range(known)) => {
                smooth_range::lines(&mut block, range, &scheme, known, self.verdict);
            }
            (SmoothnessStatement::Region(region), KnownLimits::Region(known)) => {
                smooth_range::region_lines(&mut block, region, &scheme, known, self.verdict);
            }
            (SmoothnessStatement::Range(range), KnownLimits::VertexRanges(known)) => {
                vertex::range_lines(&mut block, range, &scheme, known, self.verdict);
            }
            (
                SmoothnessStatement::Continuity { continuous, not_continuous, valences },
                KnownLimits::Vertices(known),
            ) => {
                block.restate("scheme", &scheme);
                restate(&mut block, statement);
                if let Some(valences) = valences {
                    block.restate("valences", &valences.text);
                }
                let orders = [*continuous, *not_continuous];
                vertex::lines(&mut block, known, orders, self.verdict);
            }
            (_, known) => {
                block.restate("scheme", &scheme);
                restate(&mut block, statement);
                if let Some(shown) = known_limits(&mut block, known) {
                    of_limits(&mut block, statement, &shown, self.verdict);
                }
            }
        }
        block
    }
}

fn restate(block: &mut Block, statement: &SmoothnessStatement) {
    match statement {
        SmoothnessStatement::Continuity { continuous, not_continuous, .. } => {
            let orders =
                [("states-continuous", continuous), ("states-not-continuous", not_continuous)];
            for (word, order) in orders {
                if let Some(m) = order {
                    block.line(format!("{word} {m}"));
                }
            }
        }
        SmoothnessStatement::Exponent { exponent, .. } => match exponent {
            ExponentStatement::Value(printed) => block.restate("value", &printed.text),
            ExponentStatement::Decimal { text, .. } => block.restate("printed", text),
            ExponentStatement::Bounds { at_least, at_most } => {
                for (word, bound) in [("at-least", at_least), ("at-most", at_most)] {
                    if let Some(bound) = bound {
                        block.restate(word, &bound.text);
                    }
                }
            }
        },
        SmoothnessStatement::Range(_) | SmoothnessStatement::Region(_) => {}
    }
}

/// The verdict on a claim about the limits of one mask, if it is shown.
fn of_limits(
    block: &mut Block,
    statement: &SmoothnessStatement,
    shown: &Shown,
    verdict: SmoothnessVerdict,
) {
    let found = match statement {
        SmoothnessStatement::Continuity { continuous, not_continuous, .. } => {
            shown.continuity(*continuous, *not_continuous)
        }
        SmoothnessStatement::Exponent { exponent, attained } => {
            if !shown.compares(exponent) {
                block.give_up(
                    "logarithms to another base than that of the scheme are not certified",
                );
            }
            shown.exponent(exponent, *attained)
        }
        SmoothnessStatement::Range(_) | SmoothnessStatement::Region(_) => None,
    };
    if found != Some(verdict) {
        let attained = matches!(statement, SmoothnessStatement::Exponent { attained: Some(_), .. });
        block.give_up(if attained {
            "whether an exponent is attained is not certified"
        } else {
            NOT_SHOWN
        });
    }
    block.line(match verdict {
        SmoothnessVerdict::Rounding(Direction::Cut) => "rounding cut".to_owned(),
        SmoothnessVerdict::Rounding(_) => "rounding away".to_owned(),
        other => other.word().into(),
    });
}
