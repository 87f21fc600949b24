//! Exact to f64 and back.

use crate::float::strategy::{two, wide};
use proptest::prelude::*;
use subcert::exact::{Rational, parse_decimal};
use subcert::float::{exact, lower, nearest, shortest, ulp, ulps_between, upper};

fn finite(value: f64) -> Rational {
    exact(value).expect("finite")
}

/// Same bits: tells −0 from 0, and compares without a tolerance.
#[track_caller]
fn same(found: f64, expected: f64) {
    assert_eq!(found.to_bits(), expected.to_bits(), "{found:?} is not {expected:?}");
}

#[test]
fn facts_of_the_format() {
    same(nearest(&Rational::new(1, 10)), 0.1);
    same(nearest(&Rational::zero()), 0.0);
    assert_eq!(finite(0.1), Rational::new(3_602_879_701_896_397_i64, 36_028_797_018_963_968_i64));
    assert_eq!(finite(-0.0), Rational::zero());
    assert_eq!(finite(f64::MAX), two(1024) - two(971));
    assert_eq!(finite(f64::MIN_POSITIVE), two(-1022));
    assert_eq!(finite(f64::from_bits(1)), two(-1074));
    assert_eq!(exact(f64::INFINITY), None);
    assert_eq!(exact(f64::NAN), None);
}

#[test]
fn ties_go_to_the_even_neighbour() {
    let above_two_53 = |excess: i64| Rational::from((1_i64 << 53) + excess);
    same(nearest(&above_two_53(1)), 9_007_199_254_740_992.0);
    same(nearest(&above_two_53(3)), 9_007_199_254_740_996.0);
    same(nearest(&-above_two_53(3)), -9_007_199_254_740_996.0);
    // 2^54 − 1 carries into the next power of two.
    same(nearest(&Rational::from((1_i64 << 54) - 1)), 18_014_398_509_481_984.0);
    // Anything beyond the tie is not a tie.
    same(nearest(&(above_two_53(1) + two(-500))), 9_007_199_254_740_994.0);
    same(nearest(&(above_two_53(3) - two(-500))), 9_007_199_254_740_994.0);
}

#[test]
fn subnormals_and_zero() {
    let half_least = two(-1075);
    same(nearest(&half_least), 0.0);
    same(nearest(&-&half_least), -0.0);
    same(nearest(&(&half_least + two(-3000))), f64::from_bits(1));
    same(nearest(&(&half_least * Rational::from(3))), f64::from_bits(2));
    same(nearest(&(&half_least * Rational::from(5))), f64::from_bits(2));
    // Halfway between the greatest subnormal and the least normal number.
    same(nearest(&(two(-1022) - &half_least)), f64::MIN_POSITIVE);
    same(nearest(&(two(-1022) - &half_least - two(-3000))), f64::MIN_POSITIVE.next_down());
    same(nearest(&two(-100_000)), 0.0);
    same(nearest(&Rational::power_of_ten(-400)), 0.0);
}

#[test]
fn overflow() {
    let tie = two(1024) - two(970);
    same(nearest(&tie), f64::INFINITY);
    same(nearest(&-&tie), f64::NEG_INFINITY);
    same(nearest(&(&tie - two(-50))), f64::MAX);
    same(nearest(&two(100_000)), f64::INFINITY);
    same(upper(&two(1024)), f64::INFINITY);
    same(lower(&two(1024)), f64::MAX);
    same(upper(&-two(1024)), f64::MIN);
    same(lower(&-two(1024)), f64::NEG_INFINITY);
    // Nearest to the greatest f64, but above it.
    same(upper(&(tie - two(-50))), f64::INFINITY);
}

#[test]
fn units_in_the_last_place() {
    assert_eq!(ulp(1.0), Some(two(-52)));
    assert_eq!(ulp(1.0_f64.next_down()), Some(two(-53)));
    assert_eq!(ulp(f64::MAX), Some(two(971)));
    assert_eq!(ulp(f64::INFINITY), None);
    assert_eq!(ulps_between(0.1, &Rational::new(1, 10)), Some(Rational::new(2, 5)));
    assert_eq!(ulps_between(0.0, &Rational::zero()), Some(Rational::zero()));
    assert_eq!(ulps_between(-0.5, &Rational::new(1, 2)), Some(two(53)));
    // Beyond the greatest f64 the unit is that of the greatest f64.
    assert_eq!(ulps_between(f64::MAX, &two(1024)), Some(Rational::one()));
}

/// Any finite f64, by its bits.
fn any_finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |value| value.is_finite())
}

proptest! {
    #[test]
    fn as_rust_reads_decimals(digits in "[0-9]{1,40}", exponent in -380..320_i32) {
        let text = format!("{digits}e{exponent}");
        let value = parse_decimal(&text).expect("a decimal").value();
        same(nearest(&value), text.parse().expect("a decimal"));
    }

    #[test]
    #[expect(clippy::cast_precision_loss, reason = "the rounding is the point")]
    fn as_rust_casts_and_divides(p in any::<i128>(), shift in 0..127_u32, q in 1..1_i64 << 53) {
        let p = p >> shift;
        same(nearest(&Rational::from(p)), p as f64);
        let small = i64::try_from(p >> 75).expect("53 bits");
        let expected = small as f64 / q as f64;
        same(nearest(&Rational::new(small, q)), expected);
    }

    #[test]
    fn back_and_forth(value in any_finite()) {
        // An exact 0 has no sign: −0 + 0 = 0.
        same(nearest(&finite(value)), value + 0.0);
        same(shortest(value).parse().expect("it reads back"), value);
    }

    #[test]
    fn nothing_is_nearer(value in wide()) {
        let near = nearest(&value);
        let off = |candidate: f64| exact(candidate).map(|found| (found - &value).abs());
        if let Some(distance) = off(near) {
            for other in [near.next_up(), near.next_down()].into_iter().filter_map(off) {
                prop_assert!(distance <= other);
            }
            let ulps = ulps_between(near, &value).expect("finite");
            prop_assert!(ulps <= Rational::new(1, 2));
        }
    }

    #[test]
    fn upper_and_lower_enclose_tightly(value in wide()) {
        let (low, high) = (lower(&value), upper(&value));
        prop_assert!(exact(low).is_none_or(|low| low <= value));
        prop_assert!(exact(high).is_none_or(|high| high >= value));
        let near = nearest(&value);
        // Without the sign of 0.
        let is = |x: f64, y: f64| (x + 0.0).to_bits() == (y + 0.0).to_bits();
        prop_assert!(is(near, low) || is(near, high));
        prop_assert!(is(high, low) || is(high, low.next_up()));
    }

    #[test]
    fn the_unit_is_the_step_upwards(value in any_finite()) {
        let size = value.abs();
        if let Some(next) = exact(size.next_up()) {
            prop_assert_eq!(ulp(value), Some(next - finite(size)));
        }
    }
}
