//! Filters: schemes whose rules have any sums, which stand in few functions of relations and equations.

use crate::masks::relation_of;
use subcert_check::{Outcome, check};

pub const SCHEMES: &str = "
[[scheme]]
name = 'low'
let = { root = '2*cos(pi/6)' }
symbol = '((1 + root) + (3 + root)*z + (3 - root)*z^2 + (1 - root)*z^3)/4'
[[scheme]]
name = 'high'
filter = true
symbol = 'z^3*symbol(low, -z^-1)'
[[scheme]]
name = 'alias'
use = 'high'
[[scheme]]
name = 'difference'
filter = true
symbol = '1 - z'
[[scheme]]
name = 'third'
filter = true
arity = '3'
symbol = 'z^-1*(1 - z)^2*(2 + z)'
[[scheme]]
name = 'stable'
filter = true
symbol = 'z^2*(5*z + 7)'
[[scheme]]
name = 'shift'
filter = true
symbol = 'z^-4'
[[scheme]]
name = 'constant'
filter = true
symbol = '5'
[[scheme]]
name = 'half'
filter = true
symbol = '(1 + z)/2'
[[scheme]]
name = 'made'
symbol = '2*symbol(half)^2/z'
[[scheme]]
name = 'hat'
symbol = '(1 + z)^2/(2*z)'
[[scheme]]
name = 'lean'
filter = true
symbol = '1 - w*z'
parameters.w = {}
[[scheme]]
name = 'pure'
filter = true
symbol = 'w*z'
parameters.w = {}
[[scheme]]
name = 'no-filter'
filter = false
symbol = '1 + z'
[[scheme]]
name = 'five-high'
filter = true
symbol = '(1 - z)^5*(1 + 3*z)'
";

pub fn outcome(fields: &str, states: &str, lines: &str) -> Outcome {
    let lines = format!("states {states}\n {lines}");
    relation_of(SCHEMES, &format!("{fields}states = '{states}'"), &lines)
}

#[test]
fn values() {
    for states in [
        "vanishing_moments(high) = 2",
        "vanishing_moments(alias) = 2",
        "vanishing_moments(difference) = 1",
        "vanishing_moments(third) = 2",
        "vanishing_moments(five-high) = 5",
        "vanishing_moments(shift) = 0",
        "vanishing_moments(low) = 0",
        "vanishing_moments(scheme = lean, w = 1) = 1",
        "vanishing_moments(scheme = lean, w = 2) = 0",
        "arity(high) = 2",
        "arity(third) = 3",
        "coefficient(third, -1) = 2",
        "coefficient(third, 2) = 1",
        "coefficient(third, 3) = 0",
        "symbol_at(third, 2) = 2",
        "orthogonal(high)",
        "orthogonal(low)",
        "orthogonal(difference)",
        "not orthogonal(half)",
        "not biorthogonal(low, with = high)",
        "biorthogonal(high, with = alias)",
        "same(high, with = alias)",
        "not same(low, with = high)",
        "same(made, with = hat)",
        "not same(half, with = difference)",
        "symmetric(half)",
        "not symmetric(difference)",
        "hurwitz(half)",
        "hurwitz(stable)",
        "hurwitz(constant)",
        "hurwitz(shift)",
        "not hurwitz(difference)",
        "not hurwitz(high)",
        "modulus(high, 0) = 0",
        "modulus(high, 1/2) = 2",
        "modulus(high, 1/4) = sqrt(2)",
        "modulus(stable, 1/4)^2 = 74",
        "modulus_lower(stable) = 2",
        "modulus_upper(stable) = 12",
        "modulus_lower(high) = 0",
        "modulus_upper(high) = 2",
        "modulus_upper(third) = 3*sqrt(3)",
        "modulus_lower(shift)*modulus_upper(shift) = 1",
        "modulus_lower(constant) = 5",
        "contraction(made) = 1/2",
        "sum_rules(made) = 2",
        "sum_rules(no-filter) = 1",
        // A symmetric symbol in sines.
        "modulus(difference, 1/5) = 2*cos(3*pi/10)",
        "modulus(difference, 1/2) = 2",
    ] {
        assert_eq!(outcome("", states, "holds 1"), Outcome::Valid, "{states}");
        let (formula, other) = match states.split_once(['=', '~']) {
            Some((left, right))
                if !states.contains(" with = ") && !states.contains("scheme = ") =>
            {
                (left, format!("{left} = {right} + 1"))
            }
            _ => (
                states,
                if let Some(rest) = states.strip_prefix("not ") {
                    rest.into()
                } else {
                    format!("not ({states})")
                },
            ),
        };
        assert_ne!(outcome("", &other, "holds 1"), Outcome::Valid, "{formula}: {other}");
    }
    // Of the scheme of the claim.
    for (states, holds) in
        [("vanishing_moments() = 2", true), ("modulus(1/2) = 2", true), ("sum_rules() = 0", false)]
    {
        let found = outcome("scheme = 'high'\n", states, "holds 1");
        assert_eq!(found == Outcome::Valid, holds, "{states}: {found:?}");
    }
}

