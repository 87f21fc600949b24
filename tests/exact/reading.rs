//! parse_rational and parse_decimal.

use super::theirs;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use subcert::exact::{
    MAX_DIGITS, MAX_EXPONENT, NumberError, Rational, parse_decimal, parse_rational,
};

fn unsigned(text: &str) -> Option<BigInt> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().expect("digits"))
}

fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix('-').or_else(|| text.strip_prefix('−')) {
        Some(rest) => (true, rest),
        None => (false, text),
    }
}

/// What a decimal means, by splitting the text.
fn naive_decimal(text: &str) -> Option<BigRational> {
    let (negative, text) = signed(text);
    let marks = ["e", "E", "×10^", "x10^", "*10^"];
    let split = marks.iter().find_map(|mark| text.split_once(mark));
    let (mantissa, exponent) = split.map_or((text, None), |(m, e)| (m, Some(e)));
    let (whole, fraction) =
        mantissa.split_once('.').map_or((mantissa, None), |(w, f)| (w, Some(f)));
    let mut value = BigRational::from(unsigned(whole)?);
    let ten = BigRational::from(BigInt::from(10));
    if let Some(fraction) = fraction {
        let places = i32::try_from(fraction.len()).ok()?;
        value += BigRational::from(unsigned(fraction)?) / ten.pow(places);
    }
    if let Some(exponent) = exponent {
        let (down, digits) = signed(exponent);
        let digits = if down { digits } else { digits.strip_prefix('+').unwrap_or(digits) };
        let exponent = i32::try_from(unsigned(digits)?).ok()?;
        value *= ten.pow(if down { -exponent } else { exponent });
    }
    Some(if negative { -value } else { value })
}

fn naive_rational(text: &str) -> Option<BigRational> {
    let Some((numerator, denominator)) = text.split_once('/') else { return naive_decimal(text) };
    let (negative, numerator) = signed(numerator);
    let (p, q) = (unsigned(numerator)?, unsigned(denominator)?);
    (q != BigInt::ZERO).then(|| BigRational::new(if negative { -p } else { p }, q))
}

/// Texts of which a good part are numbers.
fn near_number() -> impl Strategy<Value = String> {
    let form = "[-−+]?[0-9]{0,3}(\\.[0-9]{0,3})?((e|E|×10\\^|x10\\^|\\*10\\^| - )[-−+]?[0-9]{0,2})?(/[-+]?[0-9]{0,2})?";
    prop_oneof![form, "[-−+0-9./eE×x*^ _]{0,10}", ".{0,6}"]
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
        ("+1/2", '+', 1),
        ("+1", '+', 1),
        ("1_0/2", '_', 2),
        ("6.02 - 7", ' ', 5),
        ("h1.69e-4", 'h', 1),
        (".5", '.', 1),
        (" 5", ' ', 1),
        ("5 ", ' ', 2),
        ("--5", '-', 2),
        ("1/2/3", '/', 4),
        ("1.5/2", '.', 2),
        ("1e2.5", '.', 4),
        ("−5×2", '×', 3),
        ("1,5", ',', 2),
        ("٣", '٣', 1),
    ] {
        let error = parse_rational(text).unwrap_err();
        assert_eq!(error, NumberError::Unexpected { text: text.to_owned(), found, position });
    }
    for text in ["5.", "-", "−", "1e", "1e-", "1/", "1.5×10^"] {
        let error = parse_rational(text).unwrap_err();
        assert_eq!(error, NumberError::Unfinished { text: text.to_owned() });
    }
    assert_eq!(parse_rational(""), Err(NumberError::Empty));
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
