//! How smooth the limits of families are, by lines about the first scheme.

use super::{SCHEMES, is_incomplete, schemes};
use crate::masks::relation_of;
use subcert_check::Outcome;

const SPLINE: &str = "limits spline:k=1\n order 2\n product 1\n eigenvalue positive 2\n at-most 2\n unit 1\n image\n image\n continuous 0\n not-continuous 1\n end";
const TERNARY: &str = "limits ternary:k=1\n order 2\n product 2\n eigenvalue positive 3\n at-most 3\n unit 1\n image\n image\n image\n continuous 0\n not-continuous 1\n end";
const SMOOTHED: &str = "limits smoothed:k=0\n order 4\n product 0\n eigenvalue positive 4\n at-most 4\n unit 1\n image\n image\n image\n image\n continuous 1\n not-continuous 2\n end";

fn after(lines: &str, of: &str, states: &str) -> Outcome {
    let fields = format!("for = '{of}'\nstates = '{states}'");
    let lines = if lines.is_empty() { String::new() } else { format!("{lines}\n ") };
    relation_of(&schemes(&SCHEMES), &fields, &format!("{lines}states {states}\n holds all"))
}

#[test]
fn values() {
    for (lines, of, formula, value) in [
        (SPLINE, "all n", "smoothness(spline, k=n)", "n - 1"),
        (SPLINE, "all n", "hoelder(spline, k=n)", "n"),
        (TERNARY, "all n", "smoothness(ternary, k=n)", "n - 1"),
        (TERNARY, "all n", "hoelder(ternary, k=n)", "n"),
        (SMOOTHED, "all n >= 0", "smoothness(smoothed, k=n)", "n + 1"),
        (SMOOTHED, "all n >= 0", "hoelder(smoothed, k=n)", "n + 2"),
    ] {
        let states = format!("{formula} = {value}");
        let found = after(lines, of, &states);
        assert_eq!(found, Outcome::Valid, "{states}");
        assert!(is_incomplete(&after("", of, &states)), "{states}");
        for opposite in ["{f} = {v} + 1", "{f} > {v}", "{f} < {v}", "{f} != {v}"] {
            let states = opposite.replace("{f}", formula).replace("{v}", value);
            assert!(matches!(after(lines, of, &states), Outcome::Invalid(..)), "{states}");
        }
    }
}

#[test]
fn what_is_not_known() {
    let hs = SMOOTHED.replace("smoothed:k=0", "hs:k=4");
    let hat = SPLINE.replace("spline:k=1", "hat:k=1");
    let enclosed = SPLINE.replace(" not-continuous 1\n", "").replace("at-most 2", "at-most 3");
    for (lines, of, states) in [
        // The coefficients of a factor depend on the index, so that the limits do not gain one order each time.
        (&hs[..], "all n >= 4", "smoothness(hs, k=n) = n - 3"),
        (&hs, "all n >= 4", "hoelder(hs, k=n) = n - 2"),
        // The lines are about another integer.
        (SPLINE, "all n >= 2", "smoothness(spline, k=n) = n - 1"),
        (SPLINE, "all n >= 0", "smoothness(spline, k=n) = n - 1"),
        (SMOOTHED, "all n", "smoothness(smoothed, k=n) = n + 1"),
        (TERNARY, "all n", "smoothness(spline, k=n) = n - 1"),
        // One factor is no power of σ.
        (SPLINE, "all n", "smoothness(mixed, k=n) = n"),
        // Bounds alone.
        (&enclosed, "all n", "hoelder(spline, k=n) = n"),
    ] {
        let found = after(lines, of, states);
        assert!(is_incomplete(&found), "{states}: {found:?}");
    }
    // The same mask under another name is enough.
    assert_eq!(after(&hat, "all n", "smoothness(spline, k=n) = n - 1"), Outcome::Valid);
    // A line that does not hold.
    let wrong = SPLINE.replace("at-most 2", "at-most 1");
    let found = after(&wrong, "all n", "smoothness(spline, k=n) = n - 1");
    assert!(matches!(found, Outcome::Invalid(..)));
}

/// The scheme of a claim, with two steps at a time.
#[test]
fn two_steps() {
    for (states, holds) in [
        ("smoothness() = 2*n", true),
        ("hoelder() = 2*n + 1", true),
        ("smoothness() = n", false),
        ("hoelder() - smoothness() = 1", true),
    ] {
        let fields =
            format!("scheme = 'spline:k=2*n + 1'\nfor = 'all n >= 0'\nstates = '{states}'");
        let lines = format!("{SPLINE}\n states {states}\n holds all");
        let found = relation_of(&schemes(&SCHEMES), &fields, &lines);
        assert_eq!(found == Outcome::Valid, holds, "{states}: {found:?}");
    }
}
