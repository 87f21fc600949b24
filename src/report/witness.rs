//! The data that refute a theorem.

use super::numbers::{DIGITS, exact, points};
use super::shift;
use crate::audit::{Control, Naturally, Place, Refutation, TheoremFinding, Violation};
use crate::claim::Quantity;
use crate::exact::format::short;

/// What it takes to check the refutation by hand.
pub(super) fn facts(finding: &TheoremFinding<'_>) -> Vec<(String, String)> {
    let Some(refutation) = &finding.refutation else { return Vec::new() };
    let Refutation { case, violation, supremum, sound, natural, every_shift, .. } = refutation;
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    // What does not depend on where the points are comes first.
    if let Some(found) = every_shift {
        shift::facts(found, &mut fact);
    }
    match natural {
        None => {}
        Some(Naturally::Refuted { case, violation, .. }) => {
            fact("at natural parameters", format!("refuted too, for {case}"));
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
    fact("control data", control(&violation.attained.control));
    fact(&value_name(violation), exact(&violation.attained.value));
    fact("claimed at most", exact(&violation.bound));
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

/// `x_-2, …, x_1 = 0, 1, 2, 1`.
fn control(control: &Control) -> String {
    match control {
        Control::Polygon(polygon) => points("x", polygon),
        Control::Net { first: [i, j], rows } => {
            let row = |row: &Vec<i64>| {
                row.iter().map(ToString::to_string).collect::<Vec<String>>().join(", ")
            };
            let rows: Vec<String> = rows.iter().map(row).collect();
            format!("from x_{i},{j} on, row by row: {}", rows.join(" | "))
        }
        Control::Points(points) => {
            let list: Vec<String> =
                points.iter().map(|(name, height)| format!("{name} = {height}")).collect();
            list.join(", ")
        }
    }
}

/// Of points around a vertex or on a face, what is compared with what.
///
/// The distance of a point from its limit is at most the sum of its steps, which proofs telescope:
/// what is above a bound of the distance refutes the same bound of that sum.
pub(super) fn compared(finding: &TheoremFinding<'_>) -> Option<&'static str> {
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

/// The quantity at its place: `|P^∞(t) − P^2(t)| at t = 3/8`.
fn value_name(violation: &Violation) -> String {
    let k = violation.level;
    match (&violation.attained.place, violation.quantity) {
        (Place::Parameter(t), _) => format!("|P^∞(t) − P^{k}(t)| at t = {t}"),
        (Place::Parameters([s, t]), _) => {
            format!("|P^∞(s, t) − P^{k}(s, t)| at s = {s}, t = {t}")
        }
        (Place::Point(i), _) => format!("step to the point {i} of level {}", k + 1),
        (Place::Difference(i), _) => format!("|Δ^{k}_i| at i = {i}"),
        (place, Quantity::Distance) => format!("distance of {} at level {k}", name(place)),
        (place, Quantity::Step) => format!("step of {} after level {k}", name(place)),
        (place, Quantity::Difference) => format!("difference {} at level {k}", name(place)),
    }
}

/// A place in a few words.
pub(super) fn name(place: &Place) -> String {
    match place {
        Place::Parameter(t) => t.to_string(),
        Place::Parameters([s, t]) => format!("({s}, {t})"),
        Place::Point(i) | Place::Difference(i) => i.to_string(),
        Place::Points([i, j]) => format!("({i}, {j})"),
        Place::Along([i, j], 0) => format!("({i}, {j}), first index"),
        Place::Along([i, j], _) => format!("({i}, {j}), second index"),
        Place::Named(name) => name.clone(),
        Place::Edge([a, b]) => format!("{a} – {b}"),
    }
}
