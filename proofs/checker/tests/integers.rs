//! Functions of an integer: comparisons for all integers from one on.

mod refused;
mod rings;
mod switched;

use crate::masks::relation_of;
use std::time::Instant;
use subcert_check::{Outcome, Reason};

/// The outcome of a statement with these lines, for `all n` or such.
fn outcome_of(file: &str, of: &str, states: &str, lines: &str) -> Outcome {
    let fields = format!("states = '{states}'\nfor = {of}");
    relation_of(file, &fields, &format!("states {states}\n {lines}"))
}

/// The outcome of `holds all` for all integers from one on.
fn outcome(file: &str, least: i64, states: &str) -> Outcome {
    outcome_of(file, &format!("'all n >= {least}'"), states, "holds all")
}

fn is_incomplete(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Incomplete(_))
}

fn is_open(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Incomplete(Some(rejection)) if rejection.reason == Reason::Open)
}

/// What is shown is also true of the first integers, and its opposite is not shown.
fn are_shown(file: &str, list: &[(i64, &str)]) {
    for (least, states) in list {
        let found = outcome(file, *least, states);
        assert_eq!(found, Outcome::Valid, "{states}: {found:?}");
        let opposite = [(" = ", " != "), (" < ", " >= "), (" > ", " <= "), (" >= ", " < ")];
        let (sign, other) =
            opposite.into_iter().find(|(sign, _)| states.contains(sign)).unwrap_or((" != ", " = "));
        let states = states.replace(sign, other);
        let found = outcome(file, *least, &states);
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

/// Functions without rings.
#[test]
fn functions() {
    are_shown(
        "[define]\nhalf = '1/n'\nb = 'half + a'\na = 'half^2'\n",
        &[
            (3, "1/n < 1"),
            (3, "sqrt(n + 1) > 1 + 1/n"),
            (3, "cos(2*pi/n) > 1 - 20/n^2"),
            (3, "cos(2*pi/n) = 2*cos(pi/n)^2 - 1"),
            (3, "cos(2*pi*(1 + 3/n)) = 4*cos(2*pi/n)^3 - 3*cos(2*pi/n)"),
            (3, "cos(pi - 2*pi/n) = -cos(2*pi/n)"),
            (3, "cos(pi*(n + 1)/n) = -cos(pi/n)"),
            (3, "cos(n*pi/(3*n)) = 1/2"),
            (3, "max(n, 3) = n"),
            (3, "min(1/n, 1/(n + 1), 2) = 1/(n + 1)"),
            (3, "abs(1/n - 1) = 1 - 1/n"),
            (3, "floor(n/(n + 1)) = 0"),
            (3, "ceil(n/(n + 1)) > n/(n + 1)"),
            (3, "ceil(1/n) = 1"),
            (3, "floor(-1/n) = -1"),
            (3, "mod(n - 1, n) = n - 1"),
            (3, "mod(-1, n) = n - 1"),
            (3, "kronecker(n + 1, n) = 0"),
            (3, "kronecker(n/n, 1) = 1"),
            (3, "sqrt(n^2 + 2*n + 1) = n + 1"),
            (1, "(sqrt(n) + 1)*(sqrt(n) - 1) = n - 1"),
            (1, "sqrt(4*n) = 2*sqrt(n)"),
            (2, "1/(sqrt(n) - 1) = (sqrt(n) + 1)/(n - 1)"),
            (1, "sqrt(n + 1) - sqrt(n) > 0"),
            (1, "sqrt(8)/n = 2*sqrt(2)/n"),
            (1, "sqrt(n/3) > 1/2"),
            (1, "sum(i = 1..3, 1/(n + i)) < 3/n"),
            (1, "product(i = 0..2, n + i)/n = n^2 + 3*n + 2"),
            (1, "max(i = 1..3, i/n) = 3/n"),
            (1, "n^-2 = half^2"),
            (1, "b = 1/n + 1/n^2"),
            (1, "1/n != 2/n"),
            (1, "(n - 13/2)^2 > 0"),
            (1, "(n - 1001/10)^2/n > 0"),
            (1, "binomial(n, 2)/n = (n - 1)/2"),
            (2, "cos(2*pi/(2*n)) >= cos(2*pi*(1/n))"),
        ],
    );
    for states in ["1/n in {0, 1/n}", "1/n in (0, 1]", "n/n", "not n - n/1*n/n"] {
        assert_eq!(outcome("", 1, states), Outcome::Valid, "{states}");
    }
    let of = "['k = 0..5', 'all n >= 1']";
    for (states, holds) in [("k/n >= 0", true), ("k/n > 0", false), ("k/n <= 5/n", true)] {
        let found = outcome_of("", of, states, "holds all");
        assert_eq!(found == Outcome::Valid, holds, "{states}: {found:?}");
    }
}

/// First integers that are negative, and great ones.
#[test]
fn first_integers() {
    for (least, holds) in [(-8, true), (-9, true), (0, true), (900, true)] {
        let found = outcome("", least, "1/(n^2 + 1) > 0");
        assert_eq!(found == Outcome::Valid, holds, "{least}: {found:?}");
    }
}

/// Cases that are tried may be real numbers.
#[test]
fn tried() {
    for (states, holds) in [
        ("sqrt(n^2 + 1) > n", true),
        ("sqrt(n^2 + 1) > n + 1/40", false),
        ("n*(n - 24)*sqrt(n + 1/2) <= 0", true),
        ("root([-n, 0, 0, 1], 1) >= 1", true),
        ("root([-n, 0, 0, 1], 1)^3 = n", true),
        ("root([-n, 0, 0, 1], 1) < 2", false),
    ] {
        for lines in ["tried 24", "tried 23", "tried 25", "tried 24\n case 1 in 0 1"] {
            let found = outcome_of("", "'all n'", states, lines);
            let is = holds && lines == "tried 24";
            assert_eq!(is_open(&found), is, "{states}: {lines}: {found:?}");
            assert_ne!(found, Outcome::Valid, "{states}");
        }
    }
    let rings = [("curvature(catmull-clark, n) > 1", true), ("subdominant(loop, n) > 1/2", false)];
    for (states, holds) in rings {
        let found = outcome_of("", "'all n >= 5'", states, "tried 24");
        assert_eq!(is_open(&found), holds, "{states}: {found:?}");
    }
}

/// What would keep a checker busy.
#[test]
fn large() {
    let start = Instant::now();
    let names: Vec<String> = (1..60).map(|i| format!("b{i} = 'b{}*b{}'", i - 1, i - 1)).collect();
    let file = format!(
        "[define]\nb0 = '1/n'\nc = 'c + 1/n'\nd = 'limit_weight(loop-weight, n, beta = d)'\ne = '10^9000/n'\n{}",
        names.join("\n")
    );
    for states in [
        "b59 > 0",
        "c > 0",
        "d > 0",
        "e^60 + 1/n > 0",
        "(1/n + cos(2*pi/n))^24*(2/n + cos(4*pi/n))^24 > 0",
        "(sqrt(n) + sqrt(n + 1) + sqrt(n + 2) + sqrt(n + 3))^64 > 0",
        "sqrt(n) + sqrt(n + 1) + sqrt(n + 2) + sqrt(n + 3) + sqrt(n + 5) > 0",
        "sum(i = 1..1000000, 1/(n + i)) > 0",
        "max(i = 1..500, 1/(n^2 - 2*i*n + i^2 + 1)) > 0",
        "n^65/n > 0",
        "1/n^-65 > 0",
        "cos(66*pi/n) >= -1",
        "limit_weight(loop-weight, n, beta = d) > 0",
    ] {
        let found = outcome(&file, 3, states);
        assert!(!matches!(found, Outcome::Cited(_)), "{states}");
        println!("{states}: {:?} {found:?}", start.elapsed());
    }
    assert!(start.elapsed().as_secs() < 300);
}
