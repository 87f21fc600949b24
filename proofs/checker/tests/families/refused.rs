//! Families without values: what the rules do not show for all integers is left open, whatever is true of most of them.

use super::{is_incomplete, is_open, outcome, schemes};
use crate::masks::relation_of;
use std::time::Instant;
use subcert_check::Outcome;

/// Something else is true of one integer, or of the first ones.
#[test]
fn false_at_one_integer() {
    for (of, states, lines) in [
        ("all n", "support(vanishing, k=n) = n + 4", "case 5 = -2"),
        ("all n", "sum_rules(divided, k=n) = n + 1", "case 4 = 1"),
        ("all n", "reproduction(cumulant, k=n) = 1", "case 4 = 2"),
        ("all n", "sum_rules(crossing, k=n) = n + 3", "case 2 = -1"),
        ("all n >= 2", "reproduction(hs, k=n) = 3", "case 2 = -2"),
        ("all n", "width(vanishing, k=n) = floor(5/2) + n", "case 1 = 0"),
    ] {
        let found = outcome(of, states, "holds all");
        assert!(is_incomplete(&found), "{states}: {found:?}");
        let fails = outcome(of, states, &format!("fails all\n {lines}"));
        let expected = !lines.ends_with("= 0");
        assert_eq!(fails == Outcome::Valid, expected, "{states}: {fails:?}");
    }
    // What is false everywhere.
    for states in ["support(spline, k=n) = n + 2", "sum_rules(spline, k=n) < n + 1"] {
        assert!(matches!(outcome("all n", states, "holds all"), Outcome::Invalid(..)), "{states}");
    }
}

