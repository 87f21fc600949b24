//! False and malformed lines about the limits of masks on Z^d.

use super::limits::{CUBIC, HAT, lines, of_field, own};
use std::fmt::Write as _;
use subcert_check::Outcome;

/// The reason for which lines do not confirm a claim of this field, or the outcome.
pub fn reason(scheme: &str, field: (&str, &str), lines: &str) -> String {
    match of_field(scheme, field, lines, "confirmed") {
        Outcome::Invalid(_, rejection) | Outcome::Incomplete(Some(rejection)) => {
            rejection.reason.to_string()
        }
        other => format!("{other:?}"),
    }
}

/// The text with one piece in place of another one, which occurs.
pub fn with(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

/// Checks that lines with a piece in place of another one are refused for these reasons.
pub fn altered(scheme: &str, field: (&str, &str), lines: &str, list: &[(&str, &str, &str)]) {
    assert_eq!(reason(scheme, field, lines), "Valid");
    let mut wrong = String::new();
    for (from, to, why) in list {
        let found = reason(scheme, field, &with(lines, from, to));
        if !found.contains(why) {
            let _ = writeln!(wrong, "{from:?} → {to:?}: {found}");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Integers that no type of a machine holds, or hardly.
pub const EXTREME: [&str; 8] = [
    "2147483648",
    "-2147483649",
    "9007199254740993",
    "9223372036854775807",
    "-9223372036854775808",
    "9223372036854775808",
    "18446744073709551616",
    "10000000000000000000000000000000000000000000000000000000000000000000000",
];

#[test]
fn contraction() {
    let of = |scheme: &str, lines: &str| reason(scheme, ("continuous", "0"), lines);
    assert_eq!(of("quincunx", "contraction 2\nend"), "Valid");
    for (said, why) in [
        ("0", "not below 1"),
        ("1", "not below 1"),
        ("-1", "a count"),
        ("+2", "a count"),
        ("2 2", "a count"),
        ("2.0", "a count"),
        ("", "a count"),
        ("14", "beyond a cap"),
    ] {
        let found = of("quincunx", &format!("contraction {said}\nend"));
        assert!(found.contains(why), "{said}: {found}");
    }
    for extreme in EXTREME.iter().filter(|extreme| !extreme.starts_with('-')) {
        let found = of("quincunx", &format!("contraction {extreme}\nend"));
        assert!(found.contains("beyond a cap"), "{extreme}: {found}");
    }
    for scheme in ["haar", "wide", "tension:w=2"] {
        for c in 1..5 {
            let found = of(scheme, &format!("contraction {c}\nend"));
            assert!(found.contains("not below 1"), "{scheme}: {found}");
        }
    }
}

#[test]
fn differences() {
    let lines = lines("three-differences") + "end";
    let at_most = lines.lines().find(|line| line.starts_with("at-most")).expect("a bound");
    altered(
        "three",
        ("continuous", "0"),
        &lines,
        &[
            ("part 1 0 0 1 0 1\n", "", "one digit of each class"),
            ("part 1 0 0 1 0 1\n", "part 1 0 0 1 0 1\npart 1 0 0 1 0 1\n", "one digit"),
            ("part 1 0 0 1 0 1\n", "part 1 0 0 1 1 0\n", "one digit"),
            ("part 1 0 0 1 0 1\n", "part 1 0 0 1 0 -2\n", "one digit"),
            ("part 1 0 0 1 0 0\n", "part 1 0 0 1 2 0\n", "0 is a digit"),
            ("part 1 0 0 1 0 0\n", "part -1 0 0 -1 0 0\n", "translations"),
            ("part 1 0 0 1 0 0\n", "part 0 1 1 0 0 0\n", "translations"),
            ("part 1 0 0 1 0 0\n", "part 1 0 0 1 0\n", "d rows"),
            ("part 1 0 0 1 0 0\n", "part 1 0 0 1 0 0 0\n", "d rows"),
            ("part 1 0 0 1 0 0\n", "part\n", "d rows"),
            ("part 1 0 0 1 0 0\n", "part 1 0 0 1 0 +0\n", "the integers"),
            ("part 1 0 0 1 0 0\n", "part 1 0 0 1 0 0/1\n", "the integers"),
            // The matrices are then in another order.
            (
                "part 1 0 0 1 0 0\npart 1 0 0 1 0 1\n",
                "part 1 0 0 1 0 1\npart 1 0 0 1 0 0\n",
                "radius",
            ),
            (at_most, "at-most 1/2", "radius"),
            (at_most, "at-most 1", "does not show"),
            (at_most, "at-most 2", "does not show"),
            ("eigenvalue positive 1/2", "eigenvalue positive 1", "is shown to reach"),
            ("eigenvalue positive 1/2", "eigenvalue negative 1/2", "is shown to reach"),
            ("product 0", "product 4", "no such matrix"),
            ("differences", "differences 1", "differences"),
            ("differences", "contraction 1\ndifferences", "end"),
            ("\nend", "\ntile\nend", "a tile"),
            ("end", "order 2\nend", "end"),
            ("end", "continuous 0\nend", "end"),
            ("end", "end\nend", "verdict"),
            ("unit", "matrix 1\nunit", "end"),
            ("at-most", "rule 1 1\nat-most", "at-most"),
            ("\nend", "\nimage\nend", "more images"),
            ("\nend", "", "end"),
        ],
    );
    // Any digits are right, but then the matrices are others.
    let found = reason("three", ("continuous", "0"), &with(&lines, "0 1 0 1\n", "0 1 0 3\n"));
    assert!(found.contains("radius"), "{found}");
    for extreme in EXTREME {
        let found = with(&lines, "part 1 0 0 1 0 1", &format!("part 1 0 0 1 0 {extreme}"));
        let found = reason("three", ("continuous", "0"), &found);
        assert!(found.contains("beyond a cap"), "{extreme}: {found}");
    }
    // The last digits that are read: the window is too large.
    for far in ["1048577", "1048575", "-1048575", "65537"] {
        let found = with(&lines, "part 1 0 0 1 0 1", &format!("part 1 0 0 1 0 {far}"));
        let found = reason("three", ("continuous", "0"), &found);
        assert!(found.contains("beyond a cap"), "{far}: {found}");
    }
}

/// Nothing follows where a scheme diverges, and it does so from the radius 1 on.
#[test]
fn divergence() {
    let lines = lines("haar") + "end";
    let tile = self::lines("three-hexagon");
    altered(
        "haar",
        ("not_continuous", "0"),
        &lines,
        &[
            ("positive 1", "positive 0.999", "does not show"),
            ("positive 1", "positive 1.001", "is shown to reach"),
            ("positive 1", "positive 0", "positive number"),
            ("positive 1", "positive -1", "positive number"),
            ("product 0\neigenvalue positive 1\n", "", "does not show"),
            ("eigenvalue positive 1\n", "", "radius"),
            ("\nend", &format!("\n{tile}end"), "end"),
        ],
    );
    let confirmed = |scheme: &str, field| reason(scheme, field, &lines);
    assert_ne!(confirmed("haar", ("continuous", "0")), "Valid");
    for scheme in ["three", "bilinear", "wide", "quincunx", "cube"] {
        assert_ne!(confirmed(scheme, ("not_continuous", "0")), "Valid", "{scheme}");
    }
}

#[test]
fn factors() {
    let both = format!("factors\n{CUBIC}\n{HAT}");
    altered(
        "cubic-and-hat",
        ("value", "1"),
        &both,
        &[
            ("order 4", "order 3", "beyond this order"),
            ("order 4", "order 5", "up to this order"),
            ("order 2", "order 1", "beyond this order"),
            ("continuous 2", "continuous 3", "upper bound"),
            ("at-most 2", "at-most 1", "sum to"),
            ("factors", "factors 2", "factors"),
            (HAT, "", "end of the radius"),
            (HAT, &format!("{HAT}\n{HAT}"), "verdict"),
            ("factors\n", "", "differences"),
        ],
    );
    for (scheme, why) in [
        ("three", "is a product"),
        ("haar-and-hat", "one size"),
        ("quincunx", "is diagonal"),
        ("mixed", "up to this order"),
        ("skew", "is a product"),
    ] {
        let found = reason(scheme, ("value", "1"), &both);
        assert!(found.contains(why), "{scheme}: {found}");
    }
    let swapped = format!("factors\n{HAT}\n{CUBIC}");
    assert!(reason("cubic-and-hat", ("value", "1"), &swapped).contains("beyond this order"));
    let negative = "symbol = '(1+x)^2*(1+y)^2/4'\ndilation = [[2, 0], [0, -2]]";
    let found = own(negative, ("value", "1"), &format!("factors\n{HAT}\n{HAT}"), "confirmed");
    assert!(format!("{found:?}").contains("is diagonal"), "{found:?}");
}

/// Lines about other schemes, and schemes of other kinds.
#[test]
fn other_schemes() {
    let lines = format!("contraction 1\n{}end", lines("three-hexagon"));
    for scheme in [
        "six",
        "bilinear",
        "haar",
        "quincunx",
        "root-three",
        "cube",
        "four",
        "box",
        "tension:w=1/8",
    ] {
        for field in [("value", "1"), ("not_continuous", "1"), ("at_least", "1")] {
            assert_ne!(reason(scheme, field, &lines), "Valid", "{scheme}");
        }
    }
    assert_eq!(reason("tension:w=0", ("value", "1"), &lines), "Valid");
    for scheme in
        ["hat", "three x hat", "three x three", "nothing", "tension", "tension:w=cos(pi/5)"]
    {
        for lines in
            [&lines[..], HAT, "contraction 1\nend", "differences\nend", "factors\nend", "end", ""]
        {
            let found = reason(scheme, ("continuous", "0"), lines);
            let right = scheme == "hat" && lines == HAT;
            assert_eq!(found == "Valid", right, "{scheme}: {found}");
        }
    }
    let masks = "symbol = '(1+x)*(1+y)*(1+x*y)/2 + sqrt(2)*(1-x^2)'";
    let found = own(masks, ("continuous", "0"), "contraction 1\nend", "confirmed");
    assert!(format!("{found:?}").contains("rational numbers"), "{found:?}");
}
