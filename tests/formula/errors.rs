//! What errors say, and the bytes they point at.

use super::{kind, value};
use proptest::prelude::*;
use subcert::diagnostic::SourceText;
use subcert::exact::{Polynomial, RealCyclotomic};
use subcert::formula::{FormulaErrorKind, LocatedFormula, Parameters, evaluate, parse};

#[test]
fn errors_point_at_the_bytes_they_are_about() {
    for (text, place, message) in [
        ("", "", "a number"),
        ("1 +", "", "a number"),
        ("(1 + 2", "", "an operator or `)`"),
        ("2 w", "w", "a product is written with `*`"),
        ("1 + * 2", "*", "a number"),
        ("3 $ 4", "$", "an operator"),
        ("1 + 2)", ")", "an operator or the end"),
        ("1..3", ".", "an operator"),
        ("1.5.5", ".", "an operator"),
        ("2e + 1", " ", "a digit"),
        (".", "", "a digit"),
        ("½½", "½", "an operator"),
        ("1 ½", "½", "an operator"),
        ("1–2", "–", "an operator"),
        ("w + nu*2", "nu", "unknown name `nu`; known here: w, μ"),
        ("μ + ω", "ω", "unknown name `ω`"),
        ("1 + frob(2, 3)*5", "frob(2, 3)", "unknown function `frob`; known here: abs"),
        ("μ/(2 - 2)", "(2 - 2)", "division by zero"),
        ("1 + 0^-1", "0^-1", "division by zero"),
        ("1 + 2^(1/2)", "2^(1/2)", "an exponent must be an integer, and is 1/2"),
        ("sum(h = 1/2..3, h)", "1/2", "the first index of a range must be an integer"),
        ("sum(h = 1..w, h)", "w", "the last index of a range must be an integer"),
        ("sum(1 = 1..2, 3)", "1", "an index"),
        ("max(h = 2..1, h)", "max(h = 2..1, h)", "the range is empty"),
        ("min(h = 1..2)", ")", "`,` and what is summed or compared"),
        ("sum(h = 1, h)", ",", "`..`"),
        ("sum(h = 1..2)", ")", "`,` and what is summed"),
        ("sum(h = 1..2, k)", "k", "unknown name `k`"),
        ("abs()", "abs()", "`abs` takes one argument"),
        ("binomial(1)", "binomial(1)", "`binomial` takes two arguments"),
        ("kronecker(1)", "kronecker(1)", "`kronecker` takes two arguments"),
        ("mod(3, w - w)", "mod(3, w - w)", "division by zero"),
        ("max()", "max()", "one argument or more"),
        ("abs(1, order = forward)", "abs(1, order = forward)", "no option `order`"),
        ("abs(order = forward, 1)", "1", "arguments come first"),
        ("abs(1,)", ")", "a number"),
        ("T(2, order = )", ")", "a word"),
        ("1e99999", "1e99999", "out of range"),
    ] {
        let error = value(text).expect_err(text);
        let found = &text[error.span.clone()];
        assert_eq!(found, place, "{text}: {:?}", error.span);
        assert!(error.to_string().contains(message), "{text}: {error}");
    }
    // Where nothing is underlined, the missing piece belongs at the end.
    for text in ["", "1 +", "(1 + 2", "sum(h = 1..2, "] {
        assert_eq!(value(text).unwrap_err().span, text.len()..text.len());
    }
}

