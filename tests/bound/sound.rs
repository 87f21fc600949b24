//! The sound bound, against what subdivision does.

use super::norm::row;
use super::surface::{Grid, bilinear, distance, grid, spread};
use crate::common::{affine, differences, gentle, int, largest, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::bound::{Constants, DepthError, Order, SoundBound, power_norm};
use subcert::exact::Rational;
use subcert::scheme::{Mask, Rules};

/// U_0, …, U_last as the documentation states them, with fractions.
fn naive_upper(bound: &SoundBound, last: usize) -> Vec<Rational> {
    let exact = bound.constants();
    let mut upper = exact.to_vec();
    for m in exact.len()..=last {
        let splits = (1..exact.len()).map(|j| &exact[j] * &upper[m - j]);
        upper.push(splits.min().expect("there is a block"));
    }
    upper
}

/// σ(U_k + … + U_{k+c−1})/(1 − C_c).
fn naive_block(bound: &SoundBound, k: usize, c: usize) -> Rational {
    let upper = naive_upper(bound, k + c);
    let sum: Rational = upper[k..k + c].iter().sum();
    bound.factor() * sum / (Rational::one() - &bound.constants()[c])
}

fn naive_levels(bound: &SoundBound, last: usize) -> Option<Vec<Rational>> {
    let exact = bound.constants();
    let contracting = (1..exact.len()).filter(|&c| exact[c] < Rational::one());
    let contracting: Vec<usize> = contracting.collect();
    let upper = naive_upper(bound, last + exact.len());
    let level = |k: usize| {
        let block = |&c: &usize| {
            let sum: Rational = upper[k..k + c].iter().sum();
            bound.factor() * sum / (Rational::one() - &exact[c])
        };
        contracting.iter().map(block).min()
    };
    (0..=last).map(level).collect()
}

/// ‖P^{m+1} − P^m‖ for m = 0, 1, …: at the points of the finer polygon.
fn steps(mask: &Mask, points: &[Rational], count: usize) -> Vec<Rational> {
    let n = mask.arity();
    let linear = mask_of_lines(n);
    let step = |points: &mut Vec<Rational>, _| {
        let refined = refine(mask.rules(), points);
        let kept = refine(linear.rules(), points);
        let moved = refined.iter().zip(&kept).map(|(x, y)| x - y).collect::<Vec<_>>();
        *points = refined;
        Some(largest(&moved))
    };
    (0..count).scan(points.to_vec(), step).collect()
}

/// Linear interpolation at the parameters i + α/n.
fn mask_of_lines(n: usize) -> Mask {
    let n = int(n);
    let rows = (0..n).map(|alpha| vec![r(n - alpha, n), r(alpha, n)]).collect();
    Mask::new(rows, 0).unwrap()
}

/// Whether the later steps of every level stay below its bound.
fn holds(bound: &SoundBound, steps: &[Rational], spread: &Rational) -> bool {
    let Some(levels) = bound.levels(u32::try_from(steps.len()).unwrap()) else { return true };
    levels.iter().enumerate().all(|(k, bound)| {
        steps.get(k..).unwrap_or_default().iter().sum::<Rational>() <= bound * spread
    })
}

const SCHEMES: [&str; 9] = [
    "chaikin",
    "four-point",
    "six-point:w=39/2000",
    "newton:j=1,n=3",
    "newton:j=2,n=2",
    "quinary-three-point",
    "ternary-four-point:mu=1/11",
    "quaternary-four-point:mu=1/2",
    "b-spline:degree=4",
];

fn curve(mask: &Mask, blocks: u32) -> SoundBound {
    SoundBound::curve(&Constants::new(mask.clone()), blocks).unwrap()
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    #[test]
    fn bounds_hold_for_named_curves(points in polygon(2..6), blocks in 1_u32..4) {
        for scheme in SCHEMES {
            let mask = mask(scheme);
            let bound = curve(&mask, blocks);
            prop_assert!(bound.levels(0).is_some(), "{scheme}");
            let count = 3 + usize::from(mask.arity() < 4);
            let spread = largest(&differences(&points));
            prop_assert!(holds(&bound, &steps(&mask, &points, count), &spread), "{scheme}");
        }
    }

    #[test]
    fn bounds_hold_for_random_curves(mask in gentle(4, 5), points in polygon(2..6), blocks in 1_u32..4) {
        let spread = largest(&differences(&points));
        prop_assert!(holds(&curve(&mask, blocks), &steps(&mask, &points, 3), &spread));
    }

    #[test]
    fn bounds_hold_for_surfaces(first in gentle(3, 4), second in gentle(3, 4), grid in grid(), blocks in 1_u32..3) {
        let pair = [&first, &second].map(|mask| Constants::new(mask.clone()));
        let bound = SoundBound::surface(&pair[0], &pair[1], blocks).unwrap();
        prop_assert!(holds(&bound, &surface_steps(&first, &second, grid.clone(), 2), &spread(&grid)));
    }
}

/// The greatest refined value over grids of ±1: of c levels of `first` along the
/// rows' index and `second` along the columns', at a row and a column that attain
/// their own norms.
fn attained(first: &Rules, second: &Rules, c: u32) -> Rational {
    let norms = [first, second].map(|rules| power_norm(rules, c, Order::Adjoint).unwrap());
    let rows = [row(first, c, norms[0].class.clone()), row(second, c, norms[1].class.clone())];
    let [rows, columns] = rows.map(|row| {
        let (low, high) = (*row.keys().next().unwrap(), *row.keys().last().unwrap());
        let count = high - low + 1;
        let entry = move |i: i64| row.get(&(low + (i - low).rem_euclid(count))).cloned();
        (0..count)
            .map(|i| r(if entry(i).is_some_and(|x| x.sign() < 0) { -1 } else { 1 }, 1))
            .collect::<Vec<_>>()
    });
    let signs: Grid = rows.iter().map(|x| columns.iter().map(|y| x * y).collect()).collect();
    let refined = (0..c).fold(signs, |grid, _| super::surface::refine(first, second, &grid));
    refined.into_iter().flatten().max().unwrap()
}

proptest! {
    #![proptest_config(crate::common::cases(8))]

    // C_c is what differences along one direction can grow by: D along it, S along
    // the other, for the worse of the two directions.
    #[test]
    fn constants_of_surfaces_are_attained(first in affine(3, 3), second in affine(3, 3)) {
        let pair = [&first, &second].map(|mask| Constants::new(mask.clone()));
        let bound = SoundBound::surface(&pair[0], &pair[1], 2).unwrap();
        prop_assert_eq!(&bound.constants()[0], &Rational::one());
        for c in 1..=2 {
            let along = attained(&first.difference(), second.rules(), c);
            let across = attained(first.rules(), &second.difference(), c);
            prop_assert_eq!(&bound.constants()[c as usize], &along.max(across));
        }
    }
}

fn surface_steps(first: &Mask, second: &Mask, mut grid: Grid, count: usize) -> Vec<Rational> {
    let mut steps = Vec::new();
    for _ in 0..count {
        let refined = super::surface::refine(first.rules(), second.rules(), &grid);
        steps.push(distance(&refined, &bilinear(&grid, first.arity(), second.arity())));
        grid = refined;
    }
    steps
}

#[test]
fn bounds_hold_for_named_surfaces() {
    let grid: Grid =
        [[0, 3, 1], [4, -2, 5], [1, 1, -6]].map(|row| row.map(Rational::from).to_vec()).to_vec();
    for (first, second) in
        [("chaikin", "chaikin"), ("four-point", "newton:j=1,n=3"), ("newton:j=1,n=2", "four-point")]
    {
        let (first, second) = (mask(first), mask(second));
        let pair = [&first, &second].map(|mask| Constants::new(mask.clone()));
        let bound = SoundBound::surface(&pair[0], &pair[1], 3).unwrap();
        assert!(bound.levels(0).is_some());
        assert!(holds(&bound, &surface_steps(&first, &second, grid.clone(), 3), &spread(&grid)));
    }
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    #[test]
    fn levels_are_the_documented_formula(mask in gentle(3, 4), blocks in 1_u32..5, last in 0_u32..12) {
        let bound = curve(&mask, blocks);
        prop_assert_eq!(bound.levels(last), naive_levels(&bound, last as usize));
    }

    #[test]
    fn depths_are_the_least_of_the_levels(
        mask in gentle(3, 4), blocks in 1_u32..5, spread in 1_i64..9, digits in 0_u32..4,
    ) {
        let bound = curve(&mask, blocks);
        let (spread, tolerance) = (r(spread, 3), r(1, 10_i64.pow(digits)));
        // Slow contractions have a test of their own.
        prop_assume!(bound.constants().iter().any(|c| *c <= r(1, 2)) || bound.levels(0).is_none());
        let levels = naive_levels(&bound, 100);
        match bound.depth(&spread, &tolerance) {
            Ok(depth) => {
                let levels = levels.unwrap();
                let meets = |level: &Rational| level * &spread <= tolerance;
                prop_assert_eq!(levels.iter().position(meets), Some(depth.level as usize));
                let block = naive_block(&bound, depth.level as usize, depth.block as usize);
                prop_assert_eq!(block, levels[depth.level as usize].clone());
            }
            Err(error) => {
                prop_assert!(matches!(error, DepthError::NoContraction(_)));
                prop_assert_eq!((bound.levels(0), levels), (None, None));
            }
        }
    }
}

// σ = 1/4 and T_c = 2^−c: 1/4·(2^−k + …)/(1 − 2^−c) = 2^−k/2, whatever c.
#[test]
fn chaikin_by_hand() {
    for blocks in 1..5 {
        let bound = curve(&mask("chaikin"), blocks);
        assert_eq!(bound.factor(), &r(1, 4));
        let halves: Vec<Rational> = (0..20).map(|k| r(1, 2).pow(k + 1)).collect();
        assert_eq!(bound.levels(19), Some(halves));
        // 2^−k/2 · 3 ≤ 3/2^11, a tie.
        let depth = bound.depth(&r(3, 1), &r(3, 2048)).unwrap();
        assert_eq!((depth.level, depth.block), (10, 1));
        assert_eq!(bound.depth(&r(3, 1), &r(3, 2049)).unwrap().level, 11);
    }
}

#[test]
fn what_has_no_bound() {
    // Each point three times as far: T_1 = 3 and so on.
    let wild = Mask::new(vec![vec![r(1, 1), r(0, 1)], vec![r(-2, 1), r(3, 1)]], 0).unwrap();
    let bound = curve(&wild, 3);
    assert_eq!(bound.levels(5), None);
    assert!(matches!(bound.depth(&r(1, 1), &r(1, 2)), Err(DepthError::NoContraction(_))));
    let empty = curve(&mask("chaikin"), 0);
    assert_eq!(empty.levels(5), None);
    assert_eq!(empty.depth(&r(1, 1), &r(1, 2)), Err(DepthError::NoContraction("1".to_owned())));
    let chaikin = curve(&mask("chaikin"), 1);
    for (spread, tolerance) in [(0, 1), (1, 0), (-1, 1), (1, -1)] {
        let error = chaikin.depth(&r(spread, 1), &r(tolerance, 1)).unwrap_err();
        assert!(matches!(error, DepthError::NotPositive { .. }));
    }
    // Linear interpolation moves nothing.
    assert_eq!(curve(&mask_of_lines(3), 2).depth(&r(9, 1), &r(1, 9)).unwrap().level, 0);
}

// Ratios near 1: many levels of long numbers, still decided; and given up in time.
#[test]
fn slow_contractions() {
    let slow = |p: i64, q: i64| {
        Mask::new(vec![vec![r(p, q), r(q - p, q)], vec![r(0, 1), r(1, 1)]], 0).unwrap()
    };
    let bound = curve(&slow(99, 100), 4);
    assert_eq!(bound.constants()[1], r(99, 100));
    let depth = bound.depth(&r(1, 1), &r(1, 10_000_000_000)).unwrap();
    let level = |k: i32| bound.factor() * r(99, 100).pow(k) * r(100, 1);
    let k = i32::try_from(depth.level).unwrap();
    assert!(level(k) <= r(1, 10_000_000_000) && level(k - 1) > r(1, 10_000_000_000));
    let hopeless = curve(&slow(999_999_999, 1_000_000_000), 1);
    assert_eq!(hopeless.depth(&r(1, 1), &r(1, 10)), Err(DepthError::TooDeep));
}
