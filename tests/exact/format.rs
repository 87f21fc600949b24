//! Printing decimals, against long division by hand.

use super::{our_ratio, ratio_with_ties};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{Signed as _, Zero as _};
use proptest::prelude::*;
use subcert::exact::format::{fixed, scientific, short};
use subcert::exact::{Rational, parse_decimal};

/// Digit after digit, then half to even on the digits.
fn naive_fixed(value: &BigRational, places: u32) -> String {
    let (whole, mut rest) = value.numer().abs().div_rem(value.denom());
    let mut digits: Vec<u8> = whole.to_string().bytes().map(|byte| byte - b'0').collect();
    for _ in 0..places {
        let (digit, next) = (rest * 10_u32).div_rem(value.denom());
        digits.push(u8::try_from(digit).expect("a digit"));
        rest = next;
    }
    let twice = rest * 2_u32;
    let odd = digits.last().is_some_and(|digit| digit % 2 == 1);
    if twice > *value.denom() || (twice == *value.denom() && odd) {
        let mut at = digits.len();
        loop {
            if at == 0 {
                digits.insert(0, 1);
                break;
            }
            at -= 1;
            digits[at] += 1;
            if digits[at] < 10 {
                break;
            }
            digits[at] = 0;
        }
    }
    let sign = if value.is_negative() && digits.iter().any(|&digit| digit > 0) { "-" } else { "" };
    let mut text: String = digits.iter().map(ToString::to_string).collect();
    if places > 0 {
        text.insert(text.len() - places as usize, '.');
    }
    format!("{sign}{text}")
}

/// The value shifted until one digit stands before the point, then fixed.
fn naive_scientific(value: &BigRational, digits: u32) -> (String, i32) {
    let ten = BigRational::from(BigInt::from(10));
    let (mut shifted, mut exponent) = (value.clone(), 0);
    while !shifted.is_zero() && shifted.abs() >= ten {
        shifted /= &ten;
        exponent += 1;
    }
    while !shifted.is_zero() && shifted.abs() < BigRational::from(BigInt::from(1)) {
        shifted *= &ten;
        exponent -= 1;
    }
    let text = naive_fixed(&shifted, digits - 1);
    if text.trim_start_matches('-').starts_with("10") {
        return (naive_fixed(&(shifted / ten), digits - 1), exponent + 1);
    }
    (text, exponent)
}

proptest! {
    #[test]
    fn decimals_agree_with_long_division(
        value in ratio_with_ties(), places in 0_u32..30, digits in 1_u32..25,
    ) {
        let ours = our_ratio(&value);
        prop_assert_eq!(fixed(&ours, places), naive_fixed(&value, places));
        let (text, exponent) = naive_scientific(&value, digits);
        prop_assert_eq!(scientific(&ours, digits), format!("{text}e{exponent}"));
    }

    // The short form has the digits of the scientific one, less the zeros at its
    // end, and stands plain exactly where it says so.
    #[test]
    fn short_forms_have_the_scientific_digits(value in ratio_with_ties(), digits in 1_u32..12) {
        let ours = our_ratio(&value);
        let text = short(&ours, digits);
        let (_, exponent) = naive_scientific(&value, digits);
        let wanted = parse_decimal(&scientific(&ours, digits)).unwrap().value();
        prop_assert_eq!(parse_decimal(&text).unwrap().value(), wanted);
        let plain = value.is_zero() || (-5..=i32::try_from(digits.max(6)).unwrap()).contains(&exponent);
        prop_assert_eq!(!text.contains('e'), plain);
        let number = text.split('e').next().unwrap();
        prop_assert!(!number.contains('.') || !number.ends_with(['0', '.']), "{}", text);
    }

    // What is printed is the nearest decimal of its length.
    #[test]
    fn printed_decimals_read_back_within_half_a_unit(value in ratio_with_ties(), digits in 1_u32..25) {
        let (low, high) = parse_decimal(&scientific(&our_ratio(&value), digits)).unwrap().interval();
        let value = our_ratio(&value);
        prop_assert!(value.is_zero() || (low <= value && value <= high));
    }
}

#[test]
fn hand_values() {
    let r = |p: i64, q: i64| Rational::new(p, q);
    for (value, places, text) in [
        (r(1, 8), 2, "0.12"),
        (r(3, 8), 2, "0.38"),
        (r(-1, 8), 2, "-0.12"),
        (r(5, 2), 0, "2"),
        (r(7, 2), 0, "4"),
        (r(-1, 1000), 2, "0.00"),
        (r(999, 1000), 2, "1.00"),
        (r(1995, 100), 1, "20.0"),
        (r(0, 1), 3, "0.000"),
    ] {
        assert_eq!(fixed(&value, places), text);
    }
    assert_eq!(scientific(&r(0, 1), 3), "0.00e0");
    assert_eq!(scientific(&r(-99_995, 100_000), 4), "-1.000e0");
    assert_eq!(scientific(&r(125, 1), 2), "1.2e2");
    assert_eq!(scientific(&r(1, 3), 1), "3e-1");
    assert_eq!(short(&r(123_456_789, 1), 3), "1.23e8");
    assert_eq!(short(&r(1_234_567, 1), 3), "1230000");
    assert_eq!(short(&r(1, 100_000), 6), "0.00001");
    assert_eq!(short(&r(1, 1_000_000), 6), "1e-6");
}
