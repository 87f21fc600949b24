//! The data that refute a theorem.

use super::by_hand;
use super::shift;
use crate::audit::{ByHand, Control, KernelProof, Naturally, Refutation, TheoremFinding};
use crate::claim::Quantity;
use crate::exact::format::short;
use crate::report::words::data::{control, value_name};
use crate::report::words::kernel::CHECKED;
use crate::report::words::numbers::{DIGITS, exact};

/// The facts for checking the refutation by hand.
pub(crate) fn facts(finding: &TheoremFinding<'_>, hand: Option<&ByHand>) -> Vec<(String, String)> {
    let Some(refutation) = &finding.refutation else { return Vec::new() };
    let Refutation { case, violation, supremum, sound, natural, every_shift, .. } = refutation;
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    // Data that refute the theorem wherever the points are come first.
    if let Some(found) = every_shift {
        shift::facts(found, &mut fact);
    }
    match natural {
        None => {}
        Some(Naturally::Refuted { case, violation, .. }) => {
            let proved = finding.by_kernel.contains(&KernelProof::RefutedNaturally);
            let checked = if proved { CHECKED } else { "" };
            fact("at natural parameters", format!("refuted too, for {case}{checked}"));
            fact("control data", control(&violation.attained.control));
            fact(&value_name(violation), exact(&violation.attained.value));
            fact("claimed at most", exact(&violation.bound));
        }
        Some(Naturally::AsInEveryShift) => {
            fact("at natural parameters", "refuted too, by these data".to_owned());
        }
        Some(Naturally::Holds) => {
            let text = "not refuted: there it holds at the levels that were looked at";
            fact("at natural parameters", text.to_owned());
        }
        Some(Naturally::Open) => {
            fact("at natural parameters", "open: not refuted, and not shown".to_owned());
        }
    }
    if let Some(text) = compared(finding) {
        fact("compared", text.to_owned());
    }
    let place = if natural.is_some() { "with points at i/n^k" } else { "refuted for" };
    fact(place, if natural.is_some() { format!("refuted for {case}") } else { case.clone() });
    if let Some(hand) = hand {
        by_hand::facts(finding, refutation, hand, &mut fact);
    } else {
        fact("control data", control(&violation.attained.control));
        fact(&value_name(violation), exact(&violation.attained.value));
        fact("claimed at most", exact(&violation.bound));
    }
    if let Some(supremum) = supremum {
        let lower = &supremum.lower;
        let known = match &supremum.upper {
            Some(upper) if lower == upper => exact(lower),
            Some(upper) => format!("between {} and {}", short(lower, DIGITS), short(upper, DIGITS)),
            None => format!("at least {}", exact(lower)),
        };
        fact("best true bound at this level", known);
    }
    if let Some(sound) = sound {
        fact("sound block bound", short(sound, DIGITS));
    }
    facts
}

/// For rings, the two points that are compared.
///
/// The distance of a point from its limit is at most the sum of its steps, which proofs add up.
/// Data that exceed a bound of the distance therefore refute the same bound of that sum.
pub(crate) fn compared(finding: &TheoremFinding<'_>) -> Option<&'static str> {
    let violation = &finding.refutation.as_ref()?.violation;
    let Control::Points(_) = violation.attained.control else { return None };
    Some(match (violation.quantity, &finding.theorem.tried.interpolant) {
        (Quantity::Distance, _) => {
            "a point of level k with the one point that all of them tend to; the steps of this point from \
             level k on, which the proof adds up, sum to this distance at least"
        }
        (Quantity::Step, None) => "a point of level k + 1 with the one of its name at level k",
        (Quantity::Step, Some(_)) => {
            "a point of level k + 1 with the one of its name of the interpolant of level k"
        }
        (Quantity::Difference, _) => "two neighbouring points of level k",
    })
}
