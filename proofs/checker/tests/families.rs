//! Families of symbols: values for all integers from one on.

mod limits;
mod refused;

use crate::masks::relation_of;
use subcert_check::{Outcome, Reason};

/// Schemes with a parameter `k`, each with a name and a symbol.
fn schemes(list: &[(&str, &str)]) -> String {
    let table = |(name, symbol): &(&str, &str)| {
        format!("[[scheme]]\nname = '{name}'\nparameters.k = {{}}\nsymbol = '{symbol}'\n")
    };
    list.iter().map(table).collect()
}

const SCHEMES: [(&str, &str); 16] = [
    ("hat", "(1 + z)^2/2 + 0*k"),
    ("spline", "(1 + z)^(k + 1)/2^k"),
    ("hs", "2*((1 + z)/2)^k*(-k/8 + (1 + k/4)*z - k/8*z^2)/z"),
    ("ternary", "(1 + z + z^2)^(k + 1)/3^k"),
    ("mixed", "(1 + z)^(k + 1)*(1 + z^2)^(k + 2)/2^(2*k + 1)"),
    ("crossing", "(1 + z)^(2*k)*(1 + z^2)^(k + 3)/2^(3*k + 1)"),
    ("vanishing", "2*((1 + z)/2)^(k + 2)*((k - 5) + (11 - 2*k)*z + (k - 5)*z^2)"),
    ("divided", "(1 + z)^(k + 1)/2^k*((1 + 2*(k - 4)/3)/2 + (1 - 2*(k - 4)/3)/2*z)"),
    ("cumulant", "2*((1 + z)/2)^4*(-k/8 + (1 + k/4)*z - k/8*z^2)/z"),
    ("shifted", "(1 + z)^2/2*z^k"),
    ("skew", "(1 + z)^(k + 1)/2^k*(2*z^2 + z)/3"),
    ("twice", "((1 + z)*(1 + 2*z)^3/27)^k*(1 + z)/2^(k - 1)/2^1*1"),
    ("signs", "-(-(1 + z)^(k + 1)/2^k)*(-1)^(2*k)"),
    ("long", "(1 + z)^(1000*k + 1)/2^(1000*k)"),
    ("smoothed", "(1 + z)^(k + 4)/2^(k + 3)*(-1 + 4*z - z^2)/2/z^3"),
    ("more", "symbol(hat, k = 0)*((1 + z)/2)^k"),
];

/// The outcome of a statement with these lines, for `all n` or such.
fn outcome(of: &str, states: &str, lines: &str) -> Outcome {
    let fields = format!("states = '{states}'\nfor = '{of}'");
    relation_of(&schemes(&SCHEMES), &fields, &format!("states {states}\n {lines}"))
}

fn is_open(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Incomplete(Some(rejection)) if rejection.reason == Reason::Open)
}

fn is_incomplete(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Incomplete(_))
}

/// Values for all integers. The first 24 of them are computed by definition too.
#[test]
fn values() {
    for (of, formula, value) in [
        ("all n", "arity(spline, k=n)", "2"),
        ("all n", "sum_rules(spline, k=n)", "n + 1"),
        ("all n", "generation(spline, k=n)", "n"),
        ("all n", "support(spline, k=n)", "n + 1"),
        ("all n", "support_start(spline, k=n)", "0"),
        ("all n", "support_end(spline, k=n)", "n + 1"),
        ("all n", "reproduction(spline, k=n)", "1"),
        ("all n >= 0", "reproduction(spline, k=n)", "min(1, 0)*n + 1"),
        ("all n", "approximation_order(spline, k=n)", "2"),
        ("all n", "approximation_order(spline, k=n, data=adapted)", "n + 1"),
        ("all n", "symmetric(spline, k=n)", "1"),
        ("all n >= 4", "reproduction(hs, k=n)", "3"),
        ("all n >= 4", "approximation_order(hs, k=n)", "4"),
        ("all n >= 4", "support(hs, k=n)", "n + 2"),
        ("all n >= 4", "support_start(hs, k=n)", "-1"),
        ("all n >= 4", "support_end(hs, k=n)", "n + 1"),
        ("all n >= 4", "sum_rules(hs, k=n)", "n"),
        ("all n >= 4", "symmetric(hs, k=n)", "1"),
        ("all n", "arity(ternary, k=n)", "3"),
        ("all n", "sum_rules(ternary, k=n)", "n + 1"),
        ("all n", "support(ternary, k=n)", "n + 1"),
        ("all n", "reproduction(ternary, k=n)", "1"),
        ("all n", "arity(mixed, k=n)", "4"),
        ("all n", "sum_rules(mixed, k=n)", "n + 1"),
        ("all n", "support(mixed, k=n)", "n + 5/3"),
        ("all n >= 3", "sum_rules(crossing, k=n)", "n + 3"),
        ("all n >= 6", "support(vanishing, k=n)", "n + 4"),
        ("all n >= 5", "sum_rules(divided, k=n)", "n + 1"),
        ("all n >= 5", "reproduction(cumulant, k=n)", "1"),
        ("all n", "support_start(shifted, k=n)", "n"),
        ("all n >= -12", "support_start(shifted, k=n)", "n"),
        ("all n", "support(shifted, k=n)", "2"),
        ("all n", "support(skew, k=n)", "n + 2"),
        ("all n", "sum_rules(signs, k=n)", "n + 1"),
        ("all n", "support(more, k=n)", "n + 2"),
    ] {
        // The interval of reproduction of `spline` begins at k = 1: for k = 0 its degree is 0.
        let valid = of != "all n >= 0";
        let states = format!("{formula} = {value}");
        let found = outcome(of, &states, "holds all");
        assert_eq!(found == Outcome::Valid, valid, "{of}: {states}: {found:?}");
        if !valid {
            assert!(is_incomplete(&found), "{states}");
            continue;
        }
        assert!(is_open(&outcome(of, &states, "tried 24")), "{of}: {states}");
        for lines in ["holds 24", "fails all", "holds", "fails 24"] {
            assert_ne!(outcome(of, &states, lines), Outcome::Valid, "{states}");
        }
        for opposite in ["{f} = {v} + 1", "{f} < {v}", "{f} != {v}", "{f} > {v}", "{f} = n + 77"] {
            let states = opposite.replace("{f}", formula).replace("{v}", value);
            assert_ne!(outcome(of, &states, "holds all"), Outcome::Valid, "{states}");
        }
        let more = format!("{formula} >= {value} + 1");
        let first = of.rsplit_once(' ').and_then(|(_, n)| n.parse::<i64>().ok()).unwrap_or(1);
        let lines = format!("fails all\n case {first} = -1");
        assert_eq!(outcome(of, &more, &lines), Outcome::Valid, "{more}");
    }
    // What a number cannot have by its caps: 1,000 factors at least.
    assert_eq!(outcome("all n", "sum_rules(long, k=n) = 1000*n + 1", "holds all"), Outcome::Valid);
}

