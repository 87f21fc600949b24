//! How smooth the limits of masks on Z^d are.
//!
//! The lines in `limits` were made by a program of its own in Python, with fractions, from proofs/format/lattice.md alone. Box splines and their
//! exponents are known; so is that of `pyramid`, −2·log_2(c/2) with c = (1 + √5)/2.

use super::SCHEMES;
use subcert_check::{Outcome, check};

/// More schemes.
const MORE: &str = "
[[scheme]]
name = 'bilinear'
symbol = '(1+x)^2*(1+y)^2/4'
[[scheme]]
name = 'trilinear'
symbol = '(1+x)^2*(1+y)^2*(1+z)^2/8'
[[scheme]]
name = 'haar'
symbol = '(1+x)*(1+y)'
[[scheme]]
name = 'haar-and-hat'
symbol = '(1+x)*(1+y)^2/2'
[[scheme]]
name = 'cubic-and-hat'
symbol = '(1+x)^4*(1+y)^2/16'
";

/// The lines that a file shows.
pub fn lines(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/lattices/limits");
    std::fs::read_to_string(format!("{folder}/{name}.lines")).expect(name)
}

/// The lines about a hat function, and about a cubic B-spline: the matrices are the numbers 0 and 2.
pub const HAT: &str =
    "order 2\nproduct 1\neigenvalue positive 2\nat-most 2\nunit 1\nimage\nimage\ncontinuous 0\nend";
pub const CUBIC: &str =
    "order 4\nproduct 1\neigenvalue positive 2\nat-most 2\nunit 1\nimage\nimage\ncontinuous 2\nend";

/// The lines that a claim repeats.
const RESTATED: [(&str, &str); 6] = [
    ("continuous", "states-continuous"),
    ("not_continuous", "states-not-continuous"),
    ("value", "value"),
    ("at_least", "at-least"),
    ("at_most", "at-most"),
    ("printed", "printed"),
];

/// The outcome of a claim with this field about the limits of a scheme, lines about them, and this verdict.
pub fn of_field(scheme: &str, field: (&str, &str), lines: &str, verdict: &str) -> Outcome {
    judged_by(&format!("{SCHEMES}\n{MORE}"), scheme, field, (lines, verdict))
}

/// The same of a scheme with these fields.
pub fn own(scheme: &str, field: (&str, &str), lines: &str, verdict: &str) -> Outcome {
    judged_by(&format!("[[scheme]]\nname = 'own'\n{scheme}"), "own", field, (lines, verdict))
}

