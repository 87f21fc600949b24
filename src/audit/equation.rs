//! Judging an equation.

use super::judge::scheme_error;
use super::library::{Library, Unresolved};
use super::shape::{Coefficients, Shape, Shapes};
use super::{hypotheses, mend};
use crate::claim::{Equation, EquationBody, Hypothesis, Identity, Index, LocatedReference, Paper};
use crate::diagnostic::Diagnostic;
use crate::exact::{Polynomial, Rational, Scalar};
use crate::formula::{Context, Expr, LocatedFormula, Parameters, Scope, Value, evaluate};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most combinations of indices that an identity is compared in.
pub const MAX_CASES: usize = 100_000;

/// What the audit says of an equation.
#[derive(Clone, Debug)]
pub struct EquationFinding<'a> {
    /// `key:equation`.
    pub id: String,
    /// The equation.
    pub equation: &'a Equation,
    /// The verdict.
    pub verdict: EquationVerdict,
}

/// The verdict of an equation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EquationVerdict {
    /// Both sides are equal, in all of this many cases.
    Holds {
        /// The number of combinations of the indices.
        cases: usize,
    },
    /// They differ somewhere.
    Fails {
        /// The number of combinations of the indices.
        cases: usize,
        /// Those where the sides differ.
        failures: Vec<Failure>,
        /// Changes of one symbol with which it holds in all cases.
        mends: Vec<String>,
    },
    /// Something that it needs is absent: what.
    NotCheckable(String),
}

impl EquationVerdict {
    /// The verdict's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            EquationVerdict::Holds { .. } => "holds",
            EquationVerdict::Fails { .. } => "fails",
            EquationVerdict::NotCheckable(_) => "not-checkable",
        }
    }
}

/// A case in which the two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The indices in words; empty when there are none.
    pub at: String,
    /// The values of the indices.
    pub indices: Vec<Rational>,
    /// The left side.
    pub left: Polynomial,
    /// The right side.
    pub right: Polynomial,
}

impl Failure {
    /// left − right.
    #[must_use]
    pub fn difference(&self) -> Polynomial {
        &self.left - &self.right
    }
}

/// Judges an equation: both sides as polynomials in the symbols, in normal form.
pub(super) fn judge<'a>(
    paper: &'a Paper,
    equation: &'a Equation,
    library: &Library<'_>,
) -> Result<EquationFinding<'a>, Diagnostic> {
    let id = format!("{}:{}", paper.key, equation.id);
    let verdict = match &equation.body {
        EquationBody::NotCheckable(absent) => EquationVerdict::NotCheckable(absent.clone()),
        EquationBody::Identity(identity) => compare(paper, identity, library)?,
    };
    Ok(EquationFinding { id, equation, verdict })
}

fn compare(
    paper: &Paper,
    identity: &Identity,
    library: &Library<'_>,
) -> Result<EquationVerdict, Diagnostic> {
    let cases = cases(identity)?;
    let comparison = Comparison { paper, identity, shapes: Shapes::new(library) };
    let (mut failures, mut failing) = (Vec::new(), Vec::new());
    for (i, case) in cases.iter().enumerate() {
        let left = identity.left.formula(i);
        let left = comparison.value(left, &left.expr, case)?;
        let right = comparison.value(&identity.right, &identity.right.expr, case)?;
        if left != right {
            let indices = case.values.iter().map(|(_, value)| value.clone()).collect();
            failures.push(Failure { at: case.text.clone(), indices, left, right });
            failing.push(i);
        }
    }
    if failures.is_empty() {
        return Ok(EquationVerdict::Holds { cases: cases.len() });
    }
    let mends = mend::search(&comparison, &cases, &failing);
    Ok(EquationVerdict::Fails { cases: cases.len(), failures, mends })
}

/// A combination of the indices.
pub(super) struct Case {
    pub(super) values: Vec<(String, Rational)>,
    text: String,
}

