//! Theorems in every shift of the parameter.

use crate::audit::{EveryShift, Unshiftable};
use crate::claim::Quantity;
use crate::exact::Rational;
use crate::limit::{Overshoot, ProofOfGreatest};
use crate::report::words::numbers::{exact, points};

/// Whether a theorem is refuted in every shift, and the two greatest values that show it.
pub(crate) fn facts(found: &EveryShift, fact: &mut impl FnMut(&str, String)) {
    let name = "in every shift (i + s)/n^k";
    let (case, data) = match found {
        EveryShift::Refuted { case, data, .. } => (case, &**data),
        EveryShift::Holds => {
            return fact(name, "no: at the natural parameters it is not refuted".to_owned());
        }
        EveryShift::Open => return fact(name, "open: not refuted, and not shown".to_owned()),
    };
    let Unshiftable { quantity, level: k, overshoot, bound } = data;
    let Overshoot { polygons, greatest, later, shown } = overshoot;
    let rational = |value: &Rational| exact(&value.clone().into());
    let net = polygons.len() == 2;
    let of = if net { "the same net a_i + b_j" } else { "the same data" };
    fact(name, format!("refuted for {case}, by {of} in all of them"));
    let letters = if net { ["a", "b"] } else { ["x", ""] };
    for (polygon, letter) in polygons.iter().zip(letters) {
        fact("control data", format!("{}, constant beyond", points(letter, polygon)));
    }
    fact(&format!("greatest point of level {k}"), rational(greatest));
    let limit = if net { "greatest P^∞(s, t)" } else { "greatest P^∞(t)" };
    let (what, how) = match shown {
        ProofOfGreatest::Points => (format!("greatest point of level {}", k + 1), String::new()),
        ProofOfGreatest::AtMost(levels) => {
            (limit.to_owned(), format!("at most, by level {}, ", list(levels, " and ")))
        }
        ProofOfGreatest::AtLeast(places) => {
            (limit.to_owned(), format!("at least, by that at {}, ", list(places, ", ")))
        }
    };
    fact(&what, format!("{how}{}", rational(later)));
    let of = if *quantity == Quantity::Step { "step" } else { "distance" };
    fact(&format!("{of} in every shift"), format!("at least {}", rational(&overshoot.gap())));
    fact("claimed at most", exact(bound));
}

fn list<T: std::fmt::Display>(items: &[T], between: &str) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<String>>().join(between)
}