/// Comparisons with other signs, sets, several functions, and formulas alone.
#[test]
fn statements() {
    for (states, holds) in [
        ("sum_rules(spline, k=n) > n", true),
        ("sum_rules(spline, k=n)^2 >= 4*n", true),
        ("sum_rules(spline, k=n)^2 > 4*n", false),
        ("support(spline, k=n) in [2, n + 1]", true),
        ("support(spline, k=n) in {n, n + 1}", true),
        ("support(spline, k=n) - sum_rules(spline, k=n)", false),
        ("symmetric(spline, k=n)", true),
        ("not symmetric(spline, k=n)", false),
        ("sum_rules(spline, k=n) - sum_rules(ternary, k=n) = 0", true),
        ("sum_rules(hat, k=n) = 2", true),
    ] {
        let holds_all = outcome("all n", states, "holds all") == Outcome::Valid;
        assert_eq!(holds_all, holds, "{states}");
    }
}

/// The scheme of a claim, in each case of the other indices, and what definitions say of it.
#[test]
fn schemes_of_claims() {
    let file = format!(
        "[define]\ns = 'sum_rules()'\nj1 = 'n + 1'\n{}[[scheme]]\nname = 'alias'\nuse = 'spline:k=a + 1'\n",
        schemes(&SCHEMES)
    );
    for (scheme, indices, states, holds) in [
        ("spline:k=n + j", "['j = 1..3', 'all n']", "s = n + j + 1", true),
        ("spline:k=n + j", "['j = 1..3', 'all n']", "s = n + 2", false),
        ("spline:k=2*n", "'all n'", "s = 2*n + 1", true),
        ("alias:a=n", "'all n'", "s = n + 2", true),
        ("alias:a=n", "'all n'", "support() = n + 2", true),
        ("spline:k=n - n + 1", "'all n'", "coefficient(1) = 1", true),
        ("spline:k=n", "'all n'", "sum_rules(spline, k=j1) = s + 1", true),
        ("spline:k=n", "'all n'", "1 = 1", true),
        ("crossing:k=n", "'all n'", "1 = 1", false),
        ("spline:k=n/2", "'all n'", "s = n/2 + 1", false),
        ("spline:k=n^2", "'all n'", "s = n^2 + 1", false),
        ("spline:k=n x hat:k=0", "'all n'", "s = n + 1", false),
        ("hat:k=0 x spline:k=n", "'all n'", "s = 2", false),
        ("b-spline:degree=n", "'all n'", "s = n + 1", false),
        ("spline:k=n", "['all n', 'all m']", "s = n + 1", false),
        ("spline:k=n", "'all n'", "coefficient(0) = 1", false),
        ("spline:k=n", "'all n'", "0.33 ≈ 1/3 + 0", false),
    ] {
        let fields = format!("scheme = '{scheme}'\nfor = {indices}\nstates = '{states}'");
        let found = relation_of(&file, &fields, &format!("states {states}\n holds all"));
        assert_eq!(found == Outcome::Valid, holds, "{scheme}: {states}: {found:?}");
    }
    let fields = "symbols = ['w']\nfor = 'all n'\nstates = 'w*support(spline, k=n) = w*n + w'";
    let lines = "states w*support(spline, k=n) = w*n + w\n holds all";
    assert!(is_incomplete(&relation_of(&file, fields, lines)));
}
