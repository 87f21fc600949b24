//! SCHEME as written on the command line.

use crate::common::{mask, r};
use proptest::prelude::*;
use subcert::scheme::{Mask, ReferenceError, Scheme, SchemeError, parse_scheme};

#[test]
fn parameters_are_formulas() {
    let six = mask("six-point:w=3/256");
    for text in [
        "six-point:w=3/2^8",
        "six-point:w = max(3/256, 0)",
        " six-point:w=0.01171875 ",
        "six-point:w=3/256,",
    ] {
        assert_eq!(mask(text), six, "{text}");
    }
    assert_eq!(mask("newton:n=3,j=1"), mask("newton:j=2-1,n=binomial(3, 1)"));
    assert_eq!(mask("four-point"), mask("four-point:w=1/16"));
    assert_eq!(mask("chaikin:"), mask("chaikin"));
}

#[test]
fn tensor_products() {
    let (chaikin, four) = (mask("chaikin"), mask("four-point:w=1/20"));
    let scheme = parse_scheme("chaikin x four-point:w=1/20").unwrap();
    assert_eq!(scheme, Scheme::Tensor(chaikin.clone(), four.clone()));
    assert_eq!(scheme.masks(), [&chaikin, &four]);
    assert!(Mask::try_from(scheme).is_err());
    assert_eq!(Mask::try_from(parse_scheme("chaikin").unwrap()), Ok(chaikin));
}

#[test]
fn what_is_not_a_scheme() {
    for (text, reason) in [
        ("", "the name is missing"),
        ("chaikin x ", "the name is missing"),
        (":w=1", "the name is missing"),
        ("chaikin x chaikin x chaikin x chaikin", "two or three factors"),
        ("six-point:3/256", "name=value"),
        ("six-point:w=1,,", "name=value"),
        ("six-point:w=", "the value of `w` is missing"),
        ("six-point:=1", "a parameter's name"),
        ("six-point:2w=1", "a parameter's name"),
        ("six-point:w=1,w=1", "given twice"),
    ] {
        let error = parse_scheme(text).expect_err(text);
        assert!(
            matches!(
                error,
                SchemeError::Reference(
                    ReferenceError::Form { .. } | ReferenceError::Unnamed { .. }
                )
            ),
            "{text}: {error}"
        );
        assert!(error.to_string().contains(reason), "{text}: {error}");
    }
    for (text, reason) in [
        ("six-point:w=3 256", "in `3 256`: expected an operator"),
        ("six-point:w=max(1,2", "in `max(1,2`: expected `,` or `)`"),
        ("six-point:w=1/0", "division by zero"),
        ("six-point:w=v", "unknown name `v`"),
        ("six-point", "`six-point` needs its parameter `w`: write `six-point:w=…`"),
        ("six-point:w=1,v=2", "`six-point` has no parameter `v`; it has: w"),
        ("chaikin:w=2", "`chaikin` has no parameter `w`; it has none"),
        ("seven-point", "unknown scheme `seven-point`; known: six-point, four-point"),
        (
            "seven-point",
            "more; a scheme may also be the path of a .toml file, or a mask such as `[1, 3, 3, 1]/4`",
        ),
        ("newton:j=1,n=1", "`newton` needs n >= 2, and n is 1"),
        ("newton:j=1,n=100", "the arity is 100; it must be an integer from 2 to 64"),
        ("newton:j=1/3,n=2", "the offset is -1/3; it must be an integer from -10000 to 10000"),
        ("newton:j=200,n=2", "the width is 402; it must be an integer from 1 to 256"),
        ("no/such/file.toml", "cannot read `no/such/file.toml`"),
    ] {
        let error = parse_scheme(text).expect_err(text).to_string();
        assert!(error.contains(reason), "{text}: {error}");
    }
    let long = format!("six-point:w={}", "1+".repeat(3_000));
    assert!(parse_scheme(&long).unwrap_err().to_string().contains("too long"));
}

proptest! {
    #[test]
    fn no_text_makes_the_program_panic(
        pieces in prop::collection::vec(prop::sample::select(vec![
            "chaikin", "newton", "six-point", "b-spline", ":", "=", ",", " x ", "w", "j", "n", "degree", "1", "3/256", "-",
            "(", ")", "[", "]", "/4", ".toml", "é", "^9^9", "2", " ",
        ]), 0..12),
    ) {
        match parse_scheme(&pieces.concat()) {
            Ok(scheme) => for mask in scheme.masks() {
                let sums = mask.rules().rows().iter().map(|row| row.iter().sum());
                prop_assert!(sums.into_iter().all(|sum: subcert::exact::Rational| sum == r(1, 1)));
            },
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}