fn judged_by(
    schemes: &str,
    scheme: &str,
    (field, text): (&str, &str),
    (lines, verdict): (&str, &str),
) -> Outcome {
    let kind = if field.ends_with("continuous") { "smoothness" } else { "exponent" };
    let claims = format!(
        "key = 'k'\n{schemes}\n[[{kind}]]\nid = 'c'\nscheme = '{scheme}'\n{field} = '{text}'\n"
    );
    let word = RESTATED.iter().find(|(known, _)| *known == field).expect("a field").1;
    let lines = format!(" {}\n", lines.replace('\n', "\n "));
    let certificate = format!(
        "subcert-certificate 4\npaper k\n{kind} c\n scheme {scheme}\n {word} {text}\n{lines} {verdict}\nend 1\n"
    );
    let report = check(&claims, &[&certificate]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    report.claims.into_iter().next().expect("a claim").2
}

/// Checks that claims, `FIELD TEXT`, are confirmed or refuted by these lines, and never the contrary, or neither.
fn judged(scheme: &str, lines: &str, [confirmed, refuted, neither]: [&str; 3]) {
    let all = [(confirmed, "confirmed"), (refuted, "refuted"), (neither, "")];
    for (claims, verdict) in all {
        for claim in claims.split(';').map(str::trim).filter(|claim| !claim.is_empty()) {
            let (field, text) = claim.split_once(' ').expect("a field");
            for other in ["confirmed", "refuted"] {
                let found = of_field(scheme, (field, text), lines, other);
                assert_eq!(
                    found == Outcome::Valid,
                    other == verdict,
                    "{scheme}: {claim} {other}: {found:?}"
                );
            }
        }
    }
}

#[test]
fn convergence() {
    let neither = "continuous 1; not_continuous 1; at_least 0; at_most 9; value 1; printed 0.5";
    for (scheme, lines) in [
        ("three", "contraction 1\nend".to_owned()),
        ("quincunx", "contraction 2\nend".to_owned()),
        ("cube", "contraction 1\nend".to_owned()),
        ("three", lines("three-differences") + "end"),
    ] {
        judged(scheme, &lines, ["continuous 0", "not_continuous 0", neither]);
    }
}

#[test]
fn divergence() {
    for (scheme, name) in
        [("haar", "haar"), ("haar", "haar-moved"), ("wide", "wide"), ("tension:w=2", "tension")]
    {
        judged(
            scheme,
            &(lines(name) + "end"),
            [
                "not_continuous 0; not_continuous 1",
                "continuous 0; continuous 1; at_least 0; at_most 9; value 1; printed 0.5",
                "",
            ],
        );
    }
    let found =
        of_field("quincunx", ("not_continuous", "0"), &(lines("haar") + "end"), "confirmed");
    assert_ne!(found, Outcome::Valid);
}

/// A spline of three directions has the exponent 1.
#[test]
fn exact_exponent() {
    let lines = format!("contraction 1\n{}end", lines("three-hexagon"));
    judged(
        "three",
        &lines,
        [
            "continuous 0; not_continuous 1; not_continuous 2; value 1; at_least 1; at_most 1; \
             at_least 1/2; at_least log_2(15/8); at_most log_2(17/8); printed 1.00; printed 1",
            "continuous 1; continuous 2; value 0.999; value 1.001; at_least 1.001; at_most 0.999; \
             printed 1.01; printed 0.9",
            "at_least log_4(15/8); at_most log_3(2)",
        ],
    );
    let found = of_field("three", ("printed", "0.7"), &lines, "rounding cut");
    assert_ne!(found, Outcome::Valid);
}

/// Bounds of exponents: −log_2 of 2/4 times 5/6 is above 0.73.
#[test]
fn tiles() {
    let with = |convergence: &str, name: &str| format!("{convergence}\n{}end", lines(name));
    for (scheme, name) in [("bilinear", "bilinear-square"), ("three", "three-digits")] {
        judged(
            scheme,
            &with("contraction 2", name),
            [
                "continuous 0; not_continuous 1; at_least 0.7; at_most 1",
                "not_continuous 0; continuous 1; at_least 1.01; at_most 0.7",
                "at_least 0.8; at_most 0.9; value 1; printed 1.0",
            ],
        );
    }
    // The modulus of the eigenvalues is √3, and −2·log_3(4/5) is above 0.4.
    judged(
        "root-three",
        &with("contraction 1", "root-three-hexagon"),
        [
            "continuous 0; not_continuous 1; at_least 0.4; at_most 0.739; at_most -2*log_3(2/3)",
            "continuous 1; at_least 1; at_least 0.74; at_most 0.4",
            "at_least 0.5; at_most 0.7; at_least log_2(1.2)",
        ],
    );
    judged(
        "six",
        &with("contraction 1", "six-hexagon"),
        [
            "continuous 0; continuous 1; continuous 2; not_continuous 3; at_least 5/2; at_most 3",
            "not_continuous 0; not_continuous 2; continuous 3; continuous 4; at_least 3.1; at_most 2.5",
            "at_least 3; value 3",
        ],
    );
    // Without a lower bound the accuracy is left: not all limits are C^4.
    let above = with("contraction 1", "six-hexagon");
    let lower = |line: &&str| !["product", "eigenvalue"].iter().any(|word| line.starts_with(word));
    let above: Vec<&str> = above.lines().filter(lower).collect();
    judged(
        "six",
        &above.join("\n"),
        [
            "continuous 2; not_continuous 4; not_continuous 5; at_most 4; at_least 5/2",
            "continuous 4; not_continuous 2; at_least 4.1",
            "continuous 3; not_continuous 3; at_most 3.9; value 3",
        ],
    );
    judged(
        "trilinear",
        &with("contraction 1", "trilinear-cube"),
        ["not_continuous 1; at_most 1; continuous 0", "continuous 1; at_least 1.1", "at_least 0.9"],
    );
}

/// The spline of four directions: it reproduces polynomials of degree 2, but has no sum rules of order 3. It is C^1 with the exponent 2.
#[test]
fn accuracy_beyond_sum_rules() {
    judged(
        "quincunx",
        &format!("contraction 2\n{}end", lines("quincunx-digits")),
        [
            "continuous 0; continuous 1; not_continuous 2; not_continuous 3; at_most 2; at_least 1.05",
            "continuous 2; not_continuous 1; at_least 2.01; at_most 1; value 1",
            "at_least 2; at_most 1.99",
        ],
    );
}

/// The eigenvalue c = (1 + √5)/2 of the matrices 2T_g shows that the exponent is at most 2 − 2·log_2 c = 0.6115….
#[test]
fn golden_ratio() {
    judged(
        "pyramid",
        &format!("contraction 2\n{}end", lines("pyramid-square")),
        [
            "continuous 0; not_continuous 1; at_most 0.612; at_most 2 - 2*log_2(1.6179)",
            "continuous 1; at_least 0.612; value 1",
            "at_most 0.61; at_least 0.6; printed 0.61; at_most log_4(3)",
        ],
    );
}

#[test]
fn factors() {
    judged(
        "cubic-and-hat",
        &format!("factors\n{CUBIC}\n{HAT}"),
        [
            "continuous 0; value 1; at_least 1; at_most 1; at_most 2; printed 1.0",
            "at_least 1.1; at_most 0.9; value 3",
            "continuous 1; not_continuous 1",
        ],
    );
    let rough = HAT.replace("continuous 0", "continuous 0\nnot-continuous 1");
    judged(
        "cubic-and-hat",
        &format!("factors\n{CUBIC}\n{rough}"),
        [
            "continuous 0; not_continuous 1; not_continuous 2",
            "continuous 1; continuous 2; not_continuous 0",
            "",
        ],
    );
    // Without a line that a factor converges, no exponent is at most a number.
    let open = CUBIC.replace("\ncontinuous 2", "");
    let claims = "continuous 0; at_least 1; at_most 1; at_most 9; not_continuous 1";
    judged("cubic-and-hat", &format!("factors\n{open}\n{HAT}"), ["", "", claims]);
    let haar = HAT.replace("order 2", "order 1").replace("\ncontinuous 0", "\nnot-continuous 0");
    judged(
        "haar-and-hat",
        &format!("factors\n{haar}\n{HAT}"),
        [
            "not_continuous 0; not_continuous 1",
            "continuous 0; at_least 0; at_most 9; value 1; printed 0.5",
            "",
        ],
    );
}

/// Of factors with different arities: (1 + z)²/2 and (1 + z + z²)²/3.
#[test]
fn arities() {
    let third = "order 2\nproduct 2\neigenvalue positive 3\nat-most 3\nunit 1\nimage\nimage\nimage\ncontinuous 0\nend";
    judged(
        "mixed",
        &format!("factors\n{HAT}\n{third}"),
        [
            "continuous 0; value 1; at_least 0.9; at_most 1; at_most 1.1",
            "value 2; at_least 1.5; at_most 0.5",
            "continuous 1; at_least log_2(3/2); printed 2.0e0x",
        ],
    );
}

/// A table of orders and exponents has such claims too.
#[test]
fn tables() {
    let shown = format!("contraction 1\n{}end", lines("three-hexagon"));
    let shown = format!(" {}\n", shown.replace('\n', "\n "));
    let claims = format!(
        "key = 'k'\n{SCHEMES}\n[[regularity]]\nid = 't'\nrows = {{ schemes = ['three'] }}\n\
         columns = ['order', 'exponent']\ncells = [['0', '1.0']]\n"
    );
    let certificate = format!(
        "subcert-certificate 4\npaper k\nsmoothness t.1.order\n scheme three\n states-continuous 0\n \
         states-not-continuous 1\n{shown} confirmed\nexponent t.1.exponent\n scheme three\n \
         printed 1.0\n{shown} confirmed\nend 2\n"
    );
    let report = check(&claims, &[&certificate]).expect("a claim file");
    assert!(report.claims.iter().all(|(_, _, outcome)| *outcome == Outcome::Valid), "{report:?}");
    assert_eq!(report.claims.len(), 2);
}
