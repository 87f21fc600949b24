//! Symbols of schemes in the symbols of others.

use crate::masks::relation_of;
use std::fmt::Write as _;
use subcert_check::Outcome;

const SCHEMES: &str = r#"
[[scheme]]
name = "hat"
mask = '[1, 2, 1]/2'
[[scheme]]
name = "z"
symbol = '1 + z'
[[scheme]]
name = "tension"
symbol = '-w*z^-3 + (1/2 + w)*z^-1 + 1 + (1/2 + w)*z - w*z^3'
parameters.w = { default = '1/16' }
[[scheme]]
name = "open"
symbol = '1 + w*z + (1 - w)*z^3'
parameters.w = {}
[[scheme]]
name = "alias"
use = "tension:w=1/8"
[[scheme]]
name = "square"
let = { h = 'symbol(hat)', half = '1/2' }
symbol = 'h^2*half'
[[scheme]]
name = "wide"
use = "tension:w=w-1"
[[scheme]]
name = "later"
symbol = '1 + z'
"#;

/// Whether a scheme with this symbol has these coefficients from the power l on.
fn is(symbol: &str, l: i64, coefficients: &[&str]) -> bool {
    let schemes = format!("{SCHEMES}[[scheme]]\nname = \"own\"\nsymbol = '{symbol}'\n");
    let length = coefficients.len();
    let terms: Vec<String> = (l..)
        .zip(coefficients)
        .map(|(k, c)| format!("abs(coefficient(own, {k}) - ({c}))"))
        .collect();
    // The sum of all coefficients of the square tells whether there are others.
    let all = "sum(k = -40..40, abs(coefficient(own, k)))";
    let known: Vec<String> = coefficients.iter().map(|c| format!("abs({c})")).collect();
    let states = format!("{} + {all} = {}", terms.join(" + "), known.join(" + "));
    let found = relation_of(
        &schemes,
        &format!("states = '{states}'"),
        &format!("states {states}\n holds 1"),
    );
    assert!(length > 0);
    found == Outcome::Valid
}

#[test]
fn powers_and_factors() {
    assert!(is("symbol(hat)", -1, &["1/2", "1", "1/2"]));
    assert!(is("symbol(hat, z)", -1, &["1/2", "1", "1/2"]));
    assert!(is("symbol(scheme = hat)", -1, &["1/2", "1", "1/2"]));
    assert!(is("symbol(z, scheme = z)", 0, &["1", "1"]));
    assert!(is("symbol(1/z, scheme = z)", -1, &["1", "1"]));
    assert!(is("symbol(hat, z^3)", -3, &["1/2", "0", "0", "1", "0", "0", "1/2"]));
    assert!(is("z^3*symbol(hat, z^-3)", 0, &["1/2", "0", "0", "1", "0", "0", "1/2"]));
    assert!(is("symbol(tension, w = 0)", -1, &["1/2", "1", "1/2"]));
    assert!(is("symbol(open, z, w = -2)", 0, &["1", "-2", "0", "3"]));
    assert!(is("symbol(w = 1, scheme = open)", 0, &["1", "1"]));
    assert!(is("sum(i = 1..2, symbol(open, w = i))/2", 0, &["1", "3/2", "0", "-1/2"]));
    assert!(is("symbol(w = 1, scheme = wide)", -1, &["1/2", "1", "1/2"]));
    assert!(is("(2 - symbol(hat, -z))*z", 0, &["1/2", "1", "1/2"]));
    assert!(is("symbol(square)", -2, &["1/8", "1/2", "3/4", "1/2", "1/8"]));
    assert!(is("symbol(hat)^2/2", -2, &["1/8", "1/2", "3/4", "1/2", "1/8"]));
    assert!(is("symbol(square)*2/symbol(hat)", -1, &["1/2", "1", "1/2"]));
    assert!(is(
        "sum(i = 1..2, symbol(hat, z^(2*i - 1)))/2",
        -3,
        &["1/4", "0", "1/4", "1", "1/4", "0", "1/4"]
    ));
    assert!(is("2*product(i = 0..1, (1 + z^(i + 1))/2)", 0, &["1/2", "1/2", "1/2", "1/2"]));
    assert!(is("product(i = 1..0, z) + product(i = 1..3, z)/z^2", 0, &["1", "1"]));
    assert!(is("z*product(i = 1..2, symbol(hat)/i)", -1, &["1/8", "1/2", "3/4", "1/2", "1/8"]));
    assert!(!is("product(z = 1..1, z)*2", 1, &["2"]));
    assert!(is("symbol(tension)", -3, &["-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"]));
    assert!(is("symbol(alias)", -3, &["-1/8", "0", "5/8", "1", "5/8", "0", "-1/8"]));
    assert!(is("2 - symbol(-1/z, scheme = z)", -1, &["1", "1"]));
    // b(2z) and b(2cos(π/6)z) of 1/(2z) + 1 + z/2.
    assert!(is("(symbol(hat, 2*z) - 1)*z*4 - 4*z^2 + z", 0, &["1", "1"]));
    let root = "2*cos(pi/6)*z";
    assert!(is(&format!("(symbol(hat, {root}) - 1 - {root}/2)*2*{root} + z"), 0, &["1", "1"]));
}