/// Symbols that do not keep the conditions.
#[test]
fn symbols() {
    let holds = |table: &str, states: &str| {
        let table = format!("{}[[scheme]]\nname = 's'\nparameters.k = {{}}\n{table}", helpers());
        let fields = format!("for = 'all n'\nstates = '{states}'");
        let lines = format!("states {states}\n ");
        let found = relation_of(&table, &fields, &format!("{lines}holds all"));
        let tried = relation_of(&table, &fields, &format!("{lines}tried 24"));
        (found == Outcome::Valid, is_incomplete(&found), is_open(&tried))
    };
    // The last one says whether the statement is true of the first 24 integers.
    for (table, states, tried) in [
        // A negative exponent of several terms.
        ("symbol = '(1 + z)^(9 - k)/2^(8 - k)'", "arity(s, k=n) = 2", false),
        ("symbol = '(1 + z)^(k - 2)/2^(k - 3)'", "arity(s, k=n) = 2", false),
        // None of these divisors has a quotient.
        ("symbol = '2/2^k/(1 + z)^(-k)'", "support(s, k=n) = n", false),
        ("symbol = '2/2^k*(1/(1 + z)^k)^(-1)'", "support(s, k=n) = n", false),
        ("symbol = '2/2^k*((1 + z)^(-1))^(-k)'", "support(s, k=n) = n", false),
        // Sums that depend on the index.
        ("symbol = '(1 + z)^(k + 1)/2^k*(k + z)/(k + 1)'", "support(s, k=n) = n + 2", true),
        ("symbol = '(1 + z)^(k + 1)'", "support(s, k=n) = n + 1", false),
        ("symbol = '(1 + z)^(k + 1)/3^k'", "support(s, k=n) = n + 1", false),
        ("symbol = '(-1)^k*(1 + z)^(k + 1)/2^k'", "support(s, k=n) = n + 1", false),
        ("symbol = '(1 + z)^(k + 1)/2^k*(1 - z)'", "support(s, k=n) = n + 2", false),
        // No arity, or another one.
        ("symbol = '(1 + z)^(k + 1)/2^(k + 1)'", "support(s, k=n) = n + 1", false),
        ("symbol = '3*((1 + z)/2)^k'", "support(s, k=n) = n/2", false),
        ("arity = '3'\nsymbol = '(1 + z)^(k + 1)/2^k'", "arity(s, k=n) = 3", false),
        ("arity = 'k'\nsymbol = '(1 + z)^(k + 1)/2^k'", "arity(s, k=n) = n", false),
        ("symbol = '65*((1 - z^65)/(1 - z)/65)^k'", "arity(s, k=n) = 65", false),
        // Exponents that are no αt + β.
        ("symbol = '(1 + z)^(k^2 + 1)/2^(k^2)'", "support_start(s, k=n) = 0", false),
        ("symbol = '((1 + z)^k/2^k)^k*(1 + z)'", "support_start(s, k=n) = 0", false),
        ("symbol = '(1 + z)^((k^2 + k)/2)/2^((k^2 + k)/2 - 1)'", "arity(s, k=n) = 2", false),
        ("symbol = '(((1 + z)/2)^(k/2))^2*2'", "support(s, k=n) = n", false),
        // No rule speaks of sums of powers, of functions, or of other schemes that depend on the index.
        ("symbol = '((1 + z)^(k + 1) + 0*z)/2^k'", "support(s, k=n) = n + 1", true),
        ("symbol = 'product(i = 0..k, 1 + z)/2^k'", "support(s, k=n) = n + 1", true),
        ("symbol = '(1 + z)^(max(k, 1) + 1)/2^k'", "support(s, k=n) = n + 1", true),
        ("symbol = '(1 + z)^sum_rules(p, k=k)/2^k'", "support(s, k=n) = n + 1", true),
        ("symbol = 'symbol(p, k=k)'", "support(s, k=n) = n + 1", true),
        ("let = { b = 'b*(1 + z)' }\nsymbol = 'b^k'", "support(s, k=n) = n + 1", false),
        ("filter = true\nsymbol = '(1 + z)^(k + 1)/2^k'", "arity(s, k=n) = 2", true),
        ("arity = '2'\nwidth = '1'\nentry = '1 + k - k'", "arity(s, k=n) = 2", true),
    ] {
        let (valid, incomplete, is_tried) = holds(table, states);
        assert!(!valid && incomplete, "{table}: {states}");
        assert!(!tried || is_tried, "{table}: {states}");
    }
    for table in [
        "symbol = '(1 + z)^(k + 1)/2^k'",
        "arity = '2'\nsymbol = '(1 + z)^(k + 1)/2^k'",
        "let = { b = '(1 + z)^k', c = '1 + z' }\nsymbol = 'c*b/2^k'",
        "symbol = '((1 + z)/2)^(k - 1)*(1 + z)*(1 + z)/2'",
        "symbol = '2*(((1 + z)/2)^(k/1))*((1 + z)/2)'",
        "symbol = 'z^(-k)*(1 + z)^(k + 1)/2^k*z^k'",
        "symbol = '(1 + z)^(2*k + 2)/2^(2*k + 1)/(1 + z)^0*z^0/1'",
    ] {
        let stated = if table.contains("2*k") { "2*n + 2" } else { "n + 1" };
        let (valid, _, tried) = holds(table, &format!("support(s, k=n) = {stated}"));
        assert!(valid && tried, "{table}");
    }
}

fn helpers() -> String {
    schemes(&[("p", "(1 + z)^(k + 1)/2^k")])
}

