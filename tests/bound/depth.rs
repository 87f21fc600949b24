//! Depths for a printed bound.

use crate::common::r;
use proptest::prelude::*;
use subcert::bound::{DepthError, MAX_DEPTH, Rounded, least_level, log_level, log_level_algebraic};
use subcert::exact::{Rational, RealCyclotomic};

/// A ratio in (0, 1) and a positive number.
fn ratio() -> impl Strategy<Value = Rational> {
    (1_i64..40, 1_i64..20).prop_map(|(p, more)| r(p, p + more))
}

fn positive() -> impl Strategy<Value = Rational> {
    (1_i64..500, 1_i64..1_000_000).prop_map(|(p, q)| r(p, q))
}

proptest! {
    #[test]
    fn least_levels_are_found_by_counting(
        factor in positive(), ratio in ratio(), tolerance in positive(),
    ) {
        let mut bound = factor.clone();
        let mut level = 0;
        while bound > tolerance {
            bound *= &ratio;
            level += 1;
        }
        prop_assert_eq!(least_level(&factor, &ratio, &tolerance), Ok(level));
    }

    // At ratio^k exactly, and a hair to either side.
    #[test]
    fn ties_are_decided_exactly(factor in positive(), ratio in ratio(), k in 0_u32..200) {
        let tie = &factor * ratio.pow(k.cast_signed());
        prop_assert_eq!(least_level(&factor, &ratio, &tie), Ok(k));
        let hair = r(1, 1_000_000_000_000);
        prop_assert_eq!(least_level(&factor, &ratio, &(&tie * (r(1, 1) - &hair))), Ok(k + 1));
        let x = ratio.pow(k.cast_signed());
        for rounded in [Rounded::Up, Rounded::Down, Rounded::Nearest] {
            prop_assert_eq!(log_level(&ratio, &x, rounded), Ok(k));
        }
        prop_assert_eq!(log_level(&ratio, &(&x * (r(1, 1) - &hair)), Rounded::Up), Ok(k + 1));
        prop_assert_eq!(log_level(&ratio, &(&x * (r(1, 1) - &hair)), Rounded::Down), Ok(k));
        prop_assert_eq!(log_level(&ratio, &(&x * (r(1, 1) + &hair)), Rounded::Up), Ok(k));
        prop_assert_eq!(log_level(&ratio, &(&x * (r(1, 1) + &hair)), Rounded::Down), Ok(k.saturating_sub(1)));
        // ratio^(2k+1) = (ratio²)^(k+1/2): half way, to the greater.
        let square = ratio.pow(2);
        let half = ratio.pow((2 * k + 1).cast_signed());
        prop_assert_eq!(log_level(&square, &half, Rounded::Nearest), Ok(k + 1));
        prop_assert_eq!(log_level(&square, &(&half * (r(1, 1) + &hair)), Rounded::Nearest), Ok(k));
        prop_assert_eq!(log_level(&square, &(&half * (r(1, 1) - &hair)), Rounded::Nearest), Ok(k + 1));
    }

    // ratio^k ≥ x ≥ ratio^(k+1) for k rounded down; the three are at most 1 apart.
    #[test]
    fn roundings_of_one_logarithm(ratio in ratio(), x in positive()) {
        let [up, near, down] = [Rounded::Up, Rounded::Nearest, Rounded::Down]
            .map(|rounded| log_level(&ratio, &x, rounded).unwrap());
        prop_assert!(down <= near && near <= up && up <= down + 1);
        let power = |k: u32| ratio.pow(k.cast_signed());
        prop_assert!(power(up) <= x && (up == 0 || power(up - 1) > x));
        if x < Rational::one() {
            prop_assert!(power(down) >= x && power(down + 1) < x);
        } else {
            prop_assert_eq!((down, up), (0, 0));
        }
    }
}

// ln(10⁻⁶)/ln 0.68 = 35.82…, ln(10⁻³)/ln(1/2) = 9.97…, ln(0.3)/ln 0.742 = 4.03….
#[test]
fn logarithms_known_from_elsewhere() {
    for (ratio, x, down, near, up) in [
        (r(17, 25), r(1, 1_000_000), 35, 36, 36),
        (r(1, 2), r(1, 1000), 9, 10, 10),
        (r(371, 500), r(3, 10), 4, 4, 5),
        (r(1, 2), r(3, 1), 0, 0, 0),
    ] {
        assert_eq!(log_level(&ratio, &x, Rounded::Down), Ok(down));
        assert_eq!(log_level(&ratio, &x, Rounded::Nearest), Ok(near));
        assert_eq!(log_level(&ratio, &x, Rounded::Up), Ok(up));
    }
}

#[test]
fn deep_levels() {
    // ln(1/2000)/ln 0.9999 = 76,005.2…: beyond 2^16, below the cap.
    assert_eq!(least_level(&r(1, 1), &r(9999, 10_000), &r(1, 2000)), Ok(76_006));
    let just_in = r(1, 2).pow(i32::try_from(MAX_DEPTH).unwrap());
    assert_eq!(least_level(&r(1, 1), &r(1, 2), &just_in), Ok(MAX_DEPTH));
    let beyond = Err(DepthError::TooDeep);
    assert_eq!(least_level(&r(1, 1), &r(1, 2), &(just_in / r(2, 1))), beyond);
    assert_eq!(least_level(&r(1, 1), &r(999_999, 1_000_000), &r(1, 2)), beyond);
    // Ratios so long that few powers of them can be computed.
    let long = Rational::one() - r(1, 10).pow(9_000);
    assert_eq!(least_level(&r(1, 1), &long, &r(1, 2)), beyond);
}

