//! How far a level is from a later one.

use crate::common::{affine, at, int, r, refine};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::limit::{greatest_change, greatest_step};
use subcert::scheme::Mask;

/// Half as many points as the closed polygons have that stand for open ones.
const HALF: i64 = 30;

/// Σ_m |C_m| for the coefficient C_m of every Δ_m in (P^l − P^k)(i/n^l): its value where the
/// points up to m are 0 and the others 1, until far away they are 0 again.
fn greatest_change_of_steps(mask: &Mask, k: u32, l: u32) -> Rational {
    let arity = int(mask.arity());
    let count = arity.pow(l);
    let mut sums = vec![Rational::zero(); usize::try_from(count).unwrap()];
    for m in -HALF / 2..HALF / 2 {
        let point = |i: i64| (i - m - 1).rem_euclid(2 * HALF) < HALF;
        let first = (0..2 * HALF).map(|i| r(i64::from(point(i)), 1));
        let mut levels: Vec<Vec<Rational>> = vec![first.collect()];
        for level in 0..l as usize {
            let next = refine(mask.rules(), &levels[level]);
            levels.push(next);
        }
        let per = arity.pow(l - k);
        for (i, sum) in (0..).zip(&mut sums) {
            let (start, part) = (i64::div_euclid(i, per), r(i % per, per));
            let old = &levels[k as usize];
            let old = at(old, start) * (Rational::one() - &part) + at(old, start + 1) * part;
            *sum += &(at(&levels[l as usize], i) - &old).abs();
        }
    }
    sums.into_iter().max().unwrap()
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn changes_are_those_of_all_steps(mask in affine(3, 3), k in 0_u32..3, more in 0_u32..3) {
        let l = (k + more).min(2);
        let k = k.min(l);
        let greatest = greatest_change(&mask, k, l).unwrap();
        prop_assert_eq!(&greatest, &greatest_change_of_steps(&mask, k, l));
        if l == k + 1 {
            prop_assert_eq!(greatest, greatest_step(&mask, k).unwrap().value);
        }
    }
}

#[test]
fn no_level_is_before_itself() {
    let mask = crate::common::mask("chaikin");
    assert_eq!(greatest_change(&mask, 3, 3).unwrap(), Rational::zero());
    assert!(greatest_change(&mask, 3, 2).is_err());
    assert!(greatest_change(&mask, 0, 15).is_err());
}