/// Every combination of the indices, the first one slowest.
fn cases(identity: &Identity) -> Result<Vec<Case>, Diagnostic> {
    let mut cases = vec![Case { values: Vec::new(), text: String::new() }];
    for index in &identity.indices {
        let mut longer = Vec::new();
        for case in cases {
            let (name, label, entries) = match index {
                Index::Listed(axis) => {
                    let entry = |entry: &crate::claim::AxisEntry| {
                        (entry.value.clone(), entry.printed.clone())
                    };
                    (&axis.name, &axis.label, axis.entries.iter().map(entry).collect())
                }
                Index::Range { name, label, from, to } => {
                    let (from, to) = (bound(from, &case)?, bound(to, &case)?);
                    let entry = |value: i64| (Rational::from(value), value.to_string());
                    (name, label, (from..=to).map(entry).collect::<Vec<_>>())
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
                let source = &identity.right.source;
                let message = format!("more than {MAX_CASES} combinations of the indices");
                return Err(Diagnostic::new(source, identity.right.span.clone(), message));
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
    let integer = value.numerator().to_i64().filter(|value| value.abs() <= 1_000_000);
    integer.filter(|_| value.is_integer()).ok_or_else(|| {
        let message = format!("an index runs over integers up to 10^6, and this is {value}");
        Diagnostic::new(&formula.source, formula.span.clone(), message)
    })
}

/// The scheme that a claim is about; of a tensor product, the first.
pub(super) fn own_shape<V: Value + PartialEq>(
    shapes: &Shapes<'_, V>,
    located: &LocatedReference,
    context: &dyn Context<V>,
) -> Result<Rc<Shape<V>>, Diagnostic> {
    shapes.own(&located.reference, context).map_err(|error| match error {
        Unresolved::Scheme(error) => scheme_error(located, &error),
        Unresolved::Formula(error) => {
            let message = format!("in its parameters: {error}");
            Diagnostic::new(&located.source, located.span.clone(), message)
        }
    })
}

/// An identity with what its formulas refer to.
pub(super) struct Comparison<'a> {
    paper: &'a Paper,
    pub(super) identity: &'a Identity,
    shapes: Shapes<'a, Polynomial>,
}

impl Comparison<'_> {
    /// The value of `expr`, which stands in `formula` or instead of it.
    pub(super) fn value(
        &self,
        formula: &LocatedFormula,
        expr: &Expr,
        case: &Case,
    ) -> Result<Polynomial, Diagnostic> {
        let member = |name: &str| Polynomial::variable(name);
        let none = Coefficients { shapes: &self.shapes, own: None };
        let own = match &self.identity.scheme {
            None => None,
            Some(located) => {
                let scope = self.scope(case, &none, &member)?;
                Some(own_shape(&self.shapes, located, &scope)?)
            }
        };
        let functions = Coefficients { shapes: &self.shapes, own };
        let scope = self.scope(case, &functions, &member)?;
        evaluate(expr, &scope).map_err(|error| formula.diagnostic(&error))
    }

    fn scope<'s>(
        &'s self,
        case: &Case,
        functions: &'s Coefficients<'s, Polynomial>,
        member: &'s dyn Fn(&str) -> Polynomial,
    ) -> Result<Scope<'s, Polynomial>, Diagnostic> {
        let identity = self.identity;
        let plain = || {
            let mut scope = Scope::new(&self.paper.definitions, functions);
            for symbol in &identity.symbols {
                let variable = Polynomial::variable(symbol);
                scope = scope.with(symbol, variable).with_family(symbol, member);
            }
            for (name, value) in &case.values {
                scope = scope.with(name, Polynomial::from_rational(value));
            }
            scope
        };
        // A family of which all members that occur are given is no symbol itself.
        let mut symbols = plain();
        for family in identity.hypotheses.iter().filter_map(Hypothesis::family) {
            symbols = symbols.with_family(family, member);
        }
        let solved = hypotheses::solve(&identity.hypotheses, &symbols)?;
        let mut scope = plain();
        for (name, value) in solved {
            // Its value is one of the other symbols: none of a family that is only given.
            let unknown = value.linear().into_iter().flatten().find(|name| {
                let family = name.split_once('[').map(|(family, _)| family);
                family.is_some_and(|family| identity.symbols.iter().all(|known| known != family))
            });
            if let Some(unknown) = unknown {
                let right = &identity.right;
                let message = format!("the hypotheses leave `{unknown}` open");
                return Err(Diagnostic::new(&right.source, right.span.clone(), message)
                    .with_help("give it a value too, or name its family in `symbols`"));
            }
            scope = scope.with(&name, value);
        }
        Ok(scope)
    }
}
