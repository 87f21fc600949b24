//! The places of the values of φ that are seen from a tile.

use super::tiling::{Tiling, inverse};
use super::window::{largest, radius};
use crate::cap::Cap;
use crate::scheme::{LatticeMask, Point, apply, difference, sum};
use std::collections::{BTreeSet, HashSet};

/// The places α for which φ(x + α) may be other than 0 for some x of the tile: the largest set in which each α has a β with a(Mα + t − Gβ) among the
/// coefficients, for a part (G, t) of the tiling.
///
/// # Errors
/// As [`attractor`](super::attractor).
pub(super) fn of_tiling<S>(mask: &LatticeMask<S>, tiling: &Tiling) -> Result<Vec<Point>, Cap> {
    let places = || mask.coefficients().keys();
    let moved = tiling.parts.iter().flat_map(|part| {
        let shift = part.shift;
        places().map(move |place| difference(*place, shift))
    });
    let images: BTreeSet<Point> =
        moved.flat_map(|place| tiling.group.iter().map(move |g| apply(g, place))).collect();
    let before = |image: Point, window: &HashSet<Point>| {
        tiling.parts.iter().any(|part| {
            // Gβ = Mα + t − γ.
            let back = inverse(&part.matrix);
            let corner = sum(image, part.shift);
            places().any(|place| window.contains(&apply(&back, difference(corner, *place))))
        })
    };
    largest(mask.dilation(), radius(mask.dilation(), &images)?, before)
}
