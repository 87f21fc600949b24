//! Open polygons at equal parameters: one domain for all levels.

use crate::common::{mask, r};
use subcert::exact::Rational;
use subcert::limit::{ControlPolygon, Distances, Limit};

/// A dual scheme far from its limit at an end: the points 1000, 0, …, 0. The distances are those of dense samples of
/// refined polygons between the parameters 2 and 12.
#[test]
fn far_at_an_end() {
    let limit = Limit::new(&mask("dual-four-point:w=1/128")).expect("a limit");
    let distances = Distances::natural(&limit).expect("distances");
    let mut points = vec![Rational::zero(); 16];
    points[0] = Rational::from(1000);
    for _ in 0..2 {
        let open = ControlPolygon::open(&points);
        for (k, expected) in [(0, 26_042), (1, 26_042), (2, 7_731), (3, 2_009), (4, 507)] {
            let found = distances.of_polygon(&open, k, &r(1, 1_000_000)).expect("few cells");
            let off = (found.enclosure.upper() - r(expected, 10_000)).abs();
            assert!(off < r(1, 10_000), "{k}: {:?}", found.enclosure);
        }
        let depth = distances.depth_of_polygon(&open, &r(135, 100)).expect("few levels");
        assert_eq!((depth.lower, depth.upper), (2, 2));
        points.reverse();
    }
}
