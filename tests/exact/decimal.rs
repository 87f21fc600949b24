//! Decimals as printed.

use super::{our_ratio, ours, ratio_with_ties};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Signed as _;
use proptest::prelude::*;
use subcert::exact::{Decimal, Integer, Rational, RealCyclotomic, Rounding, parse_decimal};

proptest! {
    // |x|/10^e = Q + R/d by long division: the digits Q + step came from x as the
    // remainder says.
    #[test]
    fn roundings_are_what_the_remainder_says(
        x in ratio_with_ties(), exponent in -6_i32..4, step in -2_i64..4,
    ) {
        let ten = BigInt::from(10);
        let power = ten.pow(exponent.unsigned_abs());
        let (p, d) = if exponent < 0 { (x.numer() * &power, x.denom().clone()) } else { (x.numer().clone(), x.denom() * &power) };
        let (quotient, rest) = p.abs().div_rem(&d);
        let twice = &rest * 2_u32;
        let exact = rest == BigInt::ZERO;
        let expected = match step {
            0 if exact => Rounding::Exact,
            0 if twice <= d => Rounding::Nearest,
            0 => Rounding::Cut,
            1 if exact => Rounding::Neither,
            1 if twice >= d => Rounding::Nearest,
            // No value below half a unit is rounded to one unit.
            1 if quotient == BigInt::ZERO => Rounding::Neither,
            1 => Rounding::Up,
            _ => Rounding::Neither,
        };
        let mantissa = (quotient + step) * p.signum();
        if p != BigInt::ZERO && mantissa.signum() * p.signum() >= BigInt::ZERO {
            let decimal = Decimal::new(ours(&mantissa), exponent);
            prop_assert_eq!(decimal.rounding_of(&our_ratio(&x)), expected);
        }
    }

    // x lies in the interval exactly when the decimal is nearest to it.
    #[test]
    fn intervals_hold_what_rounds_to_the_decimal(
        mantissa in -50_i64..50, exponent in -3_i32..3, p in -4_000_i64..4_000, q in 1_i64..40,
    ) {
        let (decimal, x) = (Decimal::new(Integer::from(mantissa), exponent), Rational::new(p, q));
        let (low, high) = decimal.interval();
        let nearest = matches!(decimal.rounding_of(&x), Rounding::Exact | Rounding::Nearest);
        prop_assert_eq!(low <= x && x <= high, nearest);
        prop_assert_eq!(&high - &low, decimal.unit());
        prop_assert_eq!((low + high) / Rational::from(2), decimal.value());
    }
}

#[test]
fn hand_values() {
    use Rounding::{Cut, Exact, Nearest, Neither, Up};
    for (printed, p, q, expected) in [
        ("0.667", 2, 3, Nearest),
        ("0.666", 2, 3, Cut),
        ("-0.666", -2, 3, Cut),
        ("0.334", 1, 3, Up),
        ("-0.334", -1, 3, Up),
        ("0.2", 1, 4, Nearest),
        ("0.3", 1, 4, Nearest),
        ("-0.2", -1, 4, Nearest),
        ("-0.3", -1, 4, Nearest),
        ("0.25", 1, 4, Exact),
        ("0.250", 1, 4, Exact),
        ("0.24", 1, 4, Neither),
        ("0.26", 1, 4, Neither),
        ("-0.25", 1, 4, Neither),
        ("0.0", 7, 100, Cut),
        ("0.1", 2, 100, Neither),
        ("0.2", 12, 100, Up),
        ("0.1", 0, 1, Neither),
        ("7e-6", 695, 100_000_000, Nearest),
    ] {
        let decimal = parse_decimal(printed).unwrap();
        assert_eq!(decimal.rounding_of(&Rational::new(p, q)), expected, "{printed} of {p}/{q}");
    }
    // cos 72° = 0.309016994…, and its negative.
    let cosine = RealCyclotomic::cosine(&Rational::new(1, 5)).unwrap();
    for (printed, expected) in [
        ("0.3090", Nearest),
        ("0.309016", Cut),
        ("0.31", Nearest),
        ("0.3091", Up),
        ("0.308", Neither),
    ] {
        assert_eq!(parse_decimal(printed).unwrap().rounding_of(&cosine), expected, "{printed}");
        let negative = parse_decimal(&format!("-{printed}")).unwrap();
        assert_eq!(negative.rounding_of(&-&cosine), expected, "-{printed}");
    }
    let (low, high) = parse_decimal("-0.0310").unwrap().interval();
    assert_eq!((low, high), (Rational::new(-3105, 100_000), Rational::new(-3095, 100_000)));
}
