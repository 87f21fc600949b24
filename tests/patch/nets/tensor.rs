//! Nets against curves and surfaces whose distances another part of the program computes exactly.

use super::{depth, distances};
use crate::common::{mask, r};
use crate::net::{heights, scheme};
use subcert::bound::Budget;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::limit::{
    Comparison, ControlPolygon, Distances, Limit, Parametrisation, Spreads, SurfaceDistances,
};

const HEIGHTS: [i64; 20] = [0, 5, 0, 2, 0, 0, 0, 0, 3, -1, 4, 1, -5, 0, 0, 0, 0, 1, 7, 0];

/// A cylinder over a polygon is as far from its limit as the polygon is.
#[test]
fn a_cylinder_is_as_far_away_as_its_curve() {
    for curve in [
        "b-spline:degree=3",
        "chaikin",
        "b-spline:degree=4",
        "four-point:w=1/16",
        "dual-four-point",
        "ternary-b-spline:degree=2",
        "ternary-three-point:a=7/27",
        "ternary-four-point-approximating",
        "newton:j=1,n=3",
    ] {
        let limit = Limit::new(&mask(curve)).expect("it converges");
        let curves = Distances::placed(&limit, Parametrisation::Natural).expect("it converges");
        let polygon = ControlPolygon::open(&HEIGHTS.map(Rational::from));
        let along = heights(7, HEIGHTS.len(), |_, j| Rational::from(HEIGHTS[j]));
        let across = heights(HEIGHTS.len(), 7, |i, _| Rational::from(HEIGHTS[i]));
        let products =
            [(along, format!("bicubic x {curve}")), (across, format!("{curve} x chaikin"))];
        for (net, product) in products {
            let scheme = scheme(&product.replace("bicubic", "b-spline:degree=3"));
            for tolerance in [r(1, 3), r(1, 40)] {
                let found = depth(&net, &scheme, &tolerance);
                let expected = curves
                    .depth_of_points(std::slice::from_ref(&polygon), &tolerance)
                    .expect("within the caps");
                assert_eq!(found.level, expected.upper, "{product} {tolerance}: {found:?}");
                assert_eq!(found.too_few, found.level.checked_sub(1), "{product} {tolerance}");
                let distance = curves
                    .of_polygon(&polygon, found.level, &r(1, 100_000))
                    .expect("within the caps")
                    .enclosure;
                let [lower, upper] = [distance.lower(), distance.upper()].map(nearest);
                assert!(found.distance[0] <= upper * (1.0 + 1e-9), "{product}: {found:?} {upper}");
                assert!(found.distance[1] >= lower * (1.0 - 1e-9), "{product}: {found:?} {lower}");
                let narrow = found.distance[1] <= 1.0011 * found.distance[0];
                assert!(narrow, "{product}: {found:?}");
            }
        }
    }
}

/// A net that is farthest from its surface among all with its spreads: it is as far away as it is said there,
/// and not farther than all are.
#[test]
fn extremal_nets() {
    const SCALE: i64 = 1000;
    let budget = Budget::new(100_000_000);
    for [first, second] in [
        ["b-spline:degree=3", "b-spline:degree=3"],
        ["chaikin", "b-spline:degree=3"],
        ["four-point:w=1/16", "chaikin"],
        ["ternary-three-point:a=7/27", "four-point:w=1/20"],
    ] {
        let limits = [first, second].map(|name| Limit::new(&mask(name)).expect("it converges"));
        let natural = Parametrisation::Natural;
        let surface = SurfaceDistances::placed(&limits[0], &limits[1], natural, &budget);
        let surface = surface.expect("it converges");
        let spreads = Spreads::one();
        for level in 0..2 {
            let (constant, _) =
                surface.constant(level, &r(1, 1_000), &spreads).expect("within the caps");
            let threshold = constant.lower() * r(99, 100);
            let Ok(Comparison::Exceeds(witness)) = surface.compare(level, &threshold, &spreads)
            else {
                panic!("{first} {second}: no net at level {level}");
            };
            let (rows, columns) = (witness.net.len(), witness.net[0].len());
            let net = heights(rows + 12, columns + 12, |i, j| {
                let at = |i: usize, count: usize| i.saturating_sub(6).min(count - 1);
                let height = witness.net[at(i, rows)][at(j, columns)];
                Rational::from(SCALE) * Rational::from(height) * &witness.unit
            });
            let faces = distances(&net, &scheme(&format!("{first} x {second}"))).faces(level);
            let [lower, upper] = [0, 1].map(|end| {
                faces.iter().map(|face| face[end]).fold(0.0, f64::max)
                    / nearest(&Rational::from(SCALE))
            });
            assert!(upper >= nearest(&witness.distance) * (1.0 - 1e-9), "{first} {level}: {upper}");
            assert!(lower <= nearest(constant.upper()) * (1.0 + 1e-9), "{first} {level}: {lower}");
            assert!(upper <= 1.06 * lower, "{first} {second} {level}: {lower} {upper}");
        }
    }
}

/// x²/2 + y²/2 is a sixth of both second differences, and an eighth for biquadratic splines, below its surface; a
/// quarter of that at each later level.
#[test]
fn a_third_of_the_second_differences() {
    let square = |i: usize| Rational::from(i * i) / Rational::from(2);
    let net = heights(9, 9, |i, j| square(i) + square(j));
    for (name, part) in [("bicubic", r(1, 6)), ("biquadratic", r(1, 8))] {
        let distances = distances(&net, &scheme(name));
        for level in 0..4 {
            let [lower, upper] = distances.faces(level)[27];
            let expected = nearest(&(&part * Rational::from(2) * r(1, 4).pow(level.cast_signed())));
            assert!((lower - expected).abs() < 1e-9, "{name}: {lower} {expected}");
            assert!(upper >= expected && upper < 1.06 * expected, "{name}: {upper} {expected}");
        }
    }
}
