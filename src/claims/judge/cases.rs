//! The combinations of the indices of an equation.

use crate::cap::Cap;
use crate::claim::{Identity, Index};
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::formula::{LocatedFormula, Parameters, evaluate};
use std::collections::BTreeMap;

/// The greatest absolute value of an index.
const MAX_INDEX: i64 = 1_000_000;

/// The most combinations of indices that an identity is compared in.
pub const MAX_CASES: usize = 100_000;

/// How many values of an index are tried that runs over all integers from one on.
const TRIED: i64 = 24;

/// A combination of the indices.
#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) values: Vec<(String, Rational)>,
    /// The values as they are printed.
    pub(crate) printed: Vec<(String, String)>,
    /// The indices without a value, which are symbols.
    pub(crate) symbolic: Vec<(String, i64)>,
    /// The values of the indices, in words.
    pub(crate) text: String,
}

impl Case {
    /// The case with one more index.
    pub(crate) fn with(&self, name: &str, label: &str, (value, printed): (Rational, &str)) -> Case {
        let mut case = self.clone();
        let comma = if case.text.is_empty() { "" } else { ", " };
        case.text = format!("{}{comma}{label} = {printed}", case.text);
        case.values.push((name.to_owned(), value));
        case.printed.push((name.to_owned(), printed.to_owned()));
        case
    }

    /// The case without values.
    pub(crate) fn first() -> Case {
        let (values, printed, symbolic, text) = Default::default();
        Case { values, printed, symbolic, text }
    }

    /// The case in which the one index without a value has this one. The indices stand in the order of the claim.
    pub(crate) fn at(&self, identity: &Identity, value: i64) -> Case {
        let known = |name: &String| {
            let known = self.values.iter().find(|(known, _)| known == name);
            known.map_or_else(Rational::zero, |(_, value)| value.clone())
        };
        let mut case = Case::first();
        for index in &identity.indices {
            case = match index {
                Index::All { name, .. } => {
                    case.with(name, name, (Rational::from(value), &value.to_string()))
                }
                Index::Real { .. } => case,
                Index::Listed { name, label, .. } | Index::Range { name, label, .. } => {
                    let printed = known(name).to_string();
                    case.with(name, label, (known(name), &printed))
                }
                Index::Together { names, .. } => names.iter().fold(case, |case, name| {
                    let printed = known(name).to_string();
                    case.with(name, name, (known(name), &printed))
                }),
            };
        }
        case
    }
}

/// What an index is in a case that runs over all integers from one on.
#[derive(Clone, Copy)]
pub(crate) enum Unbounded {
    /// A symbol.
    Symbol,
    /// One of its first values.
    Tried,
}

/// Every combination of the indices, the first one slowest.
pub(crate) fn cases(identity: &Identity, unbounded: Unbounded) -> Result<Vec<Case>, Diagnostic> {
    let right = identity.first().right();
    let mut cases = vec![Case::first()];
    for index in &identity.indices {
        let mut longer = Vec::new();
        for case in cases {
            let integers = |from: i64, to: i64| {
                let entry = |value: i64| (Rational::from(value), value.to_string());
                (from..=to).take(MAX_CASES + 1).map(entry).collect::<Vec<_>>()
            };
            let (name, label, entries) = match (index, unbounded) {
                (Index::Listed { name, label, values }, _) => (name, label, values.clone()),
                (Index::Range { name, label, from, to }, _) => {
                    (name, label, integers(bound(from, &case)?, bound(to, &case)?))
                }
                (Index::All { name, from }, Unbounded::Tried) => {
                    (name, name, integers(*from, from + TRIED - 1))
                }
                (Index::Together { names, rows }, _) => {
                    longer.extend(rows.iter().map(|row| {
                        names.iter().zip(row).fold(
                            case.clone(),
                            |case, (name, (value, printed))| {
                                case.with(name, name, (value.clone(), printed))
                            },
                        )
                    }));
                    capped(&longer, right)?;
                    continue;
                }
                // What real numbers stand for it, is judged for each case.
                (Index::Real { .. }, _) => {
                    longer.push(case);
                    continue;
                }
                (Index::All { name, from }, Unbounded::Symbol) => {
                    let mut case = case;
                    case.symbolic.push((name.clone(), *from));
                    longer.push(case);
                    continue;
                }
            };
            for (value, printed) in entries {
                longer.push(case.with(name, label, (value, &printed)));
            }
            capped(&longer, right)?;
        }
        cases = longer;
    }
    if cases.is_empty() {
        let message = "the indices have no values, so that nothing is claimed";
        return Err(Diagnostic::new(&right.source, right.span.clone(), message)
            .with_help("`from` is the first value and `to` the last one, which is not less"));
    }
    Ok(cases)
}

/// Checks the number of cases.
fn capped(cases: &[Case], right: &LocatedFormula) -> Result<(), Diagnostic> {
    if cases.len() > MAX_CASES {
        let cap = Cap::new("the number of combinations of the indices", MAX_CASES as u64);
        return Err(beyond(right, cap));
    }
    Ok(())
}

fn bound(formula: &LocatedFormula, case: &Case) -> Result<i64, Diagnostic> {
    let values: BTreeMap<String, Rational> = case.values.iter().cloned().collect();
    let value =
        evaluate(&formula.expr, &Parameters(values)).map_err(|error| formula.diagnostic(&error))?;
    if !value.is_integer() {
        let message = format!("an index runs over integers, and this is {value}");
        return Err(Diagnostic::new(&formula.source, formula.span.clone(), message));
    }
    let integer = value.numerator().within(MAX_INDEX);
    integer.ok_or_else(|| beyond(formula, Cap::new("an index", MAX_INDEX.unsigned_abs())))
}

/// The error that a value is beyond a cap.
pub(crate) fn beyond(formula: &LocatedFormula, cap: Cap) -> Diagnostic {
    Diagnostic::new(&formula.source, formula.span.clone(), cap.to_string()).with_cap(Some(cap))
}