#[test]
fn errors_in_files_are_underlined_there() {
    // In a literal string each byte of the formula is one of the file; among
    // escapes the string is underlined as a whole.
    for (file, string, formula, place) in [
        ("x = 'μ + 2 w'", "'μ + 2 w'", "μ + 2 w", "w"),
        ("x = \"μ + 2 w\"", "\"μ + 2 w\"", "μ + 2 w", "w"),
        (r#"x = "\u0032 w + 2 w""#, r#""\u0032 w + 2 w""#, "2 w + 2 w", r#""\u0032 w + 2 w""#),
        (r#"x = "2\t2 2""#, r#""2\t2 2""#, "2\t2 2", r#""2\t2 2""#),
        (r#"x = "\u0032 2""#, r#""\u0032 2""#, "2 2", r#""\u0032 2""#),
    ] {
        let start = file.find(string).unwrap();
        let source = SourceText::new("file.toml", file);
        let error =
            LocatedFormula::read(&source, start..start + string.len(), formula).unwrap_err();
        assert_eq!(&file[error.span.clone()], place, "{file}");
        assert!(error.to_string().contains("file.toml:1:"), "{error}");
    }
}

#[test]
fn symbols_have_no_order_and_no_reciprocal() {
    let symbols = Parameters::from([("w", Polynomial::variable("w"))]);
    for text in [
        "abs(w)",
        "max(w, 1)",
        "min(1, w)",
        "floor(w)",
        "ceil(w)",
        "1/w",
        "w^-1",
        "mod(w, 2)",
        "kronecker(w, 1)",
    ] {
        let error = evaluate(&parse(text).unwrap(), &symbols).unwrap_err();
        assert!(matches!(error.kind, FormulaErrorKind::Unsupported(_)), "{text}: {error}");
    }
    for text in ["2^w", "binomial(2, w)", "sum(h = 1..w, h)"] {
        let error = evaluate(&parse(text).unwrap(), &symbols).unwrap_err();
        assert!(matches!(error.kind, FormulaErrorKind::NotAnInteger { .. }), "{text}: {error}");
    }
    // What cancels is a number again.
    let one = evaluate(&parse("abs(w - w - 1)/(w - w + kronecker(w, w))").unwrap(), &symbols);
    assert_eq!(one.unwrap().as_constant(), Some(RealCyclotomic::from(1)));
    let error = evaluate(&parse("1/(w - w)").unwrap(), &symbols).unwrap_err();
    assert_eq!(error.kind, FormulaErrorKind::DivisionByZero);
}

#[test]
fn kinds() {
    assert_eq!(kind("1/0"), FormulaErrorKind::DivisionByZero);
    assert_eq!(kind("min(1/0, 2)"), FormulaErrorKind::DivisionByZero);
    assert!(matches!(kind("1e99999"), FormulaErrorKind::Number(_)));
    assert!(matches!(kind("sum + 1"), FormulaErrorKind::UnknownName { .. }));
}

/// Pieces of formulas in any order: what a parser is most likely to stumble on.
fn soup() -> impl Strategy<Value = String> {
    let pieces = [
        "(",
        ")",
        "+",
        "-",
        "−",
        "*",
        "·",
        "/",
        "^",
        ",",
        "=",
        "..",
        ".",
        "1",
        "20",
        "0",
        "e",
        "1e",
        "w",
        "μ",
        "sum(",
        "sum(h=1..3,",
        "abs(",
        "min(",
        "binomial(",
        "floor(",
        "T(",
        "order = forward",
        " ",
        "\n",
        "é",
        "∑",
        "\u{0}",
    ];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..24)
        .prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(crate::common::cases(3_000))]

    #[test]
    fn no_text_makes_the_program_panic(text in prop_oneof![soup(), ".{0,40}"]) {
        let symbols = Parameters::from([("w", Polynomial::variable("w"))]);
        let results = match parse(&text) {
            Err(error) => vec![error],
            Ok(formula) => [value(&text).err(), evaluate(&formula, &symbols).err()].into_iter().flatten().collect(),
        };
        for error in results {
            prop_assert!(text.get(error.span.clone()).is_some(), "{:?} of {text:?}", error.span);
            let source = SourceText::new("formula", text.clone());
            if let Err(diagnostic) = LocatedFormula::read(&source, 0..text.len(), &text) {
                prop_assert!(!diagnostic.to_string().is_empty());
            }
        }
    }
}
