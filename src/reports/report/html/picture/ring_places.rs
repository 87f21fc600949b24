//! Where the points of a ring are drawn: an orbit of one point in the middle, the others on circles.

use crate::scheme::LocalRules;
use std::f64::consts::TAU;

/// How far one circle is beyond the one before.
const APART: f64 = 0.45;

/// A place in the plane for each point. The first circle has the radius 1; a circle is turned so that its first
/// point stands beside its neighbours on earlier ones.
pub(super) fn places(ring: &LocalRules) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> = Vec::with_capacity(ring.point_count());
    let mut circles = 0_u16;
    for orbit in ring.orbits() {
        let first = places.len();
        if orbit.count == 1 {
            places.push([0.0; 2]);
            continue;
        }
        let turn = turned(ring, first, &places);
        let radius = 1.0 + APART * f64::from(circles);
        circles = circles.saturating_add(1);
        let count = f64::from(u32::try_from(orbit.count).unwrap_or(u32::MAX));
        let at = |j: u32| {
            let (sin, cos) = (turn + TAU * f64::from(j) / count).sin_cos();
            [radius * cos, radius * sin]
        };
        places.extend((0_u32..).take(orbit.count).map(at));
    }
    places
}

/// The angle of the mean of the neighbours of a point that have places; 0 where there is none.
fn turned(ring: &LocalRules, point: usize, places: &[[f64; 2]]) -> f64 {
    let neighbour = |&(a, b): &(usize, usize)| match point {
        point if point == a => Some(b),
        point if point == b => Some(a),
        _ => None,
    };
    let known = ring.edges().iter().filter_map(neighbour).filter_map(|other| places.get(other));
    let [x, y] = known.fold([0.0; 2], |[x, y], place| [x + place[0], y + place[1]]);
    if x.hypot(y) < 1e-6 { 0.0 } else { y.atan2(x) }
}
