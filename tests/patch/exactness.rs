//! Tolerances that are too near to the distance for f64.

use super::{depth, grid, octahedron};
use crate::common::r;
use subcert::exact::Rational;
use subcert::mesh::MeshScheme;

/// A vertex (x, 0, 0) of the octahedron tends to (2x/5, 0, 0) under Loop's rules, as β = 31/256, ω =
/// 1/(4 + 96/31) and 1 − 4ω = 24/55: the distance 31/55 is attained.
#[test]
fn a_tolerance_just_below_the_distance() {
    let little = Rational::new(1, 10).pow(18);
    let distance = r(31, 55);
    let found = depth(&octahedron(), MeshScheme::Loop, &(&distance - &little));
    assert_eq!((found.level, found.too_few), (1, Some(0)));
    assert!(found.exact_pieces > 0, "{found:?}");
    let found = depth(&octahedron(), MeshScheme::Loop, &(&distance + r(1, 1000)));
    assert_eq!((found.level, found.too_few), (0, None));
}

/// A regular mesh whose distance is exactly the tolerance is within it, and by however little less it is
/// not.
#[test]
fn a_tolerance_that_is_the_distance() {
    let heights = [0, 0, 0, 0, 1, 0, 0, 0, 0];
    let mesh = grid(9, 9, false, |_, j| Rational::from(heights[j]));
    // The second difference −2 at the top, a sixth of it, and a quarter of that at the next level.
    for (level, distance) in [(0, r(1, 3)), (1, r(1, 12)), (2, r(1, 48))] {
        let found = depth(&mesh, MeshScheme::CatmullClark, &distance);
        assert_eq!(found.level, level, "{found:?}");
        assert!(found.exact_pieces > 0, "{found:?}");
        let less = &distance - Rational::new(1, 10).pow(30);
        let found = depth(&mesh, MeshScheme::CatmullClark, &less);
        assert_eq!((found.level, found.too_few), (level + 1, Some(level)), "{found:?}");
    }
}
