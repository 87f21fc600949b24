//! Data that exceed a bound, drawn: control points, level k, limit, and the place.

mod exceeding;
mod net;
mod polygon;
mod ring;

use crate::audit::{Control, Refiner};
pub(crate) use exceeding::Exceeding;
use maud::Markup;

/// The data with what they are refined by; `None` where the place is not at points of a picture, or the level
/// has too many of them.
pub(crate) fn witness(refiner: &Refiner, exceeding: &Exceeding<'_>) -> Option<Markup> {
    match (refiner, &exceeding.attained.control) {
        (Refiner::Masks(masks), control) => match (&masks[..], control) {
            ([mask], Control::Polygon(polygon)) => polygon::drawing(mask, polygon, exceeding),
            ([first, second], Control::Net { first: corner, rows }) => {
                net::drawing([first, second], (*corner, rows), exceeding)
            }
            _ => None,
        },
        (Refiner::Ring(ring), Control::Points(points)) => ring::drawing(ring, points, exceeding),
        (Refiner::Ring(_), _) => None,
    }
}
