//! parse_rational and parse_decimal.

use super::theirs;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use subcert::exact::{
    IntegerPolynomial, MAX_DIGITS, MAX_EXPONENT, NumberError, Rational, RealAlgebraic, Rounding,
    parse_decimal, parse_printed, parse_rational,
};

fn unsigned(text: &str) -> Option<BigInt> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().expect("digits"))
}

/// Whether a minus stands first, and what follows the sign.
fn signed(text: &str) -> (bool, &str) {
    let first = text.chars().next().filter(|c| "+-−–".contains(*c));
    let rest = first.map_or(text, |c| text[c.len_utf8()..].trim_start());
    (first.is_some_and(|c| c != '+'), rest)
}

/// What a decimal means, by splitting the text.
fn naive_decimal(text: &str) -> Option<BigRational> {
    let (negative, text) = signed(text.trim());
    let times = |mark: &str| {
        let (mantissa, power) = text.split_once(mark)?;
        Some((mantissa.trim_end(), power.trim_start().strip_prefix("10^")?))
    };
    let power = ["×", "x", "*", "·"].into_iter().find_map(times);
    let power = power.or_else(|| text.split_once(['e', 'E']));
    let (mantissa, exponent) = power.map_or((text, None), |(m, e)| (m, Some(e)));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let ten = BigRational::from(BigInt::from(10));
    let digits = BigRational::from(unsigned(&format!("{whole}{fraction}"))?);
    let mut value = digits / ten.pow(i32::try_from(fraction.len()).ok()?);
    if let Some(exponent) = exponent {
        let (down, digits) = signed(exponent);
        let exponent = i32::try_from(unsigned(digits)?).ok()?;
        value *= ten.pow(if down { -exponent } else { exponent });
    }
    Some(if negative { -value } else { value })
}

fn naive_rational(text: &str) -> Option<BigRational> {
    // ½ is a fraction with a whole number before it, which may be missing.
    let (negative, rest) = signed(text.trim());
    let value = if let Some(whole) = rest.strip_suffix('½') {
        let whole = if whole.is_empty() { BigInt::ZERO } else { unsigned(whole)? };
        BigRational::new(whole * 2 + 1, BigInt::from(2))
    } else if let Some((numerator, denominator)) = rest.split_once(['/', '⁄']) {
        let (p, q) = (unsigned(numerator.trim_end())?, unsigned(denominator.trim_start())?);
        (q != BigInt::ZERO).then(|| BigRational::new(p, q))?
    } else {
        return naive_decimal(text);
    };
    Some(if negative { -value } else { value })
}

/// Texts of which a good part are numbers.
fn near_number() -> impl Strategy<Value = String> {
    let form = "[-−–+]? ?[0-9]{0,3}(\\.[0-9]{0,3})?((e|E| ?× ?10\\^|x10\\^|·10\\^| - )[-−+]?[0-9]{0,2})?( ?[/⁄] ?[-+]?[0-9]{0,2}|½)?";
    prop_oneof![form, "[-−+0-9./eE×x*^½ _]{0,10}", ".{0,6}"]
}

proptest! {
    #![proptest_config(crate::common::cases(2_000))]

    #[test]
    fn texts_are_read_or_refused_as_by_splitting(text in near_number()) {
        let rational = parse_rational(&text).ok().map(|value| theirs(&value));
        prop_assert_eq!(rational, naive_rational(&text));
        let decimal = parse_decimal(&text).ok().map(|value| theirs(&value.value()));
        prop_assert_eq!(decimal, naive_decimal(&text));
    }
}

