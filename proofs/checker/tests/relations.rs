//! What relations state: signs, sets, printed numbers, and the ranges of their indices.

use crate::masks::relation;
use subcert_check::Outcome;

/// Whether a certificate with these lines is valid of a statement for these indices.
fn valid(states: &str, of: &str, lines: &str) -> bool {
    let indices = if of.is_empty() { String::new() } else { format!("for = {of}\n") };
    let fields = format!("symbols = ['w', 'q']\nstates = '{states}'\n{indices}");
    relation(&fields, &format!("states {states}\n {lines}")) == Outcome::Valid
}

#[test]
fn signs() {
    for (states, holds) in [
        ("1/2 = 2/4", true),
        ("1/2 = 2/5", false),
        ("1 != 2", true),
        ("1 ≠ 1", false),
        ("1 < 2", true),
        ("1 < 1", false),
        ("1 ≤ 1", true),
        ("1 <= 0", false),
        ("2 > 1", true),
        ("1 > 1", false),
        ("1 ≥ 1", true),
        ("0 >= 1", false),
        ("2*cos(pi/6) > 1.7320508", true),
        ("2*cos(pi/6) ≥ 1.7320509", false),
        ("2*cos(pi/6)^2 = 3/2", true),
        // Square roots in two fields are equal, though written otherwise.
        ("2*cos(2*pi/5) = 2*cos(2*pi/15)*0 + 2*cos(6*pi/15)", true),
        ("w*(w + 1) = w^2 + w", true),
        ("q[1]*w = w*q[1]", true),
        ("kronecker(1, 1)", true),
        ("not kronecker(1, 2)", true),
        ("not(kronecker(1, 1))", false),
        ("kronecker(1, 2)", false),
        ("(1 + 1) in {1, 2}", true),
        ("3 in {1, 2}", false),
        ("2*cos(pi/6) in {1.73, 2*cos(11*pi/6)}", true),
    ] {
        let difference = |lines: &str| valid(states, "", lines);
        assert_eq!(difference("holds 1"), holds, "{states}");
        assert!(!difference(if holds { "fails 1" } else { "fails 1\n case = 77" }), "{states}");
    }
}

#[test]
fn printed_numbers() {
    for (states, holds) in [
        ("1/3 ≈ 0.33", true),
        ("1/3 ~ 0.34", true),
        ("1/3 ≈ 0.35", false),
        ("0.33 ≈ 1/3 + 0", true),
        ("1/3 ≈ 1/3", true),
        // The right one counts if both are printed, but for a fraction beside a decimal.
        ("0.3333 ≈ 1/3", true),
        ("0.34 ≈ 0.3", true),
        ("0.3 ≈ 0.34", false),
        ("sum(i = 1..3, 1/i) ≈ 1.83", true),
        ("1949 ≈ 1.9e3", true),
        ("2*10^3 ≈ 1.9e3", false),
        ("-1/3 ≈ −0.33", true),
        ("0.33 ≈ 1/3 + 0 ~ 0.333", true),
    ] {
        let count = states.matches(['≈', '~']).count();
        assert_eq!(valid(states, "", &format!("holds {count}")), holds, "{states}");
    }
}

#[test]
fn intervals() {
    for (set, inside) in [
        ("[0, 1]", [true, true, true]),
        ("[0, 1)", [true, true, false]),
        ("(0, 1]", [false, true, true]),
        ("(0, 1)", [false, true, false]),
    ] {
        for (x, inside) in ["0", "1/2", "1"].iter().zip(inside) {
            assert_eq!(valid(&format!("{x} in {set}"), "", "holds 2"), inside, "{x} in {set}");
        }
    }
    // Signs within brackets belong to what stands there.
    assert!(valid("max(j = 1..3, j) in [min(1, 2), (1 + 1)*2)", "", "holds 2"));
    assert!(valid("contraction(1, scheme = two, order = forward) in {1/2, 1/3}", "", "holds 1"));
}