/// Other functions of schemes that depend on the index, which may be otherwise at some integers.
#[test]
fn other_functions() {
    for states in [
        "width(skew, k=n) = width(skew, k=n)",
        "coefficient(spline, 0, k=n)*2^1 = 2*coefficient(spline, 0, k=n)",
        "coefficient(cumulant, 100, k=n) = 0",
        "width(cumulant, k=n) = 4",
        "symbol_at(cumulant, 1, k=n) = 2",
        "interpolating(spline, k=n) in {0, 1}",
        "reproduction(spline, k=n, parameters=indexed) <= 1",
        "symmetric(skew, k=n) = 0",
        "independent(cumulant, k=n)",
        "sobolev(cumulant, k=n) > 0",
        "mask(cumulant, 0, 0, k=n) = mask(cumulant, 0, 0, k=n)",
        "contraction(spline, 1, k=n) <= 1",
        "smoothness(spline, k=n) = n - 1",
    ] {
        let found = outcome("all n", states, "holds all");
        assert!(is_incomplete(&found), "{states}: {found:?}");
    }
    for states in [
        "support(spline, k=n, data=adapted) = n + 1",
        "support(spline, j=n) = n + 1",
        "support(spline, 1, k=n) = n + 1",
        "coefficient(hat, n, k=0) <= 1",
    ] {
        assert_ne!(outcome("all n", states, "holds all"), Outcome::Valid, "{states}");
    }
    // Its middle coefficient is not 0 for n = 0, but four others are.
    let file = "[[scheme]]\nname = 'tension'\nparameters.w = {}\nsymbol = '-w*z^-3 + (1/2 + w)*z^-1 + 1 + (1/2 + w)*z - w*z^3'\n";
    let states = "width(tension, w=n) = 4";
    let fields = format!("for = 'all n >= 0'\nstates = '{states}'");
    let lines = format!("states {states}\n holds all");
    assert!(is_incomplete(&relation_of(file, &fields, &lines)));
    let lines = format!("states {states}\n fails all\n case 0 = -2");
    assert_eq!(relation_of(file, &fields, &lines), Outcome::Valid);
}

/// Integers that fit in no machine integer, or hardly, and symbols that would keep a checker busy.
#[test]
fn huge_integers() {
    let start = Instant::now();
    for power in ["2147483648", "9007199254740992", "9223372036854775808", "2^63", "10^30"] {
        for symbol in [
            "(1 + z)^(H*k + 1)/2^(H*k)",
            "(1 + z)^(k + H)/2^(k + H - 1)",
            "z^(H*k)*(1 + z)",
            "(z^1000)^(H*k)*(1 + z)",
            "1^(H*k)*(1 + z)",
            "((1 + z)^1000)^(H*k + 1)/2^(1000*H*k)",
            "((z^k)^H)^H*(1 + z)",
            "z^H*(1 + z)^k/2^(k - 1)",
            "(1 + z)*(H + z)^k/(H + 1)^k",
            "(1 + z)^(k + 1)/2^k*(k - H + (H - k + 1)*z)",
        ] {
            let symbol = symbol.replace('H', &format!("({power})"));
            let file = schemes(&[("s", &symbol)]);
            for states in ["support(s, k=n) = n + 1", "sum_rules(s, k=n) = n", "arity(s, k=n) = 3"]
            {
                let fields = format!("for = 'all n'\nstates = '{states}'");
                let found = relation_of(&file, &fields, &format!("states {states}\n holds all"));
                // The last but one has one sum rule, and the support n + 1.
                let is = symbol.starts_with("(1 + z)*((") && states.starts_with("support");
                assert_eq!(found == Outcome::Valid, is, "{symbol}: {states}: {found:?}");
            }
        }
        let states = "support(spline, k=n) = n + 1";
        for of in [format!("all n >= {power}"), format!("all n >= -{power}")] {
            assert_ne!(outcome(&of, states, "holds all"), Outcome::Valid, "{of}");
        }
        for value in [format!("{power}*n"), format!("n + {power}"), format!("n - {power}")] {
            let file = format!("[define]\nv = '{value}'\n{}", helpers());
            let states = "support(p, k=v) = v + 2";
            let fields = format!("for = 'all n'\nstates = '{states}'");
            let found = relation_of(&file, &fields, &format!("states {states}\n holds all"));
            assert_ne!(found, Outcome::Valid, "{value}");
        }
    }
    // Names that stand for products of names.
    let names: Vec<String> = (1..60).map(|i| format!("b{i} = 'b{}*b{}'", i - 1, i - 1)).collect();
    let file = format!(
        "[[scheme]]\nname = 's'\nparameters.k = {{}}\nlet = {{ b0 = '(1 + z)^k', {} }}\nsymbol = 'b59'\n",
        names.join(", ")
    );
    let fields = "for = 'all n'\nstates = 'arity(s, k=n) = 2'";
    let found = relation_of(&file, fields, "states arity(s, k=n) = 2\n holds all");
    assert!(is_incomplete(&found), "{found:?}");
    assert!(start.elapsed().as_secs() < 60);
}
