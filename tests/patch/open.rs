//! Open polygons as sets of points: against nets that are constant in one direction.

use crate::common::{mask, r};
use crate::net::scheme;
use subcert::exact::Rational;
use subcert::limit::{Limit, Window, natural_shift};
use subcert::net::{Closed, Net};
use subcert::patch::{CurveSets, NetDistances};
use subcert::scheme::{Scheme, catalogue, parse_scheme};

/// The polygon, all x and then all y.
fn curve(name: &str, points: &[[i64; 2]]) -> CurveSets {
    let limit = Limit::new(&mask(name)).expect("it converges");
    let own = [0, 1].map(|c| points.iter().map(|point| Rational::from(point[c])).collect());
    CurveSets::new(&limit, &own, false).expect("enough points")
}

/// The net with the polygon at the heights 0 and 1.
fn cylinder(name: &str, points: &[[i64; 2]]) -> NetDistances {
    let point = |k: usize| {
        let [x, y] = points[k / 2];
        [x, y, i64::from(k % 2 == 1)].map(Rational::from)
    };
    let points = (0..2 * points.len()).map(point).collect();
    let net = Net::new(points, 2, Closed::default()).expect("a net");
    NetDistances::new(net, &scheme(&format!("{name} x b-spline:degree=1"))).expect("a net")
}

/// By dense samples of the polygons and of level 13 between the parameters 0 and 2, the distances of the levels from 0
/// on are 0.3578, 0.1430, 0.0500, 0.0150 and 0.0039.
#[test]
fn a_bend_at_an_end() {
    let mut points = [[0, 0], [1, 0], [1, 8], [1, 16]];
    for _ in 0..2 {
        let mut own = curve("chaikin", &points);
        for (tolerance, level) in [(10, 2), (50, 3), (100, 4), (500, 5)] {
            let tolerance = r(1, tolerance);
            let found = own.depth(&tolerance).expect("few levels");
            assert_eq!((found.level, found.too_few), (Some(level), Some(level - 1)));
            let far: Vec<f64> = found.places().map(|(_, place)| place.distance).collect();
            for (far, most) in far.iter().zip([0.357_84, 0.143_02, 0.049_99, 0.015_01, 0.003_93]) {
                assert!(*far <= most, "{far} {most}");
            }
            let net = cylinder("chaikin", &points).geometric_depth(&tolerance).expect("a depth");
            assert_eq!(net.level, Some(level));
        }
        assert_eq!(own.range(), Some(&[0, 2].map(Rational::from)));
        points.reverse();
    }
    // Three points determine the parabola y = 2 − 8(x − 1)² from x = 1/2 to 3/2: the corner is 2 above its top.
    let mut three = curve("chaikin", &[[0, -4], [1, 4], [2, -4]]);
    assert_eq!(three.range(), Some(&[0, 1].map(Rational::from)));
    for (tolerance, within) in [(r(21, 10), true), (r(19, 10), false)] {
        assert_eq!(three.is_within(0, &tolerance).expect("a tolerance"), Some(within));
    }
}

/// Every curve of the catalogue that takes lines to lines and whose differences fall at once.
#[test]
fn polygons_and_nets_agree() {
    let points = [[0, 0], [1, 3], [3, -1], [4, 2], [5, 0], [7, 1], [8, -2], [9, 1], [9, 4], [8, 6]];
    let (mut seen, mut shifted) = (0, 0);
    for entry in catalogue().iter().filter(|entry| !entry.is_ring()) {
        let name = entry.references().remove(0);
        let Ok(Scheme::Curve(mask)) = parse_scheme(&name) else { continue };
        let Ok(limit) = Limit::new(&mask) else { continue };
        let natural = natural_shift(&mask);
        let falls = limit.contraction().get(1).is_some_and(|first| *first < Rational::one());
        if !natural.keeps_lines || !falls {
            continue;
        }
        let size = Window::of(&mask, &natural.shift).expect("narrow").size();
        if size >= points.len() {
            continue;
        }
        let (points, tolerance) = (&points[..=size], r(1, 8));
        let (mut own, net) = (curve(&name, points), cylinder(&name, points));
        let [from, to] = own.range().expect("it is open");
        let whole = Some([from.ceil(), to.floor()].map(Rational::from));
        assert_eq!(net.ranges()[0], whole, "{name}");
        if own.range() != whole.as_ref() {
            continue;
        }
        let (Ok(own), Ok(net)) = (own.depth(&tolerance), net.geometric_depth(&tolerance)) else {
            continue;
        };
        assert_eq!((own.level, own.too_few), (net.level, net.too_few), "{name}");
        shifted += u32::from(!natural.shift.is_integer());
        seen += 1;
    }
    assert!(seen > 15 && shifted > 7, "{seen} {shifted}");
}

/// Schemes of arity 3 and 4 whose points determine a part of a cell at an end. The distances of the levels are those of
/// dense samples, and from both sides the same.
#[test]
fn a_part_of_a_cell_at_an_end() {
    type Case<'c> = (&'c str, &'c [[i64; 2]], [Rational; 2], [i64; 3]);
    let bend = [[0, 0], [1, 0], [1, 8], [1, 16]];
    let zigzag = [[0, 0], [1, 5], [3, -2], [4, 1], [6, 6]];
    let cases: [Case<'_>; 2] = [
        ("quaternary-b-spline:degree=2", &bend, [r(1, 3), r(7, 3)], [35_777, 4_986, 390]),
        ("ternary-four-point-approximating", &zigzag, [r(3, 2), r(2, 1)], [43_305, 12_554, 2_636]),
    ];
    for (name, points, range, distances) in cases {
        let mut points = points.to_vec();
        for _ in 0..2 {
            let mut own = curve(name, &points);
            assert_eq!(own.range(), Some(&range), "{name}");
            for (level, distance) in (0..).zip(distances) {
                let around = [(98, Some(false)), (102, Some(true))];
                for (percent, within) in around {
                    let tolerance = r(percent * distance, 10_000_000);
                    let found = own.is_within(level, &tolerance).expect("a tolerance");
                    assert_eq!(found, within, "{name}, {level}, {percent}");
                }
            }
            points.reverse();
        }
    }
}
