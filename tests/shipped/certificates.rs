//! Certificates of shipped constants, by the word of the checker, which finds every verdict in its own way.

use super::{HEAD, table};
use proptest::prelude::*;
use subcert::certificate::project_certificate;
use subcert::diagnostic::SourceText;
use subcert::shipped::{audit_project, read_project};
use subcert_check::{Outcome, check};

/// The certificate of a claim file.
fn written(text: &str) -> String {
    let project = read_project(&SourceText::new("k.toml", text.to_owned()));
    let project = project.unwrap_or_else(|errors| panic!("{errors}"));
    project_certificate(&audit_project(&project).expect("an audit")).text
}

/// What the checker says of the only table.
fn checked(text: &str, certificate: &str) -> Outcome {
    let report = check(text, &[certificate]).expect("a claim file");
    match report.broken.first() {
        Some((place, rejection)) => Outcome::Invalid(*place, rejection.clone()),
        None => report.claims[0].2.clone(),
    }
}

/// Whether the program and the checker take a text for a number of a language. No number equals what is claimed.
fn read_by_both(language: &str, literal: &str) -> [bool; 2] {
    let text = format!(
        "{HEAD}[[shipped]]\nid = 't'\nlocus = 'l'\ntype = 'f64'\nlanguage = '{language}'\nequals = 'sqrt(7)'\n\
         cells = [\"{literal}\"]\n"
    );
    let certificate = format!(
        "subcert-certificate 4\nproject k\nshipped t\n  bits 64\n  cell \"{literal}\" refuted 0\n  outcome refuted\nend 1\n"
    );
    let reason = match checked(&text, &certificate) {
        Outcome::Invalid(_, rejection) | Outcome::Incomplete(Some(rejection)) => {
            rejection.reason.to_string()
        }
        outcome => format!("{outcome:?}"),
    };
    let refused = reason.contains("is no number in the language")
        || reason.contains("long double")
        || reason.contains("whether a compiler rounds");
    let project = read_project(&SourceText::new("k.toml", text));
    [project.is_ok(), !refused]
}

/// What the grammars of the languages say, and gcc, node, Python and rustc.
#[test]
fn literals_of_each_language() {
    for (language, literals) in [
        (
            "c",
            "1'000 0x1'f 1e1'0 0x1.8p1 0x1.8p1'0f 0.5L (float)0.5L 1uLL 1.5F | 1''5 15' '5' _10 1_0 0x'1f 1'.5 1.'5 \
             0x1p'1 0.1L (float)0.1L 1lL 1lLu 1.5i 5j 0x1.8 1'f 1.5q 1.5_km",
        ),
        ("hlsl", "1.5 1.5F 1.5l 7u 0x1F (float)0.5 double(2) | 1'0 1_0 0x1p3 1.5h 1i 1.5lf 0.1"),
        ("wgsl", "1.5 1.5f 7 0x1F f32(0.5) 1f | 1'0 1_0 0x1p3 1.5h 1i 7u 1.5l float(1) (f32)1 0.1"),
        ("matlab", "1.5 1d-3 1E2 single(0.1) double(0.5) .5 5. | 1_0 0x1F 1i 1f 1.5d 0b1 float(1)"),
        ("shader", "1.5 1.5LF 1.5lf 7u 0x1F | 1'0 1_0 0x1p3 1.5lF 1.5h 1.5L"),
        (
            "javascript",
            "1_000 0x1_f 1.5e1_0 0X1F | 1__0 _10 10_ 1_.5 1._5 0x_1 0x1p3 1n (float)1 float(1) 1.5f 0b1",
        ),
        (
            "python",
            "1_000 0x_1f 1e1_0 float(1) (float(1)) | 0x__1 1__0 1_e5 1_ _1 (float)1 double(1) 1j 1L 0o17 1'0",
        ),
        ("rust", "1_000 1__0.5_ 1_.5 1_f32 1e_5 1e5_f64 | 1._5 1F32 _1 float(1.0) 1'0 1.5f 1e_"),
    ] {
        let (right, wrong) = literals.split_once('|').expect("two parts");
        for (texts, read) in [(right, true), (wrong, false)] {
            for literal in texts.split_whitespace() {
                assert_eq!(read_by_both(language, literal), [read; 2], "{language}: {literal}");
            }
        }
    }
}

