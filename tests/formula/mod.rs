//! Formulas: what they mean, where their errors point, and that nothing in them
//! makes the program panic or run on.

mod caps;
mod cosine;
mod dependence;
mod errors;
mod laurent;
mod roots;
mod scope;
mod syntax;
mod trees;

use std::collections::BTreeMap;
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::formula::{
    FormulaError, FormulaErrorKind, LocatedFormula, Parameters, Value, evaluate, parse,
};

fn r(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

/// The value over w = 3/256 and μ = −2.
fn value(text: &str) -> Result<Rational, FormulaError> {
    value_in(text, &Parameters::from([("w", r(3, 256)), ("μ", r(-2, 1))]))
}

fn value_in<V: Value>(text: &str, parameters: &Parameters<V>) -> Result<V, FormulaError> {
    parse(text).and_then(|formula| evaluate(&formula, parameters))
}

fn kind(text: &str) -> FormulaErrorKind {
    value(text).expect_err(text).kind
}

fn definitions<const N: usize>(texts: [(&str, &str); N]) -> BTreeMap<String, LocatedFormula> {
    texts.into_iter().map(|(name, text)| (name.to_owned(), definition(text))).collect()
}

fn definition(text: &str) -> LocatedFormula {
    let source = SourceText::new("definitions.toml", text);
    LocatedFormula::read(&source, 0..text.len(), text).expect("a formula")
}