#[test]
fn indices() {
    for (of, count) in [
        ("'n = 1..3'", "holds 3"),
        ("'n = 2^2 .. 2^3'", "holds 5"),
        ("'n = 1, 5/2, 0.5'", "holds 3"),
        ("'n = 7'", "holds 1"),
        ("['n = 1..3', 'm = n..2*n']", "holds 9"),
        ("['n = ½, 1½']", "holds 2"),
        ("'all n'", "holds all"),
        ("'all n >= 4'", "holds all"),
        ("'all n≥-4'", "holds all"),
        ("['m = 1, 2', 'all  n']", "holds all"),
        ("['all n', 'all m >= 0']", "holds all"),
    ] {
        assert!(valid("n + 1 > n", of, count), "{of}");
    }
    for of in [
        "'n'",
        "'all n > 4'",
        "'all n >= 1/2'",
        "'all n <= 4'",
        "'n = 1...3'",
        "'n = 1..m'",
        "'n = a'",
        "'n = '",
        "'n = 1;2'",
        "['m = 1..n', 'n = 1..2']",
    ] {
        for count in ["holds all", "holds 1", "holds 2", "holds 3", "tried 24"] {
            assert!(!valid("n + 1 > n", of, count), "{of}");
        }
    }
}

/// What is written otherwise than the grammar says has no meaning.
#[test]
fn what_is_no_statement() {
    for states in [
        "1 = 1 =",
        "= 1",
        "1 == 1",
        "1 in {1} = 1",
        "1 in {}",
        "1 in [0, 1, 2]",
        "1 in [1}",
        "1 in {1} in {1}",
        "not 0 = 0",
        "not 1 in {2}",
        "not",
        "",
        "1 =< 1",
        "x = x",
        "2",
        "1/2",
        "not 2",
        "w",
        "w ≠ w + 1",
        "w in {w}",
        "1/0 = 1/0",
        "1 ≈ 1 + 0 ≈ 2 - 1 + 0 ≈ 1 + 0",
    ] {
        for lines in ["holds 1", "holds 2", "holds 3", "fails 1", "fails 1\n case = 0"] {
            assert!(!valid(states, "", lines), "{states}: {lines}");
        }
    }
}

/// Polynomials in an index: their signs from some number on, and before.
#[test]
fn all_integers() {
    for (states, holds) in [
        ("n^2 + 1 > n", true),
        ("n^2 > n", false),
        ("n^2 ≥ n", true),
        ("(n - 5)*(n - 7) ≥ -1", true),
        ("(n - 5)*(n - 7) ≥ 0", false),
        ("(2*n - 11)^2 > 0", true),
        ("(2*n - 11)*(n - 7) > 0", false),
        ("(n - 1/2)*(n - 100) ≠ 1/3", true),
        ("n ≠ 100", false),
        ("-n < 0", true),
        ("-n^3 + 10^2*n ≤ 10^3", true),
        ("n in [1, n + 1)", true),
        ("n in (1, n + 1)", false),
        ("w*n = n*w", true),
        ("w*n = w", false),
        ("n*0 = 0", true),
        ("kronecker(n, n)", true),
        ("n in {1, n}", true),
        ("n in {n + 1, n - 1}", false),
        ("cos(2*pi/5) < 1/3 + n*0", true),
        ("0.5 ≈ 1/2 + n - n", true),
        ("sum(k = 0..4, binomial(4, k)*n^k) = (1 + n)^4", true),
    ] {
        let count = if states.contains(" in [") || states.contains(" in (") { 2 } else { 1 };
        assert_eq!(valid(states, "'all n'", "holds all"), holds, "{states}");
        assert!(!valid(states, "'all n'", &format!("holds {}", 24 * count)), "{states}");
        assert!(!valid(states, "'all n'", "fails all"), "{states}");
    }
    assert!(valid("n^2 > n", "'all n'", "fails all\n case 1 = 0"));
    assert!(valid("n in (1, n + 1)", "'all n'", "fails all\n case 1 1 = 0"));
    assert!(!valid("n in (1, n + 1)", "'all n'", "fails all\n case 1 2 = -1"));
    // What the index of a mask or of a sum would be is not decided by polynomials.
    for states in [
        "sum(k = 1..n, 1) = n",
        "floor(n) = n",
        "coefficient(two, n) ≤ 1",
        "max(n, 0) = n",
        "n^n > 0",
        "1/n > 0",
        "abs(n) = n",
        "2^n > 0",
    ] {
        assert!(!valid(states, "'all n'", "holds all"), "{states}");
    }
}