#[test]
fn what_has_no_meaning() {
    for symbol in [
        "symbol(later2)",
        "symbol(own)",
        "symbol(open)",
        "symbol()",
        "symbol(z)",
        "symbol(2)",
        "symbol(hat, 0)",
        "symbol(hat, 0*z)",
        "symbol(hat, 1 + z)",
        "symbol(hat, z, z)",
        "symbol(hat, z, scheme = hat)",
        "symbol(hat, order = forward)",
        "symbol(catmull-clark)",
        "symbol(loop)",
        "2^symbol(hat)",
        "symbol(hat)^z",
        "abs(symbol(hat))",
        "symbol(hat, q)",
        "z^(symbol(hat))",
        "symbol(hat:w=1)",
        "symbol(hat, 1)*symbol(hat)/2",
        "symbol(hat, z^0)*symbol(hat)/2",
        "symbol(tension, w = 1/16)",
        "symbol(tension, w = q)",
        "symbol(tension, w = z)",
        "symbol(tension, w = 1-1)",
        "symbol(tension, w = 0, w = 0)",
        "symbol(tension, v = 0)",
        "symbol(hat, w = 0)",
        "symbol(hat, scheme = hat)",
        "symbol(wide)",
    ] {
        assert!(!is(symbol, -1, &["1/2", "1", "1/2"]), "{symbol}");
        assert!(!is(symbol, 0, &["1", "1"]), "{symbol}");
    }
    // Only what stands before counts, also where the catalogue has the name too.
    let order = |first: &str, second: &str| {
        let schemes = format!(
            "[[scheme]]\nname = '{first}'\nsymbol = '1 + z'\n[[scheme]]\nname = 'own'\nsymbol = 'symbol(chaikin)'\n\
             [[scheme]]\nname = '{second}'\nsymbol = '1 + z'\n"
        );
        let states = "arity(own) = 2";
        relation_of(
            &schemes,
            &format!("states = '{states}'"),
            &format!("states {states}\n holds 1"),
        )
    };
    assert_eq!(order("chaikin", "other"), Outcome::Valid);
    assert_eq!(order("one", "other"), Outcome::Valid);
    assert!(
        matches!(order("other", "chaikin"), Outcome::Invalid(..)),
        "{:?}",
        order("other", "chaikin")
    );
    // No formula outside of symbols has this function.
    let states = "symbol(hat) = 1";
    let found = relation_of(
        SCHEMES,
        &format!("states = '{states}'"),
        &format!("states {states}\n holds 1"),
    );
    assert!(matches!(found, Outcome::Invalid(..)));
}

#[test]
fn chains_and_circles_end() {
    let chain = |length: usize, power: &str, formula: &str| {
        let mut schemes = "[[scheme]]\nname = 's0'\nsymbol = '1 + z'\n".to_owned();
        for i in 1..=length {
            let before = i - 1;
            let _ = writeln!(
                schemes,
                "[[scheme]]\nname = 's{i}'\nsymbol = 'symbol(s{before}, {power})'"
            );
        }
        let states = formula.to_owned();
        relation_of(
            &schemes,
            &format!("states = '{states}'"),
            &format!("states {states}\n holds 1"),
        )
    };
    assert_eq!(chain(8, "z", "symbol_at(s8, 1) = 2"), Outcome::Valid);
    assert!(matches!(chain(9, "z", "symbol_at(s9, 1) = 2"), Outcome::Incomplete(_)));
    // It does not help that a part of the chain is known.
    let known = "symbol_at(s5, 1) + symbol_at(s9, 1) = 4";
    assert!(matches!(chain(9, "z", known), Outcome::Incomplete(_)));
    assert_eq!(chain(5, "z^3", "coefficient(s5, 3^5) = 1"), Outcome::Valid);
    assert!(matches!(chain(5, "z^9", "coefficient(s5, 3) = 0"), Outcome::Incomplete(_)));
    // A name that stands for a later scheme leads into a circle.
    let schemes = "[[scheme]]\nname = 'a'\nuse = 'c'\n[[scheme]]\nname = 'b'\nsymbol = 'symbol(a)'\n\
                   [[scheme]]\nname = 'c'\nsymbol = 'symbol(b)'\n";
    let states = "arity(c) = 2";
    let found = relation_of(
        schemes,
        &format!("states = '{states}'"),
        &format!("states {states}\n holds 1"),
    );
    assert!(matches!(found, Outcome::Incomplete(_)), "{found:?}");
    // Powers and products of long symbols.
    let schemes = "[[scheme]]\nname = 'a'\nsymbol = 'sum(i = 0..8000, z^i)*2/8001'\narity = '2'\n\
                   [[scheme]]\nname = 'b'\nsymbol = 'symbol(chaikin, z^3)^64*symbol(chaikin, z^7)^64*symbol(chaikin, z^11)^64'\n";
    for states in ["arity(a) = 2", "arity(b) = 2"] {
        let found = relation_of(
            schemes,
            &format!("states = '{states}'"),
            &format!("states {states}\n holds 1"),
        );
        assert!(!matches!(found, Outcome::Valid), "{states}");
    }
}
