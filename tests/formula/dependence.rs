//! What formulas depend on, and that it is no less than their values do.

use super::definitions;
use proptest::prelude::*;
use subcert::exact::RealCyclotomic;
use subcert::formula::{Dependence, IndexPair, Scope, evaluate, parse};

const FORMULAS: [(&str, Dependence); 22] = [
    ("N/4", Dependence::Neither),
    ("i - i", Dependence::Neither),
    ("-i^2", Dependence::First),
    ("abs(j) + 1", Dependence::Second),
    ("j - i", Dependence::Difference),
    ("-(i - j) + N - 1", Dependence::Difference),
    ("2*(j - i) + (i + 1 - j)^2", Dependence::Difference),
    ("i + (1 - j)", Dependence::Difference),
    ("j + i", Dependence::Both),
    ("j - i - i", Dependence::Both),
    ("j - 2*i", Dependence::Both),
    ("kronecker(i + 1, j)", Dependence::Difference),
    ("kronecker(i + j, 0)", Dependence::Both),
    ("kronecker(i, 0)*kronecker(j, 0)", Dependence::Both),
    ("max(i, j)", Dependence::Both),
    ("cos(2*pi*(j - i)/5) + kronecker(turn, 1)", Dependence::Difference),
    ("turn + i", Dependence::Both),
    ("cos(2*pi*j/5)", Dependence::Second),
    ("sum(k = 0..2, k*(j - i))", Dependence::Difference),
    ("sum(k = 0..i, k)", Dependence::First),
    // The index of the sum is not the one outside, though of the same name.
    ("sum(j = 0..2, j*(j - i))", Dependence::Both),
    ("sum(i = 0..2, turn)", Dependence::Both),
];

#[test]
fn as_listed() {
    let definitions = definitions([("turn", "mod(j - i, N)")]);
    let mut pair = IndexPair::new(["i", "j"], &definitions);
    for (text, wanted) in FORMULAS {
        assert_eq!(pair.dependence(&parse(text).unwrap()), wanted, "{text}");
    }
    let circle = super::definitions([("a", "b - i"), ("b", "a + j"), ("c", "j - i")]);
    let mut pair = IndexPair::new(["i", "j"], &circle);
    assert_eq!(pair.dependence(&parse("a").unwrap()), Dependence::Both);
    assert_eq!(pair.dependence(&parse("c").unwrap()), Dependence::Difference);
}

proptest! {
    // Two places that look the same to a formula have the same value.
    #[test]
    fn values_depend_on_no_more(
        choice in 0..FORMULAS.len(), i in 0_i64..6, j in 0_i64..6, s in 0_i64..6, t in 0_i64..6,
    ) {
        let definitions = definitions([("turn", "mod(j - i, N)")]);
        let (text, dependence) = FORMULAS[choice];
        let formula = parse(text).unwrap();
        let value = |i: i64, j: i64| {
            let scope = Scope::new(&definitions, &()).with("N", RealCyclotomic::from(7));
            let scope = scope.with("i", RealCyclotomic::from(i)).with("j", RealCyclotomic::from(j));
            evaluate(&formula, &scope).unwrap()
        };
        let other = match dependence {
            Dependence::Neither => (s, t),
            Dependence::First => (i, t),
            Dependence::Second => (s, j),
            Dependence::Difference => (i + s, j + s),
            Dependence::Both => (i, j),
        };
        prop_assert_eq!(value(i, j), value(other.0, other.1), "{}", text);
    }
}
