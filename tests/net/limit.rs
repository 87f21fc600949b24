//! Limit points against B-splines by the recursion of Cox and de Boor.

use super::{CLOSED, bumpy, scheme};
use crate::common::{int, r};
use subcert::exact::Rational;
use subcert::net::{net_limits, net_of_limits, refine_net};

/// The B-spline of a degree with the knots 0, 1, …, degree + 1, at t.
pub fn spline(degree: usize, t: &Rational) -> Rational {
    if degree == 0 {
        let inside = *t >= Rational::zero() && *t < Rational::one();
        return Rational::from(i64::from(inside));
    }
    let d = Rational::from(degree);
    let left = t / &d * spline(degree - 1, t);
    let right = (Rational::from(degree + 1) - t) / d * spline(degree - 1, &(t - Rational::one()));
    left + right
}

/// The point of level k at i, of the net with the centred splines of a degree.
#[test]
fn limit_points_are_values_of_splines() {
    for degree in 1..6 {
        let scheme = scheme(&format!("b-spline:degree={degree}"));
        let net = bumpy(7, 8, CLOSED[0]);
        for level in 0..2 {
            let refined = refine_net(&net, &scheme, level).expect("a net");
            let found = net_limits(&refined, &scheme).expect("limits");
            // Point i of the open net of level 1 has an index of its own; the parameter of its
            // coordinates for the net of the indices tells it.
            let plane = super::heights(7, 8, |_, _| Rational::zero());
            let places = refine_net(&plane, &scheme, level).expect("a net");
            let mut count = 0;
            for (limit, place) in found.iter().zip(places.points()) {
                let Some(limit) = limit else { continue };
                count += 1;
                let half = r(int(degree + 1), 2);
                let mut sum = [0, 0, 0].map(Rational::from);
                for (k, point) in net.points().iter().enumerate() {
                    let u = &place[1] - Rational::from(k / 8) + &half;
                    let v = &place[0] - Rational::from(k % 8) + &half;
                    let weight = spline(degree, &u) * spline(degree, &v);
                    for (sum, x) in sum.iter_mut().zip(point) {
                        *sum += &(&weight * x);
                    }
                }
                assert_eq!(*limit, sum, "degree {degree} level {level}");
            }
            assert!(count >= 4, "degree {degree}: {count}");
        }
    }
}

/// The limit of an interpolating scheme passes through its points.
#[test]
fn interpolating_schemes_keep_their_points() {
    let net = bumpy(6, 6, CLOSED[3]);
    for name in ["four-point:w=1/16", "ternary-three-point:a=7/27", "quinary-three-point"] {
        assert_eq!(
            net_of_limits(&net, net_limits(&net, &scheme(name)).expect("limits")).expect("a net"),
            net,
            "{name}"
        );
    }
}
