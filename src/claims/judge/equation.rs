//! Judging an equation.

use crate::cap::Cap;
use crate::claim::{Equation, EquationBody, Identity, Index, Paper, is_rounded};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::shape::Shapes;
use crate::exact::{Polynomial, Rational, Rounding, parse_decimal};
use crate::finding::{EquationFinding, EquationVerdict, Failure};
use crate::formula::{LocatedFormula, Parameters, Value as _, evaluate};
use crate::judge::comparison::{Case, Comparison};
use crate::judge::kind::JudgeAlone;
use crate::judge::mend;
use std::cell::Cell;
use std::collections::BTreeMap;

/// The most steps of formulas in all cases of an equation together.
const MAX_WORK: u64 = 20_000_000;

/// The greatest absolute value of an index.
const MAX_INDEX: i64 = 1_000_000;

/// The most combinations of indices that an identity is compared in.
pub const MAX_CASES: usize = 100_000;

impl<'a> JudgeAlone<'a> for Equation {
    type Finding = EquationFinding<'a>;

    /// Judges an equation: both sides as polynomials in the symbols, in normal form.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<EquationFinding<'a>, Diagnostic> {
        let id = format!("{}:{}", paper.key, self.id);
        let verdict = match &self.body {
            EquationBody::NotCheckable(_) => EquationVerdict::NotCheckable,
            EquationBody::Identity(identity) => {
                let found = Diagnostic::or_cap(compare(paper, identity, library))?;
                found.unwrap_or_else(EquationVerdict::BeyondCap)
            }
        };
        Ok(EquationFinding { id, equation: self, verdict })
    }
}

fn compare(
    paper: &Paper,
    identity: &Identity,
    library: &Library<'_>,
) -> Result<EquationVerdict, Diagnostic> {
    let cases = cases(identity)?;
    let comparison =
        Comparison { paper, identity, shapes: Shapes::new(library), spent: Cell::new(0) };
    let (mut failures, mut failing) = (Vec::new(), Vec::new());
    for (i, case) in cases.iter().enumerate() {
        let printed = identity.left.formula(i);
        let (left, right) = Diagnostic::both(
            comparison.value(printed, &printed.expr, case),
            comparison.value(&identity.right, &identity.right.expr, case),
        )?;
        if comparison.spent.get() > MAX_WORK {
            return Err(beyond(&identity.right, Cap::new("the work of all cases", MAX_WORK)));
        }
        if left != right {
            let indices = case.values.iter().map(|(_, value)| value.clone()).collect();
            let rounding = rounding(printed, &right).or_else(|| rounding(&identity.right, &left));
            failures.push(Failure { at: case.text.clone(), indices, left, right, rounding });
            failing.push(i);
        }
    }
    if failures.is_empty() {
        return Ok(EquationVerdict::Holds { cases: cases.len() });
    }
    let mends = if failures.iter().all(|failure| failure.rounding.is_some()) {
        Vec::new()
    } else {
        mend::search(&comparison, &cases, &failing)
    };
    Ok(EquationVerdict::Fails { cases: cases.len(), failures, mends })
}

/// How a side that is one decimal came from the number on the other side: rounded to the nearest, or, if it has digits enough, cut or
/// rounded away from zero.
fn rounding(printed: &LocatedFormula, other: &Polynomial) -> Option<Rounding> {
    let decimal = parse_decimal(&printed.text).ok().filter(|decimal| decimal.exponent() < 0)?;
    let rounding = decimal.rounding_of(&other.as_rational()?);
    match rounding {
        Rounding::Nearest => Some(rounding),
        Rounding::Cut | Rounding::Up => is_rounded(&decimal).then_some(rounding),
        Rounding::Exact | Rounding::Neither => None,
    }
}

/// Every combination of the indices, the first one slowest.
fn cases(identity: &Identity) -> Result<Vec<Case>, Diagnostic> {
    let mut cases = vec![Case { values: Vec::new(), text: String::new() }];
    for index in &identity.indices {
        let mut longer = Vec::new();
        for case in cases {
            let (name, label, entries) = match index {
                Index::Listed { name, label, values } => (name, label, values.clone()),
                Index::Range { name, label, from, to } => {
                    let (from, to) = (bound(from, &case)?, bound(to, &case)?);
                    let entry = |value: i64| (Rational::from(value), value.to_string());
                    (name, label, (from..=to).take(MAX_CASES + 1).map(entry).collect::<Vec<_>>())
                }
            };
            for (value, printed) in entries {
                let comma = if case.text.is_empty() { "" } else { ", " };
                let text = format!("{}{comma}{label} = {printed}", case.text);
                let mut values = case.values.clone();
                values.push((name.clone(), value));
                longer.push(Case { values, text });
            }
            if longer.len() > MAX_CASES {
                let cap = Cap::new("the number of combinations of the indices", MAX_CASES as u64);
                return Err(beyond(&identity.right, cap));
            }
        }
        cases = longer;
    }
    if cases.is_empty() {
        let (source, span) = (&identity.right.source, identity.right.span.clone());
        let message = "the indices have no values, so that nothing is claimed";
        return Err(Diagnostic::new(source, span, message)
            .with_help("`from` is the first value and `to` the last one, which is not less"));
    }
    Ok(cases)
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
fn beyond(formula: &LocatedFormula, cap: Cap) -> Diagnostic {
    Diagnostic::new(&formula.source, formula.span.clone(), cap.to_string()).with_cap(Some(cap))
}