#[test]
fn what_has_no_depth() {
    let not_positive =
        |result: Result<u32, DepthError>| matches!(result, Err(DepthError::NotPositive { .. }));
    let one = r(1, 1);
    assert!(not_positive(least_level(&one, &r(1, 2), &r(0, 1))));
    assert!(not_positive(least_level(&one, &r(1, 2), &r(-1, 2))));
    assert!(not_positive(least_level(&r(-1, 2), &r(1, 2), &one)));
    for ratio in [r(1, 1), r(3, 2), r(-1, 2)] {
        assert!(matches!(least_level(&one, &ratio, &r(1, 2)), Err(DepthError::NoContraction(_))));
        // Where the factor meets the tolerance by itself, the ratio is not asked.
        assert_eq!(least_level(&one, &ratio, &one), Ok(0));
    }
    assert_eq!(least_level(&one, &r(0, 1), &r(1, 2)), Ok(1));
    assert_eq!(least_level(&r(0, 1), &r(1, 2), &r(1, 2)), Ok(0));
    for rounded in [Rounded::Up, Rounded::Down, Rounded::Nearest] {
        assert!(not_positive(log_level(&r(1, 2), &r(0, 1), rounded)));
        assert!(not_positive(log_level(&r(0, 1), &r(1, 2), rounded)));
        assert!(not_positive(log_level(&r(-1, 2), &r(2, 1), rounded)));
        let error = log_level(&r(5, 4), &r(2, 1), rounded).unwrap_err();
        assert_eq!(error, DepthError::NoContraction("1.25".to_owned()));
    }
}

/// A number of Q(2cos 2π/n) in (0, 1): |cos|, made smaller.
fn algebraic_ratio() -> impl Strategy<Value = RealCyclotomic> {
    (1_i64..12, 5_i64..13, 1_i64..10).prop_map(|(j, n, q)| {
        let cosine = RealCyclotomic::cosine(&r(j, n)).unwrap();
        let half = RealCyclotomic::from(r(1, 2));
        &(&cosine.abs() * &RealCyclotomic::from(r(q, q + 1)))
            + &(&half * &RealCyclotomic::from(r(1, q + 1)))
    })
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    // By counting, at an equality, and a hair to either side of one.
    #[test]
    fn levels_of_algebraic_ratios(ratio in algebraic_ratio(), k in 0_u32..12, x in positive()) {
        let one = RealCyclotomic::from(1);
        let power = |k: u32| (0..k).fold(one.clone(), |product, _| &product * &ratio);
        let x = RealCyclotomic::from(x.clone());
        if let Some(up) = (0..100).find(|&k| power(k) <= x) {
            prop_assert_eq!(log_level_algebraic(&ratio, &x, Rounded::Up), Ok(up));
        }
        let hair = RealCyclotomic::from(r(1, 1_000_000_000_000));
        let tie = power(k);
        let (below, above) = (&tie * &(&one - &hair), &tie * &(&one + &hair));
        for rounded in [Rounded::Up, Rounded::Nearest, Rounded::Down] {
            prop_assert_eq!(log_level_algebraic(&ratio, &tie, rounded), Ok(k));
        }
        prop_assert_eq!(log_level_algebraic(&ratio, &below, Rounded::Up), Ok(k + 1));
        prop_assert_eq!(log_level_algebraic(&ratio, &below, Rounded::Down), Ok(k));
        prop_assert_eq!(log_level_algebraic(&ratio, &above, Rounded::Up), Ok(k));
        // Half way between two levels of the squared ratio, to the greater.
        let (square, half) = (&ratio * &ratio, power(2 * k + 1));
        prop_assert_eq!(log_level_algebraic(&square, &half, Rounded::Nearest), Ok(k + 1));
        let more = &half * &(&one + &hair);
        prop_assert_eq!(log_level_algebraic(&square, &more, Rounded::Nearest), Ok(k));
    }
}

#[test]
fn algebraic_ratios_out_of_range() {
    let cosine = |j, n| RealCyclotomic::cosine(&r(j, n)).unwrap();
    let level = |ratio, x| log_level_algebraic(&ratio, &x, Rounded::Up);
    let half = || RealCyclotomic::from(r(1, 2));
    assert!(matches!(
        level(cosine(2, 5), half()),
        Err(DepthError::NotPositive { what: "the ratio", .. })
    ));
    assert!(matches!(level(half(), cosine(2, 5)), Err(DepthError::NotPositive { .. })));
    let golden = &cosine(1, 10) + &cosine(1, 10);
    assert!(matches!(level(golden, half()), Err(DepthError::NoContraction(_))));
    // 1 − 10^-60, times a hair less than 1: beyond every cap, and quickly so.
    let tiny = RealCyclotomic::from(Rational::power_of_ten(-60));
    let near = &RealCyclotomic::from(1) - &(&tiny * &cosine(1, 5));
    assert_eq!(level(near, half()), Err(DepthError::TooDeep));
}
