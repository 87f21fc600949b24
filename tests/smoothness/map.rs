//! Maps of two parameters against single points, and against ranges of one parameter.

use proptest::prelude::*;
use std::sync::LazyLock;
use std::sync::atomic::AtomicUsize;
use subcert::bound::polynomial_rules;
use subcert::exact::{BivariatePolynomial, Polynomial, Rational};
use subcert::scheme::{Rules, parse_in_parameters, parse_parametric, parse_scheme};
use subcert::smoothness::{Certain, MapBox, SmoothMap, Smoothness, smooth_map, smooth_range};

const FILE: &str = "examples/primal.toml";

fn rules() -> Rules<BivariatePolynomial> {
    let mask = parse_in_parameters(FILE, &["a", "b"]).expect("a mask");
    let polynomial = |entry: &Polynomial| entry.in_variables(["a", "b"]).expect("a polynomial");
    mask.rules().map(polynomial)
}

fn r(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

/// The map for C^1 on −1/4 ≤ a ≤ 1/4, −1/4 ≤ b ≤ 1/2.
static MAP: LazyLock<SmoothMap> = LazyLock::new(|| {
    let region = [[r(-1, 4), r(1, 4)], [r(-1, 4), r(1, 2)]];
    smooth_map(&rules(), 1, &region, 300, &AtomicUsize::new(0)).expect("sum rules of order 2")
});

fn holds(found: &MapBox, point: [&Rational; 2]) -> bool {
    found.sides.iter().zip(point).all(|([low, high], x)| low <= x && x <= high)
}

fn certain(point: [&Rational; 2]) -> Vec<&'static Certain> {
    let here = MAP.boxes.iter().filter(|found| holds(found, point));
    here.map(|found| &found.certain).collect()
}

#[test]
fn the_boxes_fill_the_region() {
    let area = |found: &MapBox| {
        found.sides.iter().fold(Rational::one(), |area, [low, high]| area * (high - low))
    };
    assert_eq!(MAP.boxes.iter().map(area).sum::<Rational>(), r(3, 8));
    let [inside, outside, open] = MAP.shares();
    assert_eq!(&inside + &outside + &open, Rational::one());
    // Both sides are found, and most is decided.
    assert!(inside > r(1, 3) && outside > r(1, 4) && open < r(3, 10), "{inside} {outside} {open}");
    assert_eq!(MAP.looked_at, 300);
}

/// The symbol (1 − w + wz²)(1 + z)²/2·(1 − v + vz) has an end coefficient above 1 in most of each box. Its parts have
/// a common zero everywhere but at w = 0, which lies in both boxes; what is said must not depend on the middle of a box.
#[test]
fn what_is_outside_does_not_depend_on_the_box() {
    let mask = parse_in_parameters("tests/smoothness/product.toml", &["w", "v"]).expect("a mask");
    let polynomial = |entry: &Polynomial| entry.in_variables(["w", "v"]).expect("a polynomial");
    let rules = mask.rules().map(polynomial);
    for high in [r(1, 8), r(1, 7)] {
        let region = [[r(-1, 8), high], [r(5, 4), r(7, 4)]];
        let map = smooth_map(&rules, 0, &region, 100, &AtomicUsize::new(0)).expect("sum rules");
        let [_, outside, _] = map.shares();
        assert!(outside > r(9, 10), "{outside}");
    }
}

#[test]
fn the_cubic_b_spline_is_inside_and_a_divergent_scheme_is_not() {
    assert!(certain([&r(0, 1), &r(1, 8)]).iter().all(|c| **c == Certain::Inside));
    assert!(certain([&r(1, 5), &r(2, 5)]).iter().all(|c| matches!(c, Certain::Outside(_))));
}

/// On the line a = −w, b = 2w the map is about the four-point scheme.
#[test]
fn the_map_agrees_with_the_range_on_a_line() {
    let mask = parse_parametric("four-point", "w").expect("a mask");
    let range = smooth_range(&polynomial_rules(mask.rules(), "w").expect("linear"), 1, 2);
    let range = range.expect("short rules");
    let (mut inside, mut outside) = (0, 0);
    for i in -50..=50 {
        let w = r(i, 200);
        for certain in certain([&-&w, &(&w * r(2, 1))]) {
            match certain {
                Certain::Inside => {
                    inside += 1;
                    assert!(!range.outside.contains(&w), "w = {w}");
                }
                Certain::Outside(_) => {
                    outside += 1;
                    assert!(!range.inside.contains(&w), "w = {w}");
                }
                Certain::Open => {}
            }
        }
    }
    assert!(inside > 10 && outside > 10, "{inside} {outside}");
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    /// What the map says of a box is what holds at its points.
    #[test]
    fn points_agree_with_their_boxes(i in -499_i64..500, j in -499_i64..500) {
        let (a, b) = (r(i, 2000), r(1, 8) + r(3 * j, 4000));
        let scheme = parse_scheme(&format!("{FILE}:a={a},b={b}")).expect("a scheme");
        let smoothness = Smoothness::of(scheme.masks()[0]).expect("short rules");
        for certain in certain([&a, &b]) {
            match certain {
                Certain::Inside => prop_assert!(smoothness.continuity_fails.is_none_or(|m| m > 1)),
                Certain::Outside(_) => prop_assert!(smoothness.continuity.is_none_or(|m| m < 1)),
                Certain::Open => {}
            }
        }
    }

    /// Bernstein coefficients enclose all values, and are the values at the corners.
    #[test]
    fn bernstein_coefficients_enclose(
        c in prop::collection::vec(prop::collection::vec(-9_i64..10, 1..4), 1..4),
        corner in (-5_i64..5, -5_i64..5),
        size in (1_i64..6, 1_i64..6),
        at in (0_i64..=8, 0_i64..=8),
    ) {
        let (v, w) = (Polynomial::variable("v"), Polynomial::variable("w"));
        let power = |x: &Polynomial, k: usize| (0..k).fold(Polynomial::constant(Rational::one()), |p, _| &p * x);
        let mut p = Polynomial::default();
        for (i, row) in c.iter().enumerate() {
            for (j, &x) in row.iter().enumerate() {
                p = &p + &(&(&power(&v, i) * &power(&w, j)) * &Polynomial::constant(Rational::from(x)));
            }
        }
        let p = p.in_variables(["v", "w"]).expect("a polynomial");
        let side = |low: i64, size: i64| [r(low, 2), r(low + size, 2)];
        let (x, y) = (side(corner.0, size.0), side(corner.1, size.1));
        let found = p.bernstein([&x, &y], [3, 4]);
        let point = |s: &[Rational; 2], k: i64| &s[0] + (&s[1] - &s[0]) * r(k, 8);
        let value = p.value_at([&point(&x, at.0), &point(&y, at.1)]);
        let all = || found.iter().flatten();
        prop_assert!(all().min().expect("some") <= &value && &value <= all().max().expect("some"));
        prop_assert_eq!(&found[0][0], &p.value_at([&x[0], &y[0]]));
        prop_assert_eq!(&found[3][4], &p.value_at([&x[1], &y[1]]));
        prop_assert_eq!(&found[3][0], &p.value_at([&x[1], &y[0]]));
    }
}
