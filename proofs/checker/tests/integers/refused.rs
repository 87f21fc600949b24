//! What is true of the first 24 integers, or of all but some, is not shown for all.

use super::{is_incomplete, is_open, outcome, outcome_of};
use subcert_check::Outcome;

/// Something else is true of an integer that is not among the first ones.
#[test]
fn true_at_first() {
    for states in [
        "1/n > 1/28",
        "n < 28 + 0/n",
        "n*n/n < 1000",
        "cos(2*pi/n) > 1 - 19.7/n^2",
        "floor(n/28) = 0",
        "floor(n/27) = 0",
        "ceil(n/1000) = 1",
        "max(n, 27) = 27",
        "abs(n - 27)/n = (27 - n)/n",
        "kronecker(n, 27)/n = 0",
        "ceil(n + 1/n) = n + 1",
        "kronecker(n, 1000)/n = 0",
        "mod(n, 27) = n",
        "mod(n, 1000) = n",
        "1/(n - 1000) < 1",
        "1/(n - 30) + 1/(30 - n) = 0",
        "(n - 30)/(n - 30) = 1",
        "sqrt(1000 - n) >= 0",
        "sqrt(26 - n) >= 0",
        "sqrt((n - 28)^2) = 28 - n",
        "sqrt(n^2 + 1) < n + 1/8 - max(n - 26, 0)",
        "(n - 27)^2*(n - 28)^2/n > 0",
        "sqrt(n) < 6",
        "sqrt(n)*sqrt(n) - n + max(n, 26) = 26",
        "cos(pi*n) in {-1, 1}",
        "cos(pi*kronecker(n, 30)/n) = 1",
        "2^n > n",
        "sum(i = 1..n, i) = n*(n + 1)/2",
        "sum(i = 0..floor(n/27), 1) = 1",
        "n^kronecker(n, 40) = 1",
        "1/n != 1/30",
        "1/n in {1/n - kronecker(n, 50)}",
        "min(26, n) = n",
        "eigenvalue(loop, n, 1, 1) < 3/8 + 0.2496",
        "limit_weight(catmull-clark, n) < 28/33",
        "subdominant(loop, n) < 0.6205",
        "limit_weight(doo-sabin, n) > 1/1000",
        "curvature(loop, n, part = hyperbolic) < 1.59",
    ] {
        let least = if states.contains("1.6") { 5 } else { 3 };
        let found = outcome("", least, states);
        assert_ne!(found, Outcome::Valid, "{states}");
        let found = outcome_of("", &format!("'all n >= {least}'"), states, "tried 24");
        let fails = ["26 - n)", "n - 27)^2*", "- max(n", "loop", "/28", "sqrt(n) < 6"];
        if !fails.iter().any(|part| states.contains(part)) {
            assert!(is_open(&found), "{states}: {found:?}");
        }
    }
}

/// What is false in one of the first cases.
#[test]
fn false_at_first() {
    for states in [
        "limit_weight(catmull-clark, n) = n/(n + 6)",
        "limit_weight(catmull-clark, n, orbit = edge) = 4/(n*(n + 6))",
        "limit_weight(catmull-clark, n, orbit = face) = 4/(n*(n + 5))",
        "limit_weight(doo-sabin, n) = 1/(n + 1)",
        "limit_weight(loop, n) = 1/(1 + (8/3)*(5/8 - (3/8 + cos(2*pi/n)/8)^2))",
        "subdominant(loop, n) = 3/8 + cos(4*pi/n)/4",
        "subdominant(loop, n) > 5/8",
        "eigenvalue(loop, n, 2, 1) > eigenvalue(loop, n, 1, 1)",
        "eigenvalue(loop, n, 2, 1) < eigenvalue(loop, n, 1, 1)",
        "eigenvalue(catmull-clark, n, 0, 1) = 3/2",
        "tangent_weight(loop, n, 2, orbit = edge) = cos(2*pi/n)",
        "sqrt(n^2 + 1) = n",
        "cos(2*pi/n) >= 1 - 20/n^3",
        "1/n >= 1/n + 1/10^50",
    ] {
        let found = outcome("", 3, states);
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

/// Claims of which the rules do not speak.
#[test]
fn other_claims() {
    for (of, states) in [
        ("['all n', 'all m']", "1/n + 1/m > 0"),
        ("'all n'", "1/n ≈ 0.33"),
        ("['all n', 'k = 1..n']", "k/n > 0"),
    ] {
        assert_ne!(outcome_of("", of, states, "holds all"), Outcome::Valid, "{states}");
    }
    let fields = "symbols = ['w']\nfor = 'all n'\nstates = 'w/n = w/n'";
    let found = crate::masks::relation_of("", fields, "states w/n = w/n\n holds all");
    assert_ne!(found, Outcome::Valid);
    // Undecided.
    for states in ["1/(n^2 - 2000*n + 1000001) > 0", "kronecker(n, 40)/n = 0"] {
        assert!(is_incomplete(&outcome("", 3, states)), "{states}");
    }
}
