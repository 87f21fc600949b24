//! Claims about smoothness: the joint spectral radius of the matrices, and what it shows.

use super::block::{Block, Certified};
use super::limits::radius;
use super::radius::LimitLines;
use super::{smooth_range, vertex};
use crate::audit::{Direction, KnownLimits, Limits, SmoothnessFinding, SmoothnessVerdict};
use crate::claim::{
    ExponentStatement, Paper, PrintedExponent, SmoothnessBody, SmoothnessStatement,
};
use crate::exact::{Decimal, LogSum, LogTerm, Rational};
use std::cmp::Ordering;

/// Why a finding has no certificate: the radius is enclosed by rational numbers.
const NOT_SHOWN: &str = "the rational bounds of the joint spectral radius do not show this";

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
            (_, KnownLimits::Limits(known)) => {
                block.restate("scheme", &scheme);
                restate(&mut block, statement);
                of_limits(&mut block, statement, known, self.verdict);
            }
            _ => block.give_up("nothing is known of the limits"),
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

fn of_limits(
    block: &mut Block,
    statement: &SmoothnessStatement,
    known: &Limits,
    verdict: SmoothnessVerdict,
) {
    let Some(lines) = radius(block, known) else { return };
    let shown = match statement {
        SmoothnessStatement::Continuity { continuous, not_continuous, .. } => {
            let [yes, no] = [continuous, not_continuous].map(|m| {
                m.map(|m| {
                    let yes = lines.continuous.is_some_and(|shown| m <= shown);
                    (yes, lines.not_continuous.is_some_and(|shown| shown <= m))
                })
            });
            let refuted = yes.is_some_and(|(_, fails)| fails) || no.is_some_and(|(holds, _)| holds);
            let confirmed = yes.is_none_or(|(holds, _)| holds) && no.is_none_or(|(_, fails)| fails);
            judged(refuted, confirmed)
        }
        SmoothnessStatement::Exponent { exponent, attained } => {
            let arity = known.mask.arity();
            let found = Exponent::of(&lines, arity).judged(exponent);
            let diverges = lines.not_continuous == Some(0);
            let found = if diverges { Some(SmoothnessVerdict::Refuted) } else { found };
            found.filter(|found| attained.is_none() || *found == SmoothnessVerdict::Refuted)
        }
        SmoothnessStatement::Range(_) | SmoothnessStatement::Region(_) => None,
    };
    if let SmoothnessStatement::Exponent { exponent, .. } = statement
        && bases(exponent).any(|base| base != known.mask.arity())
    {
        block.give_up("logarithms to another base than the arity are not certified");
    }
    if shown != Some(verdict) {
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

fn judged(refuted: bool, confirmed: bool) -> Option<SmoothnessVerdict> {
    let confirmed = confirmed.then_some(SmoothnessVerdict::Confirmed);
    if refuted { Some(SmoothnessVerdict::Refuted) } else { confirmed }
}

/// The bases of the logarithms of a printed exponent.
fn bases(exponent: &ExponentStatement) -> impl Iterator<Item = usize> {
    let printed = match exponent {
        ExponentStatement::Value(value) => [Some(value), None],
        ExponentStatement::Bounds { at_least, at_most } => [at_least.as_ref(), at_most.as_ref()],
        ExponentStatement::Decimal { .. } => [None, None],
    };
    printed.into_iter().flatten().flat_map(|value| &value.value.terms).map(|term| term.base)
}

/// The bounds of an exponent that the lines show.
struct Exponent {
    lower: Option<LogSum>,
    upper: Option<LogSum>,
}

impl Exponent {
    fn of(lines: &LimitLines, arity: usize) -> Exponent {
        let bound = |of: &Rational, degree: usize| {
            let factor = -Rational::from(degree).recip();
            let term = LogTerm { factor, base: arity, of: of.clone() };
            LogSum { rational: Rational::from(lines.order), terms: vec![term] }
        };
        Exponent {
            lower: lines.continuous.map(|_| bound(&lines.at_most, 1)),
            upper: lines.at_least.as_ref().map(|(of, degree)| bound(of, *degree)),
        }
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    fn at_least(&self, value: &LogSum, strictly: bool) -> bool {
        let order = self.lower.as_ref().and_then(|lower| lower.compare(value));
        order == Some(Ordering::Greater) || !strictly && order == Some(Ordering::Equal)
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    fn at_most(&self, value: &LogSum, strictly: bool) -> bool {
        let order = self.upper.as_ref().and_then(|upper| upper.compare(value));
        order == Some(Ordering::Less) || !strictly && order == Some(Ordering::Equal)
    }

    fn judged(&self, statement: &ExponentStatement) -> Option<SmoothnessVerdict> {
        let bounds = |low: Option<&PrintedExponent>, high: Option<&PrintedExponent>| {
            let refuted = low.is_some_and(|value| self.at_most(&value.value, true))
                || high.is_some_and(|value| self.at_least(&value.value, true));
            let confirmed = low.is_none_or(|value| self.at_least(&value.value, false))
                && high.is_none_or(|value| self.at_most(&value.value, false));
            judged(refuted, confirmed)
        };
        match statement {
            ExponentStatement::Value(value) => bounds(Some(value), Some(value)),
            ExponentStatement::Bounds { at_least, at_most } => {
                bounds(at_least.as_ref(), at_most.as_ref())
            }
            ExponentStatement::Decimal { decimal, .. } => self.rounded(decimal),
        }
    }

    fn rounded(&self, decimal: &Decimal) -> Option<SmoothnessVerdict> {
        let half = decimal.unit() / Rational::from(2);
        let place = |halves: i64| LogSum::from(decimal.value() + &half * Rational::from(halves));
        let between = |low, high, strictly| {
            self.at_least(&place(low), strictly) && self.at_most(&place(high), strictly)
        };
        // Of an exponent that is cut some digit is left, and none is below half a unit and rounded to one.
        let above = if decimal.mantissa().is_zero() { (1, true) } else { (2, false) };
        let below = if decimal.is_one_unit() { (-1, true) } else { (-2, false) };
        if self.at_least(&place(above.0), above.1) || self.at_most(&place(below.0), below.1) {
            Some(SmoothnessVerdict::Refuted)
        } else if between(-1, 1, false) {
            Some(SmoothnessVerdict::Confirmed)
        } else if between(1, 2, true) {
            Some(SmoothnessVerdict::Rounding(Direction::Cut))
        } else {
            between(-2, -1, true).then_some(SmoothnessVerdict::Rounding(Direction::Away))
        }
    }
}
