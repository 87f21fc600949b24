//! Definitions, unstated names and functions.

use super::{definition, definitions, r};
use std::collections::BTreeMap;
use subcert::exact::{Polynomial, Rational};
use subcert::formula::{
    Call, CallError, Context, FormulaErrorKind, Functions, LocatedFormula, Scope, evaluate, parse,
};

fn value(
    text: &str,
    definitions: &BTreeMap<String, LocatedFormula>,
) -> Result<Rational, FormulaErrorKind> {
    let scope = Scope::new(definitions, &()).with("w", r(1, 3)).with_unstated("beta");
    evaluate(&parse(text).unwrap(), &scope).map_err(|error| error.kind)
}

#[test]
fn definitions_are_evaluated_where_they_are_used() {
    let some =
        definitions([("a", "2*w"), ("b", "a + a"), ("at", "10*h + w"), ("w", "99"), ("h0", "h")]);
    assert_eq!(value("b", &some), Ok(r(4, 3)));
    // They see the indices of sums around their use, the innermost first.
    assert_eq!(value("sum(h = 1..3, at)", &some), Ok(r(61, 1)));
    assert_eq!(value("sum(h = 1..2, sum(h = 5..5, h0))", &some), Ok(r(10, 1)));
    assert!(matches!(value("at", &some), Err(FormulaErrorKind::UnknownName { .. })));
    // A value hides a definition; an index hides both.
    assert_eq!(value("w", &some), Ok(r(1, 3)));
    assert_eq!(value("sum(w = 4..4, w)", &some), Ok(r(4, 1)));
    assert_eq!(value("sum(w = 4..4, a)", &some), Ok(r(8, 1)));
}

#[test]
fn unstated_and_unknown_names() {
    let some = definitions([("twice", "2*beta")]);
    let unstated = Err(FormulaErrorKind::Unstated("beta".to_owned()));
    assert_eq!(value("1 + beta", &some), unstated);
    assert_eq!(value("1 + twice", &some), unstated);
    let known = ["beta", "twice", "w"].map(str::to_owned).to_vec();
    let name = "v".to_owned();
    assert_eq!(value("v", &some), Err(FormulaErrorKind::UnknownName { name, known }));
    assert!(matches!(value("f(1)", &some), Err(FormulaErrorKind::UnknownFunction { .. })));
}

#[test]
fn definitions_that_refer_to_themselves_are_refused() {
    let circles = definitions([("x", "x + 1"), ("y", "z"), ("z", "sum(h = 1..9, y)"), ("ok", "1")]);
    let scope = Scope::<Rational>::new(&circles, &());
    for text in ["x", "y", "1 + z"] {
        let error = evaluate(&parse(text).unwrap(), &scope).unwrap_err();
        assert!(error.to_string().contains("refers to itself"), "{error}");
        // The scope is as good as new.
        assert_eq!(evaluate(&parse("ok + ok").unwrap(), &scope), Ok(r(2, 1)));
    }
}

/// d0, d1, …, each a formula in the next, and a last one.
fn ladder(rungs: usize, rung: impl Fn(&str) -> String) -> BTreeMap<String, LocatedFormula> {
    let step = |i: usize| (format!("d{i}"), definition(&rung(&format!("d{}", i + 1))));
    (0..rungs).map(step).chain([(format!("d{rungs}"), definition("1"))]).collect()
}

#[test]
fn definitions_share_one_cap_on_work() {
    let short = ladder(10, |next| format!("{next} + {next}"));
    assert_eq!(value("d0", &short), Ok(r(1024, 1)));
    // 2^31 steps, if each definition counted for itself.
    let long = ladder(31, |next| format!("{next}*{next}"));
    assert!(matches!(value("d0", &long), Err(FormulaErrorKind::BeyondCap(_))));
    // The count starts again with each evaluation.
    let scope = Scope::<Rational>::new(&short, &());
    let formula = parse("sum(h = 1..100, d0)").unwrap();
    for _ in 0..8 {
        assert_eq!(evaluate(&formula, &scope), Ok(r(102_400, 1)));
    }
}

#[test]
fn definitions_share_one_cap_on_depth() {
    assert_eq!(value("d0", &ladder(31, |next| format!("{next} + 1"))), Ok(r(32, 1)));
    assert!(value("d0", &ladder(32, |next| format!("{next} + 1"))).is_err());
    // 31 definitions of 60 calls each would be deep enough to end the stack.
    let deep = ladder(31, |next| format!("{}{next}{}", "abs(".repeat(60), ")".repeat(60)));
    assert!(matches!(value("d0", &deep), Err(FormulaErrorKind::BeyondCap(_))));
    let scope = Scope::<Polynomial>::new(&deep, &());
    assert!(evaluate(&parse("d0").unwrap(), &scope).is_err());
}

/// `pair(a, b, order = …)`: a − b forward, b − a backward; `h()` is the index.
struct Pairs;

impl Functions<Rational> for Pairs {
    fn call(
        &self,
        call: &Call<'_, Rational>,
        _: &dyn Context<Rational>,
    ) -> Result<Rational, CallError> {
        match (call.function, call.arguments) {
            ("pair", [a, b]) => match call.options {
                [option] if option.name == "order" && option.word == "forward" => Ok(a - b),
                [option] if option.name == "order" && option.word == "half-open" => Ok(b - a),
                _ => Err(CallError::Misuse("pair needs order = forward or half-open".to_owned())),
            },
            ("h", []) => call
                .indices
                .first()
                .map(|(_, value)| value.clone())
                .ok_or_else(|| CallError::Undefined("outside a sum".to_owned())),
            _ => Err(CallError::UnknownFunction(vec!["pair".to_owned(), "h".to_owned()])),
        }
    }
}

#[test]
fn functions_of_the_context() {
    let none = BTreeMap::new();
    let scope = Scope::new(&none, &Pairs);
    let value = |text: &str| evaluate(&parse(text).unwrap(), &scope);
    assert_eq!(value("pair(5, 3, order = forward)"), Ok(r(2, 1)));
    assert_eq!(value("pair(5, 3, order=half-open )"), Ok(r(-2, 1)));
    assert_eq!(value("sum(i = 1..2, sum(k = 5..6, h()))"), Ok(r(22, 1)));
    assert_eq!(value("1 + pair(5, 3)").unwrap_err().span, 4..14);
    assert!(matches!(value("h()").unwrap_err().kind, FormulaErrorKind::Undefined(_)));
    let error = value("parr(1)").unwrap_err().to_string();
    assert!(error.contains("did you mean `pair`? Known here: pair, h, abs"), "{error}");
}
