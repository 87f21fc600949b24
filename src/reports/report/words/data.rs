//! Control data, and the places where they exceed a bound, in words.

use super::numbers::points;
use crate::audit::{Control, Place, PointsAt, Violation};
use crate::claim::Quantity;

/// `x_-2, …, x_1 = 0, 1, 2, 1`.
pub(crate) fn control(control: &Control) -> String {
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

/// The quantity at its place: `|P^∞(t) − P^2(t)| at t = 3/8`.
pub(crate) fn value_name(violation: &Violation) -> String {
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

/// The parameters of the points of level k along each direction: `(i − 1/2)/2^k`.
#[must_use]
pub fn parameters(points: &[PointsAt]) -> String {
    let at = |(PointsAt { arity, shift }, index): (&PointsAt, &str)| match shift.sign() {
        0 => format!("{index}/{arity}^k"),
        1 => format!("({index} + {shift})/{arity}^k"),
        _ => format!("({index} − {})/{arity}^k", shift.abs()),
    };
    points.iter().zip(["i", "j"]).map(at).collect::<Vec<String>>().join(" and ")
}

/// A place in a few words.
pub(crate) fn name(place: &Place) -> String {
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