#[test]
fn equations() {
    for (left, right, holds) in [
        ("modulus(high, 1/2)", "2", true),
        ("modulus(high, 1/4)", "sqrt(2)", true),
        ("vanishing_moments(five-high)", "5", true),
        ("coefficient(lean, 1, w = x)", "-x", true),
        ("symbol_at(lean, 3, w = x)", "1 - 3*x", true),
        ("coefficient(pure, 1, w = x)", "x", true),
        ("modulus(high, 1/2)", "1", false),
        ("sum_rules(half)", "1", false),
        ("norm(half)", "1/2", false),
        ("vanishing_moments(lean, w = x)", "0", false),
    ] {
        let claims = format!(
            "key = 'k'\n{SCHEMES}\n[[equation]]\nid = 'e'\nsymbols = ['x']\nleft = '{left}'\nright = '{right}'\n"
        );
        let certificate = format!(
            "subcert-certificate 4\npaper k\nequation e\n  left {left}\n  right {right}\n  holds 1\nend 1\n"
        );
        let report = check(&claims, &[&certificate]).expect("a claim file");
        assert_eq!(report.claims[0].2 == Outcome::Valid, holds, "{left}: {:?}", report.claims[0].2);
    }
}

#[test]
fn families() {
    for (of, only, states, lines) in [
        ("v = 1", true, "vanishing_moments(lean, w = v) = 1", "holds reals"),
        ("v = -1", true, "symmetric(lean, w = v)", "fails reals\n true 0"),
        ("v < 0", true, "hurwitz(lean, w = v)", "fails reals\n true 0"),
        ("v <= 0", true, "hurwitz(lean, w = v)", "holds reals"),
        ("real v", false, "orthogonal(lean, w = v)", "fails reals\n false 0"),
        ("v != 0", false, "arity(pure, w = v) = 2", "holds reals"),
        ("v != 0", false, "symmetric(pure, w = v)", "holds reals"),
        ("0 < v < arity(high)", false, "v*modulus(high, 1/4)^2 < 4", "holds reals"),
    ] {
        let only = if only { "only = true\n" } else { "" };
        let fields = format!("for = '{of}'\n{only}");
        assert_eq!(outcome(&fields, states, lines), Outcome::Valid, "{of}: {states}");
        let other = if lines == "holds reals" { "fails reals\n false 1" } else { "holds reals" };
        assert_ne!(outcome(&fields, states, other), Outcome::Valid, "{of}: {states}");
    }
    // For 0 it is no filter.
    for states in
        ["arity(pure, w = v) = 2", "vanishing_moments(pure, w = v) = 0", "symmetric(pure, w = v)"]
    {
        let found = outcome("for = 'real v'\n", states, "holds reals");
        assert!(matches!(found, Outcome::Incomplete(Some(_))), "{states}: {found:?}");
    }
}
