//! Hexadecimal text of f64.

use proptest::prelude::*;
use subcert::float::{HexadecimalError, hexadecimal, parse_hexadecimal};

/// As glibc and CPython print them.
const KNOWN: [(f64, &str); 11] = [
    (0.1, "0x1.999999999999ap-4"),
    (1.0, "0x1p+0"),
    (-0.1875, "-0x1.8p-3"),
    (std::f64::consts::PI, "0x1.921fb54442d18p+1"),
    (f64::MAX, "0x1.fffffffffffffp+1023"),
    (f64::MIN_POSITIVE, "0x1p-1022"),
    (f64::from_bits(1), "0x0.0000000000001p-1022"),
    (0.0, "0x0p+0"),
    (-0.0, "-0x0p+0"),
    (f64::INFINITY, "inf"),
    (f64::NEG_INFINITY, "-inf"),
];

#[test]
fn known_texts() {
    for (value, text) in KNOWN {
        assert_eq!(hexadecimal(value), text);
        assert_eq!(parse_hexadecimal(text).unwrap().to_bits(), value.to_bits());
    }
    assert_eq!(hexadecimal(f64::NAN), "nan");
    assert!(parse_hexadecimal("nan").unwrap().is_nan());
}

#[test]
fn other_spellings() {
    for text in ["0x3p-4", "0x.3p0", "0x00.30", "+0X0.3P+0", "0x30p-8", "0x1.8p-3"] {
        assert_eq!(parse_hexadecimal(text), Ok(0.1875), "{text}");
    }
    // More digits than fit are rounded, ties to even.
    assert_eq!(parse_hexadecimal("0x1.00000000000008p0"), Ok(1.0));
    assert_eq!(parse_hexadecimal("0x1.00000000000018p0"), Ok(1.0 + 2.0 * f64::EPSILON));
    assert_eq!(parse_hexadecimal("0x1.000000000000080000001p0"), Ok(1.0 + f64::EPSILON));
    assert_eq!(parse_hexadecimal("0x1p1024"), Ok(f64::INFINITY));
    assert_eq!(parse_hexadecimal("0x1p-20000"), Ok(0.0));
}

#[test]
fn refusals() {
    for text in
        ["", "0x", "0x.", "0xp1", "1.8p3", "0x1.8p", "0x1p+", "0x1p1.5", "0x1 ", "0x1.2.3", "Inf"]
    {
        let refused = parse_hexadecimal(text);
        assert!(matches!(refused, Err(HexadecimalError::Form(_))), "{text}: {refused:?}");
    }
    for text in ["--0x1", "+-0x1", "0x-1"] {
        assert!(parse_hexadecimal(text).is_err(), "{text}");
    }
    for text in [&format!("0x{}", "1".repeat(3_000)), "0x1p99999", "0x1p-99999999999999999999"] {
        assert_eq!(parse_hexadecimal(text), Err(HexadecimalError::TooLong));
    }
}

proptest! {
    #[test]
    fn round_trip(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        let read = parse_hexadecimal(&hexadecimal(value)).expect("it reads back");
        prop_assert!(read.to_bits() == bits || value.is_nan() && read.is_nan());
    }
}
