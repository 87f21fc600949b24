//! Regions of two parameters, and the best parameters, against norms and exponents at single points.

use super::laws::power_norm;
use proptest::prelude::*;
use std::sync::atomic::AtomicUsize;
use subcert::exact::{BivariatePolynomial, Rational};
use subcert::scheme::{Mask, Rules, parse_in_parameters, parse_scheme};
use subcert::smoothness::{Smoothness, Symbol, best_exponent, polygon_contraction};

const FAMILIES: [(&str, usize); 3] = [
    ("[a, 1 - b, 1 - a, b]", 0),
    ("(1+z)^3*(a + b*z + (1-2*a-2*b)*z^2 + b*z^3 + a*z^4)/4", 1),
    ("(1+z+z^2)^2*(a + b*z + (1-a-b-a*b)*z^2 + a*b*z^3)/3", 0),
];

fn rules(text: &str) -> Rules<BivariatePolynomial> {
    let mask = parse_in_parameters(text, &["a", "b"]).expect("a mask");
    mask.rules().map(|c| c.in_variables(["a", "b"]).expect("a polynomial"))
}

/// n^m times the norm of so many levels of the differences of order m + 1 at a point, as a power.
fn norm_at(
    rules: &Rules<BivariatePolynomial>,
    m: usize,
    levels: u32,
    point: &[Rational; 2],
) -> Rational {
    let values = rules.map(|c| c.value_at([&point[0], &point[1]]));
    let mask = Mask::new(values.rows().to_vec(), 0).expect("affine");
    let n = Rational::from(mask.arity());
    let scale = n.pow(i32::try_from(m).expect("small") * i32::try_from(levels).expect("small"));
    power_norm(&Symbol::of(&mask), m + 1, levels) * scale
}

fn combined(corners: &[[Rational; 2]; 3], weights: [u32; 3]) -> [Rational; 2] {
    let total = Rational::from(weights.iter().sum::<u32>());
    [0, 1].map(|i| {
        let terms = corners.iter().zip(weights).map(|(corner, w)| &corner[i] * Rational::from(w));
        terms.sum::<Rational>() / &total
    })
}

proptest! {
    #[test]
    fn norms_are_below_1_where_a_region_is_shown(
        family in 0_usize..3,
        numbers in proptest::collection::vec(-6_i64..=10, 6),
        weights in proptest::collection::vec(proptest::array::uniform3(0_u32..5), 12),
    ) {
        let (text, m) = FAMILIES[family];
        let rules = rules(text);
        let corner = |i: usize| [numbers[2 * i], numbers[2 * i + 1]].map(|p| Rational::new(p, 16));
        let mut corners = [corner(0), corner(1), corner(2)];
        let side = |a: &[Rational; 2], b: &[Rational; 2]| [&b[0] - &a[0], &b[1] - &a[1]];
        let area = |c: &[[Rational; 2]; 3]| {
            let ([x, y], [z, w]) = (side(&c[0], &c[1]), side(&c[0], &c[2]));
            x * w - y * z
        };
        if area(&corners).sign() < 0 {
            corners.swap(1, 2);
        }
        prop_assume!(area(&corners).sign() > 0);
        let least = (0..3).min_by_key(|&i| corners[i].clone()).expect("three");
        corners.rotate_left(least);
        // All points of the triangle, its sides with it.
        let found = polygon_contraction(&rules, m, &corners, &|_| true, 2).expect("sum rules");
        let at_corners = corners.iter().map(|corner| norm_at(&rules, m, 1, corner));
        let below = at_corners.max().expect("three") < Rational::one();
        match found {
            Ok(proof) => {
                for weights in weights.into_iter().filter(|weights| weights.iter().sum::<u32>() > 0) {
                    let point = combined(&corners, weights);
                    let norm = norm_at(&rules, m, proof.levels, &point);
                    prop_assert!(norm < Rational::one(), "{norm} at {point:?}");
                }
            }
            // The norm of one level is convex where coefficients are linear.
            Err(_) => prop_assert!(!below || family == 2, "{corners:?}"),
        }
    }
}

