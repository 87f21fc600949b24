//! Limit values, and the functionals of differences.

use crate::common::{at, differences, gentle, int, largest, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::bound::{Constants, SoundBound};
use subcert::exact::{Integer, Rational};
use subcert::limit::{Functional, Limit};
use subcert::scheme::Mask;

pub fn limit(mask: &Mask) -> Limit {
    Limit::new(mask).unwrap_or_else(|error| panic!("{error}"))
}

/// A scheme that contracts in one level, and its limit: of two such schemes one with a
/// derivative.
pub fn convergent(arity: usize, width: usize) -> impl Strategy<Value = Limit> {
    let masks = prop_oneof![
        gentle(arity, width),
        gentle(arity, width - 1).prop_map(|derived| integral(&derived)),
    ];
    masks.prop_filter_map("T_1 ≥ 1", |mask| {
        let constants = SoundBound::curve(&Constants::new(mask.clone()), 1).expect("one level");
        (constants.constants()[1] < Rational::one()).then(|| limit(&mask))
    })
}

/// The scheme whose difference mask b is that of `derived` over n: a_{0,j} = Σ_β b_{β,j},
/// and a_{β+1,j} = a_{β,j} − b_{β,j} + b_{β,j−1}.
fn integral(derived: &Mask) -> Mask {
    let n = r(int(derived.arity()), 1);
    let rows = derived.rules().rows();
    let b = |beta: usize, j: Option<usize>| {
        j.and_then(|j| rows[beta].get(j)).map_or(Rational::zero(), |entry| entry / &n)
    };
    let width = derived.width() + 1;
    let first = |j| (0..rows.len()).map(|beta| b(beta, Some(j))).sum::<Rational>();
    let mut mask = vec![(0..width).map(first).collect::<Vec<Rational>>()];
    for beta in 0..rows.len() - 1 {
        let next = |j: usize| &mask[beta][j] - b(beta, Some(j)) + b(beta, j.checked_sub(1));
        mask.push((0..width).map(next).collect());
    }
    Mask::new(mask, derived.offset()).expect("its rules sum to 1")
}

/// The value of P^k(t) by refinement, and the spread of the level-k polygon.
fn refined(mask: &Mask, points: &[Rational], level: u32, t: &Rational) -> Rational {
    let fine = (0..level).fold(points.to_vec(), |points, _| refine(mask.rules(), &points));
    let place = t * Rational::from(mask.arity()).pow(level.cast_signed());
    let index = place.floor();
    let rest = place - Rational::from(index.clone());
    let index = index.to_i64().unwrap();
    at(&fine, index) * (Rational::one() - &rest) + at(&fine, index + 1) * rest
}

fn on(functional: &Functional, values: &[Rational]) -> Rational {
    functional.apply(|i| at(values, i).clone())
}

/// i/n^m, from −2 to 3, for n from 2 on.
pub fn parameter(arity: usize) -> impl Strategy<Value = Rational> {
    (0_u32..4).prop_flat_map(move |m| {
        let denominator = int(arity).pow(m);
        (-2 * denominator..3 * denominator).prop_map(move |i| r(i, denominator))
    })
}

proptest! {
    #![proptest_config(crate::common::cases(48))]

    #[test]
    fn limits_are_what_refinement_tends_to(
        (limit, t) in convergent(4, 5).prop_flat_map(|limit| {
            let arity = limit.mask().arity();
            (Just(limit), parameter(arity))
        }),
        points in polygon(2..6),
    ) {
        let mask = limit.mask();
        let value = on(&limit.at(&t).unwrap(), &points);
        let bound = SoundBound::curve(&Constants::new(mask.clone()), 1).unwrap();
        let spread = largest(&differences(&points));
        for (level, bound) in (0..5).zip(bound.levels(4).unwrap()) {
            let coarse = refined(mask, &points, level, &t);
            prop_assert_eq!(&on(&limit.polygon_at(level, &t).unwrap(), &points), &coarse);
            let error = on(&limit.error(level, &t).unwrap(), &differences(&points));
            prop_assert_eq!(&error, &(&value - coarse));
            prop_assert!(error.abs() <= bound * &spread);
        }
    }

    // P^∞ of x at t/n is P^∞ of the refined x at t.
    #[test]
    fn limits_do_not_change_under_refinement(
        (limit, t) in convergent(5, 6).prop_flat_map(|limit| {
            let arity = limit.mask().arity();
            (Just(limit), parameter(arity))
        }),
        whole in -50_i64..50,
    ) {
        let fine = limit.at(&t).unwrap();
        let finer = &t / Rational::from(limit.mask().arity());
        prop_assert_eq!(fine.after(limit.mask().rules()), limit.at(&finer).unwrap());
        prop_assert_eq!(fine.shifted(whole), limit.at(&(&t + r(whole, 1))).unwrap());
        prop_assert_eq!(fine.apply(|_| Rational::one()), Rational::one());
    }

    // With S_e = L^{ne} S, (Lx)_i = x_{i+1}, and SL = L^n S: S_e^k = L^{e(n+…+n^k)} S^k.
    #[test]
    fn offsets_shift_the_parameter(
        (limit, t) in convergent(4, 5).prop_flat_map(|limit| {
            let arity = limit.mask().arity();
            (Just(limit), parameter(arity))
        }),
        turns in -6_i64..7,
    ) {
        let n = int(limit.mask().arity());
        let e = turns * (n - 1);
        let moved = Limit::new(&limit.mask().with_offset(limit.mask().offset() + e)).unwrap();
        prop_assert_eq!(moved.at(&t).unwrap(), limit.at(&(&t + r(turns * n, 1))).unwrap());
        for level in 0..4 {
            let shift = (1..=level).map(|m| r(e * n.pow(m), n.pow(level))).sum::<Rational>();
            let there = limit.polygon_at(level, &(&t + shift)).unwrap();
            prop_assert_eq!(moved.polygon_at(level, &t).unwrap(), there);
        }
    }

    #[test]
    fn extremal_polygons_attain_the_norm(
        (limit, t) in convergent(4, 5).prop_flat_map(|limit| {
            let arity = limit.mask().arity();
            (Just(limit), parameter(arity))
        }),
        level in 0_u32..4,
    ) {
        let error = limit.error(level, &t).unwrap();
        let polygon = error.extremal_polygon();
        let steps = polygon.points.windows(2).all(|pair| (pair[1] - pair[0]).abs() == 1);
        prop_assert!(steps);
        // Beyond its ends the polygon goes on as it likes: here it stays.
        let x = |i: i64| {
            let last = int(polygon.points.len()) - 1;
            let at = usize::try_from((i - polygon.first).clamp(0, last)).unwrap();
            r(polygon.points[at], 1)
        };
        let distance = limit.at(&t).unwrap().apply(x) - limit.polygon_at(level, &t).unwrap().apply(x);
        prop_assert_eq!(distance, error.norm());
    }
}

/// The B-spline of this degree with the knots 0, …, degree + 1:
/// Σ_j (−1)^j C(degree+1, j) (x − j)₊^degree / degree!.
fn b_spline(degree: u32, x: &Rational) -> Rational {
    let factorial = (1..=degree).fold(Integer::one(), |product, i| product * Integer::from(i));
    let term = |j: u32| {
        let base = x - Rational::from(j);
        let sign = if j.is_multiple_of(2) { 1 } else { -1 };
        let power = if base.sign() < 0 { Rational::zero() } else { base.pow(degree.cast_signed()) };
        power * Rational::from(Integer::binomial(degree + 1, j)) * r(sign, 1)
    };
    (0..=degree + 1).map(term).sum::<Rational>() / Rational::from(factorial)
}

// The mask at index m is C(degree+1, m + shift)/2^degree, so that the knots start
// at −shift.
#[test]
fn b_splines() {
    for degree in 1..=5 {
        let limit = limit(&mask(&format!("b-spline:degree={degree}")));
        let shift = r(i64::from(degree) / 2 + 1, 1);
        for t in (-128..128).map(|i| r(i, 64)) {
            let value = limit.at(&t).unwrap();
            for i in -9..=9 {
                let expected = b_spline(degree, &(&t - r(i, 1) + &shift));
                assert_eq!(value.coefficient(i), expected, "degree {degree}, t = {t}, x_{i}");
            }
            assert!(value.support().is_some_and(|(first, last)| -9 <= first && last <= 9));
        }
    }
}

#[test]
fn interpolating_schemes_keep_their_points() {
    for scheme in [
        "b-spline:degree=1",
        "four-point",
        "four-point:w=1/10",
        "six-point:w=3/256",
        "ternary-four-point:mu=1/11",
        "ternary-three-point:a=1/4",
    ] {
        let limit = limit(&mask(scheme));
        for i in -3..4 {
            let point = Functional::new(i, [Rational::one()]);
            assert_eq!(limit.at(&r(i, 1)).unwrap(), point, "{scheme}");
        }
        let n = int(limit.mask().arity());
        for i in 0..n * n {
            let error = limit.error(2, &r(i, n * n)).unwrap();
            assert_eq!(error.support(), None, "{scheme}");
        }
    }
}
