//! Lines `limits`, and what follows from them.

use crate::masks::relation_of;
use subcert_check::Outcome;

const SCHEMES: &str = r#"
[[scheme]]
name = "four"
mask = '[-1, 0, 9, 16, 9, 0, -1]/16'
[[scheme]]
name = "same-four"
symbol = '(-z^3 + 9*z + 16 + 9/z - z^-3)/16'
[[scheme]]
name = "hat"
mask = '[1, 2, 1]/2'
[[scheme]]
name = "two"
mask = '[1, 3, 3, 1]/4'
[[scheme]]
name = "divergent"
mask = [['2', '-1'], ['-1', '2']]
[[scheme]]
name = "averaged"
symbol = '(1 + z)*(1 + z^2)/2'
[[scheme]]
name = "smoother"
symbol = '(1 + z)^2*(1 + z^2)^2/8'
[[scheme]]
name = "ternary"
symbol = '(1 + z + z^2)^2/3'
[[scheme]]
name = "golden"
use = "corner-cutting:w=2*cos(pi/5) - 3/2"
"#;

const FOUR: &str = "limits four\n order 4\n product 0\n eigenvalue positive 4\n at-most 4\n unit 1\n image\n image\n image\n image\n continuous 1\n not-continuous 2\n end";
const HAT: &str = "limits hat\n order 2\n product 1\n eigenvalue positive 2\n at-most 2\n unit 1\n image\n image\n continuous 0\n not-continuous 1\n end";
const DIVERGENT: &str = "limits divergent\n order 1\n product 0\n eigenvalue positive 6\n at-most 6\n unit 1\n image\n image\n image\n image\n not-continuous 0\n end";
const AVERAGED: &str = "limits averaged\n order 1\n product 1\n eigenvalue positive 1\n at-most 1\n unit 1\n row 1 1\n image\n image 2:1\n image 2:1\n image\n image 2:1\n image 2:1\n continuous 0\n end";
/// B(z) is 1, and the one matrix that is not 0 is the number 3.
const TERNARY: &str = "limits ternary\n order 2\n product 2\n eigenvalue positive 3\n at-most 3\n unit 1\n image\n image\n image\n continuous 0\n not-continuous 1\n end";

/// The outcome of a statement with these lines before it.
fn after(lines: &str, states: &str, verdict: &str) -> Outcome {
    let lines = if lines.is_empty() { String::new() } else { format!("{lines}\n ") };
    let lines = format!("{lines}states {states}\n {verdict}");
    relation_of(SCHEMES, &format!("states = '{states}'"), &lines)
}

fn holds(lines: &str, states: &str) -> bool {
    after(lines, states, "holds 1") == Outcome::Valid
}

/// Without the value nothing is said.
fn unknown(lines: &str, states: &str) -> bool {
    matches!(after(lines, states, "holds 1"), Outcome::Incomplete(_))
        && !matches!(after(lines, states, "fails 1\n case = 1"), Outcome::Valid)
}

#[test]
fn exact_values() {
    for (lines, formula, value) in [
        (FOUR, "smoothness(four)", 1),
        (FOUR, "hoelder(four)", 2),
        (FOUR, "smoothness(scheme = same-four)", 1),
        (FOUR, "hoelder(scheme = same-four)", 2),
        (HAT, "smoothness(hat)", 0),
        (HAT, "hoelder(hat)", 1),
        (DIVERGENT, "smoothness(divergent)", -1),
        (TERNARY, "smoothness(ternary)", 0),
        (TERNARY, "hoelder(ternary)", 1),
    ] {
        assert!(holds(lines, &format!("{formula} = {value}")), "{formula}");
        assert!(!holds(lines, &format!("{formula} = {value} + 1")), "{formula}");
        let other = after(lines, &format!("{formula} < {value}"), "fails 1\n case = 0");
        assert_eq!(other, Outcome::Valid, "{formula}");
        assert_ne!(after(lines, &format!("{formula} = {value}"), "fails 1"), Outcome::Valid);
    }
    let both = format!("{HAT}\n {FOUR}\n {DIVERGENT}");
    assert!(holds(
        &both,
        "smoothness(four) - smoothness(hat)*smoothness(divergent) = hoelder(hat)"
    ));
    // The scheme of the claim.
    let states = "hoelder() = smoothness() + 1";
    let found = relation_of(
        SCHEMES,
        &format!("scheme = 'four'\nstates = '{states}'"),
        &format!("{FOUR}\n states {states}\n holds 1"),
    );
    assert_eq!(found, Outcome::Valid);
}

#[test]
fn what_is_not_known() {
    let constant = "constant hat contraction adjoint 1 0 1/2\n powers";
    for (lines, states) in [
        ("", "smoothness(four) = 1"),
        ("", "hoelder(four) = 2"),
        (HAT, "hoelder(four) = 2"),
        (FOUR, "smoothness(two) = 1"),
        (DIVERGENT, "hoelder(divergent) = 0"),
        // The shifts are dependent: orders of the mask bound nothing.
        (AVERAGED, "smoothness(averaged) = 0"),
        (AVERAGED, "hoelder(averaged) = 1"),
        ("", "smoothness(golden) = 0"),
        (constant, "hoelder(hat) = 1"),
    ] {
        assert!(unknown(lines, states), "{states}");
    }
    // The upper bound is missing, or nothing is said of continuity.
    let weak = HAT.replace(" not-continuous 1\n", "");
    assert!(holds(&weak, "hoelder(hat) = 1"));
    assert!(unknown(&weak, "smoothness(hat) = 1"));
    let silent = weak.replace(" continuous 0\n", "");
    assert!(unknown(&silent, "hoelder(hat) = 1"));
    assert!(unknown(&silent, "smoothness(hat) = 0"));
    let below =
        HAT.replace("product 1\n eigenvalue positive 2\n ", "").replace("not-continuous 1\n ", "");
    assert!(unknown(&below, "hoelder(hat) = 1"));
    // Rules, bounds and lines of several certificates add up.
    let two = format!("{silent}\n {HAT}");
    assert!(holds(&two, "hoelder(hat) = 1") && holds(&two, "smoothness(hat) = 0"));
    let rough = HAT.replace("at-most 2", "at-most 3");
    assert!(unknown(&rough, "hoelder(hat) = 1"));
    assert!(holds(&format!("{rough}\n {HAT}"), "hoelder(hat) = 1"));
}