#[test]
fn sides_belong_to_a_region_only_where_the_norm_is_below_1() {
    let rules = rules(FAMILIES[0].0);
    let corners = [[0, 0], [1, 0], [0, 1]].map(|corner| corner.map(Rational::from));
    let inner = |[x, y]: [&Rational; 2]| x.sign() > 0 && y.sign() > 0 && x + y < Rational::one();
    assert!(polygon_contraction(&rules, 0, &corners, &inner, 3).expect("sum rules").is_ok());
    // For x = 0 < y < 1 the norm is max(1 − y, y), below 1 as well, and so for y = 0; for x + y = 1 it is 1.
    let lower = |[x, y]: [&Rational; 2]| x + y < Rational::one() && x + y > Rational::zero();
    assert!(polygon_contraction(&rules, 0, &corners, &lower, 3).expect("sum rules").is_ok());
    // But the corner (1, 0) does not belong to it.
    let upper = |[x, y]: [&Rational; 2]| x.sign() > 0 && y.sign() > 0 || x + y == Rational::one();
    assert!(polygon_contraction(&rules, 0, &corners, &upper, 3).expect("sum rules").is_err());
}

#[test]
fn the_four_point_scheme_is_best_at_one_sixteenth() {
    let mask = parse_in_parameters("four-point", &["w"]).expect("a mask");
    let rules = mask.rules().map(|c| c.in_variables(["w", ""]).expect("a polynomial"));
    let zero = Rational::zero();
    let region = [[zero.clone(), Rational::new(1, 8)], [zero.clone(), zero]];
    let best = best_exponent(&rules, &region, 2_000, &AtomicUsize::new(0)).expect("sum rules");
    assert_eq!(best.order, 2);
    let [low, high] = &best.places[0];
    assert!(
        *low <= Rational::new(1, 16)
            && Rational::new(1, 16) <= *high
            && high - low < Rational::new(1, 1_000)
    );
    // The exponent 2 is that of a radius of 1/4.
    assert!(best.least <= Rational::new(1, 4) && Rational::new(1, 4) <= best.greatest);
    assert!(&best.greatest - &best.least < Rational::new(1, 1_000));
    for i in 0..=8 {
        let scheme = parse_scheme(&format!("four-point:w={i}/64")).expect("a scheme");
        let exponent = Smoothness::of(scheme.masks()[0]).expect("short").hoelder.expect("limits");
        assert!(exponent.lower <= Rational::from(2), "{i}");
    }
}

#[test]
fn of_two_parameters_the_best_are_those_of_a_spline() {
    // For a = 0, b = 1/4 this is the quintic B-spline; the order of sum rules that hold everywhere is 3.
    let rules = rules(FAMILIES[1].0);
    let [low, high] = [-1, 1].map(|p| Rational::new(p, 2));
    let region = [[low.clone(), high.clone()], [low, high]];
    let best = best_exponent(&rules, &region, 600, &AtomicUsize::new(0)).expect("sum rules");
    assert_eq!(best.order, 3);
    // No radius is less than 2^−3, which is that of the spline.
    assert_eq!(best.least, Rational::new(1, 8));
    assert!(best.greatest < Rational::new(1, 7), "{}", best.greatest);
    let at = |i: usize| best.places[i][0] <= best.at[i] && best.at[i] <= best.places[i][1];
    assert!(at(0) && at(1));
}

/// The norm is max(|a| + |b|, |1 − a − b|), 1 on both sides of the corners (1, 0) and (0, 1). Without cuts along a = 0 and b = 0 no
/// triangle there shows it.
#[test]
fn a_whole_region_is_shown_where_coefficients_change_their_sign_at_corners() {
    let rules = rules(FAMILIES[0].0);
    let half = Rational::new(1, 2);
    let (one, zero) = (Rational::one(), Rational::zero());
    let corners = [
        [-&half, half.clone()],
        [half.clone(), -&half],
        [one.clone(), zero.clone()],
        [zero.clone(), one.clone()],
    ];
    let inside = |[x, y]: [&Rational; 2]| x.abs() + y.abs() < one && (x + y).sign() > 0;
    let found = polygon_contraction(&rules, 0, &corners, &inside, 1).expect("sum rules");
    assert_eq!(found.expect("a proof").levels, 1);
    let wider = |[x, y]: [&Rational; 2]| x.abs() + y.abs() <= one && (x + y).sign() > 0;
    assert!(polygon_contraction(&rules, 0, &corners, &wider, 1).expect("sum rules").is_err());
}