#[test]
fn accepted() {
    for (text, p, q) in [
        ("2/4", 1_i64, 2_i64),
        ("-35/1296", -35, 1296),
        ("−35/1296", -35, 1296),
        ("0/5", 0, 1),
        ("007", 7, 1),
        ("-0", 0, 1),
        ("-0.0266", -266, 10_000),
        ("4.35e-5", 435, 10_000_000),
        ("4.35E+2", 435, 1),
        ("1.99×10^-10", 199, 1_000_000_000_000),
        ("1.99x10^−10", 199, 1_000_000_000_000),
        ("1.99*10^2", 199, 1),
        ("1.99 × 10^2", 199, 1),
        ("+1/2", 1, 2),
        ("1 / 8", 1, 8),
        ("1⁄8", 1, 8),
        (" .5 ", 1, 2),
        ("–5.", -5, 1),
        ("- 5", -5, 1),
        ("½", 1, 2),
        ("−⅛", -1, 8),
        ("2⅒", 21, 10),
    ] {
        assert_eq!(parse_rational(text), Ok(Rational::new(p, q)), "{text}");
    }
    // Printed zeros at the end are digits too.
    let (long, short) = (parse_decimal("0.0310").unwrap(), parse_decimal("0.031").unwrap());
    assert_eq!(long.value(), short.value());
    assert_eq!((long.exponent(), short.exponent()), (-4, -3));
    assert_eq!((long.significant_digits(), short.significant_digits()), (3, 2));
}

#[test]
fn refused_at_the_character_that_does_not_fit() {
    for (text, found, position) in [
        ("1/-2", '-', 3),
        ("+-1", '-', 2),
        ("1½/2", '/', 3),
        ("1 ½", '½', 3),
        ("½½", '½', 2),
        ("0,625", ',', 2),
        ("1_0/2", '_', 2),
        ("6.02 - 7", '-', 6),
        ("h1.69e-4", 'h', 1),
        ("1 5", '5', 3),
        ("1.99×10−10", '×', 5),
        ("--5", '-', 2),
        ("1/2/3", '/', 4),
        ("1.5/2", '/', 4),
        ("1e2.5", '.', 4),
        ("−5×2", '×', 3),
        ("1,5", ',', 2),
        ("٣", '٣', 1),
    ] {
        let error = parse_rational(text).unwrap_err();
        assert_eq!(error, NumberError::Unexpected { text: text.to_owned(), found, position });
    }
    for text in [".", "-", "−", "+ ", "1e", "1e-", "1/", "1.5×10^"] {
        let error = parse_rational(text).unwrap_err();
        assert_eq!(error, NumberError::Unfinished { text: text.to_owned() });
    }
    assert_eq!(parse_rational(""), Err(NumberError::Empty));
    assert_eq!(parse_rational(" "), Err(NumberError::Empty));
    assert_eq!(parse_rational("3/0"), Err(NumberError::ZeroDenominator { text: "3/0".to_owned() }));
}

#[test]
fn caps() {
    let long = "9".repeat(MAX_DIGITS);
    let value = parse_rational(&long).unwrap();
    assert_eq!(value.to_string(), long);
    let longer = long + "9";
    assert_eq!(parse_rational(&longer), Err(NumberError::TooLong { digits: MAX_DIGITS + 1 }));

    let largest = parse_decimal(&format!("1e{MAX_EXPONENT}")).unwrap();
    assert_eq!(largest.value(), Rational::power_of_ten(MAX_EXPONENT));
    let smallest = parse_decimal(&format!("1.5e-{MAX_EXPONENT}")).unwrap();
    assert_eq!(smallest.exponent(), -MAX_EXPONENT - 1);
    let huge = "9".repeat(9_000);
    for exponent in ["10001", "-10001", "2147483648", "9223372036854775808", huge.as_str()] {
        let text = format!("1e{exponent}");
        let error = parse_decimal(&text).unwrap_err();
        assert_eq!(error, NumberError::ExponentTooLarge { text });
    }
}

/// A fraction is exact: no value is rounded to it, and it has no last place.
#[test]
fn fractions_as_printed() {
    let third = parse_printed("-2/6").expect("a fraction");
    assert!(third.is_fraction() && third.unit().is_zero() && !third.is_one_unit());
    assert_eq!(third.interval(), (Rational::new(-1, 3), Rational::new(-1, 3)));
    assert_eq!(third.rounding_of(&Rational::new(-1, 3)), Rounding::Exact);
    assert_eq!(third.rounding_of(&Rational::new(-333, 1000)), Rounding::Neither);
    // √2 is near 7/5.
    let root = RealAlgebraic::roots_of(&IntegerPolynomial::from([-2, 0, 1]));
    let near = parse_printed("7/5").expect("a fraction");
    assert_eq!(near.rounding_of_algebraic(&root[1]), Rounding::Neither);
    assert!(parse_decimal("1/2").is_err() && parse_decimal("½").is_err());
}
