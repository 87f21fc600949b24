//! Laurent polynomials: laws on random ones.

use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::exact::{Polynomial, Rational};
use subcert::formula::{Laurent, Parameters, Value, evaluate, parse};

/// The value of a text in z, with these values of other names.
fn laurent<V: Value>(text: &str, others: &[(&str, V)]) -> Laurent<V> {
    let constant =
        |(name, value): &(&str, V)| ((*name).to_owned(), Laurent::constant(value.clone()));
    let mut names: BTreeMap<String, Laurent<V>> = others.iter().map(constant).collect();
    names.insert("z".to_owned(), Laurent::variable());
    let formula = parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    evaluate(&formula, &Parameters(names)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn rational() -> impl Strategy<Value = Laurent<Rational>> {
    let terms = prop::collection::vec((-9_i64..10, -5_i64..6, 1_i64..4), 0..6);
    terms.prop_map(|terms| {
        let terms = terms.iter().map(|(power, p, q)| format!("{p}/{q}*z^{power}"));
        laurent(&terms.chain(["0".to_owned()]).collect::<Vec<_>>().join(" + "), &[])
    })
}

proptest! {
    #[test]
    fn what_is_printed_is_read_as_the_same(symbol in rational(), power in -3_i64..4) {
        prop_assert_eq!(&laurent::<Rational>(&symbol.to_string(), &[]), &symbol, "{}", symbol);
        let w = [("w", Polynomial::variable("w"))];
        let open = laurent(&format!("({symbol})*(1 - w)^2*z^{power} - w*({symbol})"), &w);
        prop_assert_eq!(&laurent(&open.to_string(), &w), &open, "{}", open);
    }

    /// A value at a number is the sum of the terms there, and a quotient times its divisor is the dividend.
    #[test]
    fn values_and_quotients(a in rational(), b in rational(), at in 1_i64..5) {
        let value = |symbol: &Laurent<Rational>| {
            let z = Parameters::from([("z", Rational::from(at))]);
            evaluate(&parse(&symbol.to_string()).expect("a formula"), &z).expect("a number")
        };
        let in_both = |text: &str| {
            let text = text.replace('a', &format!("({a})")).replace('b', &format!("({b})"));
            laurent::<Rational>(&text, &[])
        };
        prop_assert_eq!(value(&in_both("a*b")), value(&a) * value(&b));
        prop_assert_eq!(value(&in_both("a - b")), value(&a) - value(&b));
        if b.powers().is_some() {
            prop_assert_eq!(in_both("a*b/b"), a);
        }
    }
}