/// Formulas in k of every kind, irrational but for the first two.
const FORMULAS: [&str; 9] = [
    "k/7",
    "binomial(k + 3, 2)/2^k - mod(k, 3)",
    "cos(2*pi*k/11)",
    "sqrt(k + 1/3)",
    "(g + 5 + sqrt((g + 9)*(g + 1)))/16",
    "root([-k, -1, 0, 1], 1)",
    "sum(h = 1..k, sqrt(h)/h)",
    "max(g, g^2) - min(0, 1 - k)*abs(g)",
    "root([1, -3*g, 0, 1], 1)*sqrt(2)",
];

/// A decimal near a value: so many digits, then one digit changed.
fn near(value: f64, digits: usize, change: Option<(usize, u8)>, suffix: &str) -> String {
    let mut text = format!("{value:.digits$}").into_bytes();
    if let Some((place, digit)) = change {
        let places: Vec<usize> =
            (0..text.len()).filter(|&at| text[at].is_ascii_digit() && at > 0).collect();
        text[places[place % places.len()]] = b'0' + digit;
    }
    format!("{}{suffix}", String::from_utf8(text).expect("ASCII"))
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    /// No text is a number for one of the two alone.
    #[test]
    fn texts_are_numbers_for_both_or_for_none(
        language in prop::sample::select(vec!["c", "shader", "javascript", "python", "rust"]),
        text in "[0-9'_.xXeEpPfFlLuUjn]{1,7}([-+][0-9'_fFlL]{1,3})?",
    ) {
        let [program, checker] = read_by_both(language, &text);
        prop_assert_eq!(program, checker, "{}: {}", language, text);
    }

    /// Whatever the program says of numbers, the checker finds too.
    #[test]
    fn what_the_program_finds_the_checker_finds(
        formula in 0..FORMULAS.len(),
        digits in proptest::collection::vec(1_usize..18, 4),
        changes in proptest::collection::vec(proptest::option::of((0_usize..20, 0_u8..10)), 4),
        kind in 0..3_usize,
    ) {
        let (kind, suffix) = [("f32", "f"), ("f64", ""), ("decimal:6", "")][kind];
        let exact = table(kind, "'k = 1..4'", FORMULAS[formula], &["0.5"; 4]);
        let define = "[define]\ng = 'cos(2*pi/7)'\n";
        let project = read_project(&SourceText::new("k.toml", format!("{HEAD}{define}{exact}"))).expect("a file");
        let audit = audit_project(&project).expect("an audit");
        let cells: Vec<String> = audit.findings[0].cells.iter().zip(digits.iter().zip(&changes)).map(|(cell, (digits, change))| {
            let value: f64 = subcert::shipped::decimal(cell.exact.as_ref().unwrap(), 17).parse().expect("a number");
            near(value, *digits, *change, suffix)
        }).collect();
        let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
        let text = format!("{HEAD}{define}{}", table(kind, "'k = 1..4'", FORMULAS[formula], &cells));
        let certificate = written(&text);
        prop_assert_eq!(checked(&text, &certificate), Outcome::Valid, "{}", certificate);
        // Another verdict of any number is refused.
        for word in ["nearest", "rounded 5", "cut 5", "ulps 3", "misprint digit", "refuted 2"] {
            let changed: String = certificate.lines().map(|line| match line.rsplit_once('"') {
                Some((cell, said)) if said.trim() != word && cell.starts_with("  cell 2 ") => format!("{cell}\" {word}\n"),
                _ => format!("{line}\n"),
            }).collect();
            if changed != certificate {
                let outcome = checked(&text, &changed);
                prop_assert!(matches!(outcome, Outcome::Invalid(..)), "{:?}: {}", outcome, changed);
            }
        }
    }
}

/// Readings are certified too: the numbers of a definition that was rounded, and of another convention.
#[test]
fn readings() {
    let early = table("f64", "'k = 1..4'", "k*g", &["1.41400", "2.82800", "4.24200", "5.65600"]);
    let early = format!("{HEAD}[define]\ng = 'sqrt(2)'\n{early}");
    let certificate = written(&early);
    assert!(certificate.contains("\n  early g 3\n"), "{certificate}");
    assert_eq!(checked(&early, &certificate), Outcome::Valid);
    let other = table("f32", "'n = 4..6'", "1/n", &["0.09375f", "0.075f", "0.0625f"]);
    let other =
        format!("{HEAD}{other}[[shipped.convention]]\nlabel = 'Warren'\nequals = '3/(8*n)'\n");
    let certificate = written(&other);
    assert!(certificate.contains("\n  convention 1\n"), "{certificate}");
    assert_eq!(checked(&other, &certificate), Outcome::Valid);
}
