//! σ, on data.

use crate::common::{affine, at, differences, int, largest, mask, polygon, r};
use proptest::prelude::*;
use subcert::bound::{Terms, best_offset, displacement};
use subcert::exact::Rational;
use subcert::scheme::Mask;

/// x'_α − ((1 − α/n) x_0 + (α/n) x_1), for i = 0.
fn displaced_at(mask: &Mask, alpha: usize, x: impl Fn(i64) -> Rational) -> Rational {
    let row = (mask.offset()..).zip(&mask.rules().rows()[alpha]);
    let refined: Rational = row.map(|(i, a)| a * x(i)).sum();
    let t = r(int(alpha), int(mask.arity()));
    refined - x(0) * (Rational::one() - &t) - x(1) * t
}

/// The same at every index of a closed polygon.
fn displaced(mask: &Mask, points: &[Rational]) -> Vec<Rational> {
    let at_index = |i: i64| {
        (0..mask.arity()).map(move |alpha| displaced_at(mask, alpha, |j| at(points, i + j).clone()))
    };
    (0..int(points.len())).flat_map(at_index).collect()
}

/// The coefficient of Δ_m in the displacement at index α, for m = −20, …, 20: what
/// a polygon does that rises by 1 between m and m + 1.
fn coefficients(mask: &Mask, alpha: usize) -> Vec<Rational> {
    (-20..=20).map(|m| displaced_at(mask, alpha, |i| r(i64::from(i > m), 1))).collect()
}

/// A closed polygon whose differences are these and then their opposites.
fn polygon_of(signs: &[i64]) -> Vec<Rational> {
    let there_and_back = signs.iter().copied().chain(signs.iter().map(|sign| -sign));
    there_and_back
        .scan(0, |x, step| {
            let here = *x;
            *x += step;
            Some(r(here, 1))
        })
        .collect()
}

proptest! {
    #![proptest_config(crate::common::cases(128))]

    #[test]
    fn displacements_are_sums_of_differences(mask in affine(5, 6)) {
        let rows: Vec<Vec<Rational>> = (0..mask.arity()).map(|alpha| coefficients(&mask, alpha)).collect();
        let each = rows.iter().map(|row| row.iter().map(Rational::abs).sum::<Rational>());
        prop_assert_eq!(displacement(&mask, Terms::Each), each.max().unwrap());
        let total = rows.iter().map(|row| row.iter().sum::<Rational>().abs());
        prop_assert_eq!(displacement(&mask, Terms::Total), total.max().unwrap());
    }

    // Attained by the polygon of ±1 that has the signs of the worst rule.
    #[test]
    fn the_bound_is_sharp(mask in affine(5, 6)) {
        let sigma = displacement(&mask, Terms::Each);
        let sum = |row: &Vec<Rational>| row.iter().map(Rational::abs).sum::<Rational>();
        let rows = (0..mask.arity()).map(|alpha| coefficients(&mask, alpha));
        let worst = rows.max_by_key(sum).unwrap();
        let signs: Vec<i64> = worst.iter().map(|a| if a.sign() < 0 { -1 } else { 1 }).collect();
        let points = polygon_of(&signs);
        prop_assert_eq!(largest(&differences(&points)), Rational::one());
        prop_assert_eq!(largest(&displaced(&mask, &points)), sigma);
    }

    #[test]
    fn the_least_offset_is_least(mask in affine(4, 6)) {
        let (best, sigma) = best_offset(&mask);
        let at = |offset| displacement(&mask.with_offset(offset), Terms::Each);
        prop_assert_eq!(at(best), sigma.clone());
        for offset in -25..=25_i64 {
            let other = at(offset);
            prop_assert!(other > sigma || (other == sigma && offset.abs() >= best.abs()));
        }
    }
}

proptest! {
    #[test]
    fn no_polygon_is_displaced_more(mask in affine(6, 8), points in polygon(1..12)) {
        let bound = displacement(&mask, Terms::Each) * largest(&differences(&points));
        prop_assert!(largest(&displaced(&mask, &points)) <= bound);
    }

    // At offset 0, as printed: ã_{α,0} = Σ_{h≥1} a_{α,h} − α/n, ã_{α,j} = Σ_{h>j} a_{α,h}.
    #[test]
    fn the_printed_formula(mask in affine(6, 8)) {
        let n = int(mask.arity());
        let norms = (0..).zip(mask.rules().rows()).map(|(alpha, row)| {
            let tail = |j: usize| row[j + 1..].iter().sum::<Rational>();
            let first = (tail(0) - r(alpha, n)).abs();
            first + (1..row.len()).map(|j| tail(j).abs()).sum::<Rational>()
        });
        prop_assert_eq!(displacement(&mask.with_offset(0), Terms::Each), norms.max().unwrap());
    }
}

#[test]
fn values_by_hand() {
    for (scheme, offset, sigma) in [
        // x'_0 − x_0 = Δ/4, x'_1 − (x_0 + x_1)/2 = Δ/4.
        ("chaikin", 0, r(1, 4)),
        // −w x_{−1} + (1/2 + w)(x_0 + x_1) − w x_2 − (x_0 + x_1)/2 = w(Δ_{−1} − Δ_1).
        ("four-point", -1, r(1, 8)),
        ("six-point:w=0", -2, r(1, 8)),
        ("b-spline:degree=1", 0, r(0, 1)),
        ("b-spline:degree=3", -1, r(1, 4)),
        // 3/25 on one side, 7/25 − 4/5 on the other.
        ("quinary-three-point", -1, r(16, 25)),
    ] {
        let mask = mask(scheme);
        assert_eq!(mask.offset(), offset);
        assert_eq!(displacement(&mask, Terms::Each), sigma, "{scheme}");
    }
    // Of two equally good offsets, the one nearest to 0.
    let copies = Mask::new(vec![vec![r(1, 1)], vec![r(1, 1)]], 5).unwrap();
    assert_eq!(best_offset(&copies), (0, r(1, 2)));
}