/// Lines that are changed, at a wrong place or left out.
#[test]
fn changed_lines() {
    let states = "smoothness(hat) = 0";
    let refused = |lines: &str| assert!(!holds(lines, states), "{lines}");
    assert!(holds(HAT, states));
    for (from, to) in [
        ("limits hat", "limits"),
        ("limits hat", "limits hat hat"),
        ("limits hat", "limits four"),
        ("limits hat", "limits two"),
        ("limits hat", "limits golden"),
        ("limits hat", "limits nothing"),
        ("limits hat", "limits catmull-clark"),
        ("limits hat", "limits hat x hat"),
        ("limits hat", "limit hat"),
        ("order 2", "order 1"),
        ("order 2", "order 3"),
        ("order 2\n ", ""),
        ("order 2", "rule 1 0\n rule 1/2 1/2\n order 2"),
        ("product 1", "product 0"),
        ("product 1", "product 2"),
        ("eigenvalue positive 2", "eigenvalue positive 3"),
        ("eigenvalue positive 2", "eigenvalue negative 2"),
        ("at-most 2", "at-most 1"),
        ("at-most 2", "at-most 4"),
        ("at-most 2\n ", ""),
        ("unit 1", "unit 0"),
        ("image\n image", "image"),
        ("image\n image", "image\n image\n image"),
        ("image\n image", "image\n image 0:-1/2"),
        ("continuous 0", "continuous 1"),
        ("not-continuous 1", "not-continuous 0"),
        ("not-continuous 1", "not-continuous 3"),
        ("\n end", ""),
        ("\n end", "\n end\n end"),
        ("end", "ende"),
    ] {
        assert!(HAT.contains(from), "{from}");
        refused(&HAT.replacen(from, to, 1));
    }
    refused(&format!("{HAT}\n {}", HAT.replace("at-most 2", "at-most 1")));
    refused(&format!("{HAT}\n constant hat contraction adjoint 1 0 1/2\n powers"));
    assert!(holds(&format!("constant hat contraction adjoint 1 0 1/2\n powers\n {HAT}"), states));
    assert!(holds(&format!("{HAT}\n {HAT}"), states));
    // After the statement, and in the block of another claim.
    let late = format!("states {states}\n {HAT}\n holds 1");
    assert_ne!(relation_of(SCHEMES, &format!("states = '{states}'"), &late), Outcome::Valid);
    let last = format!("states {states}\n holds 1\n {HAT}");
    assert_ne!(relation_of(SCHEMES, &format!("states = '{states}'"), &last), Outcome::Valid);
}

/// What one block shows, another one does not know.
#[test]
fn blocks_of_their_own() {
    let states = "smoothness(hat) = 0";
    let claims = format!(
        "key = 'k'\n{SCHEMES}\n[[relation]]\nid = 'r'\nstates = '{states}'\n[[relation]]\nid = 's'\nstates = '{states}'\n\
         [[equation]]\nid = 'e'\nleft = ['1']\nright = '1'\n"
    );
    let certificate = format!(
        "subcert-certificate 4\npaper k\nrelation r\n {HAT}\n states {states}\n holds 1\n\
         relation s\n states {states}\n holds 1\nequation e\n {HAT}\n left 1\n right 1\n holds 1\nend 3\n"
    );
    let report = subcert_check::check(&claims, &[&certificate]).expect("a claim file");
    let outcomes: Vec<&Outcome> = report.claims.iter().map(|(_, _, outcome)| outcome).collect();
    assert_eq!(outcomes.iter().filter(|outcome| ***outcome == Outcome::Valid).count(), 1);
    assert_eq!(
        outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Invalid(..))).count(),
        1
    );
}

/// Every line of a certificate is needed, and every number in it.
#[test]
fn mutations_of_all_lines() {
    for (lines, states) in [
        (FOUR, "smoothness(four) + hoelder(four) = 3"),
        (HAT, "smoothness(hat) + hoelder(hat) = 1"),
        (TERNARY, "smoothness(ternary) + hoelder(ternary) = 1"),
        (DIVERGENT, "smoothness(divergent) = -1"),
    ] {
        assert!(holds(lines, states), "{states}");
        let all: Vec<&str> = lines.split("\n ").collect();
        for at in 0..all.len() {
            let less = [&all[..at], &all[at + 1..]].concat().join("\n ");
            // What says that limits are less smooth follows from the order too.
            let order = all[at].starts_with("not-continuous") && !states.contains("divergent");
            assert!(order || !holds(&less, states), "without `{}`", all[at]);
            let more = [&all[..=at], &all[at..]].concat().join("\n ");
            assert!(!holds(&more, states), "`{}` twice", all[at]);
            let mut turned = all.clone();
            turned.swap(at, (at + 1) % all.len());
            let same = turned == all;
            assert!(same || !holds(&turned.join("\n "), states), "`{}` later", all[at]);
        }
    }
}
