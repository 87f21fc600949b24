//! The data that refute a theorem.

use crate::audit::{Control, EveryShift, Naturally, Place, Refutation, Unshiftable, Violation};
use crate::claim::Quantity;
use crate::exact::Rational;
use crate::exact::{RealCyclotomic, format::short};
use crate::limit::{ExtremalPolygon, Overshoot, Shown};

/// How many digits a decimal has.
const DIGITS: u32 = 12;

/// What it takes to check the refutation by hand.
pub(super) fn facts(refutation: &Refutation) -> Vec<(String, String)> {
    let Refutation { case, violation, supremum, sound, natural, every_shift, .. } = refutation;
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    // What does not depend on where the points are comes first.
    every_shift.iter().for_each(|found| in_every_shift(found, &mut fact));
    match natural {
        None => {}
        Some(Naturally::Refuted { case, violation, .. }) => {
            fact("at natural parameters", format!("refuted too, for {case}"));
            fact("control data", control(&violation.attained.control));
            fact(&value_name(violation), exact(&violation.attained.value));
            fact("claimed at most", exact(&violation.bound));
        }
        Some(Naturally::Holds) => {
            let text = "not refuted: there it holds at the levels that were looked at";
            fact("at natural parameters", text.to_owned());
        }
        Some(Naturally::Open) => {
            fact("at natural parameters", "open: not refuted, and not shown".to_owned());
        }
    }
    if let Some(text) = compared(violation) {
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

/// Whether the theorem is refuted in every shift, and the two greatest values that show it.
fn in_every_shift(found: &EveryShift, fact: &mut impl FnMut(&str, String)) {
    let name = "in every shift (i + s)/n^k";
    let (case, data) = match found {
        EveryShift::Refuted { case, data, .. } => (case, &**data),
        EveryShift::Holds => {
            return fact(name, "not refuted: there is a shift, the next one here".to_owned());
        }
        EveryShift::Open => return fact(name, "open: not refuted, and not shown".to_owned()),
    };
    let Unshiftable { quantity, level: k, overshoot, bound } = data;
    let Overshoot { polygons, greatest, later, shown } = overshoot;
    let rational = |value: &Rational| exact(&value.clone().into());
    let name_of = |net: &str, curve: &str| {
        if polygons.len() == 2 { net.to_owned() } else { curve.to_owned() }
    };
    fact(name, format!("refuted for {case}, by one and the same data"));
    for (polygon, letter) in polygons.iter().zip(["a", "b"]) {
        let letter = if polygons.len() == 2 { letter } else { "x" };
        fact("control data", points(letter, polygon));
    }
    if polygons.len() == 2 {
        fact("", "of the net a_i + b_j".to_owned());
    }
    fact(&format!("greatest point of level {k}"), rational(greatest));
    let (what, how) = match shown {
        Shown::Points => (format!("greatest point of level {}", k + 1), String::new()),
        Shown::AtMost(levels) => {
            let levels: Vec<String> = levels.iter().map(ToString::to_string).collect();
            let by = levels.join(" and ");
            (
                name_of("greatest value of P^∞(s, t)", "greatest value of P^∞(t)"),
                format!("at most, by level {by}, "),
            )
        }
        Shown::AtLeast(places) => {
            let places: Vec<String> = places.iter().map(ToString::to_string).collect();
            let at = places.join(", ");
            (
                name_of("greatest value of P^∞(s, t)", "greatest value of P^∞(t)"),
                format!("at least, by that at {at}, "),
            )
        }
    };
    fact(&what, format!("{how}{}", rational(later)));
    let of = match quantity {
        Quantity::Step => "step",
        Quantity::Distance | Quantity::Difference => "distance",
    };
    fact(&format!("{of} in every shift"), format!("at least {}", rational(&overshoot.gap())));
    fact("claimed at most", exact(bound));
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

fn points(letter: &str, ExtremalPolygon { first, points }: &ExtremalPolygon) -> String {
    let list: Vec<String> = points.iter().map(ToString::to_string).collect();
    let last = first + i64::try_from(points.len()).unwrap_or(1) - 1;
    format!("{letter}_{first}, …, {letter}_{last} = {}", list.join(", "))
}

/// Of points around a vertex or on a face, what is compared with what.
fn compared(violation: &Violation) -> Option<&'static str> {
    let Control::Points(_) = violation.attained.control else { return None };
    Some(match violation.quantity {
        Quantity::Distance => "a point of level k with the one point that all of them tend to",
        Quantity::Step => {
            "a point of level k + 1 with the one of its name, or of the interpolant, at level k"
        }
        Quantity::Difference => "two neighbouring points of level k",
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

fn exact(value: &RealCyclotomic) -> String {
    let (text, decimal) = (value.to_string(), short(value, DIGITS));
    if text == decimal { text } else { format!("{text} = {decimal}") }
}
