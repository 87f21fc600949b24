//! Judging an equation.

use super::library::{Library, Unresolved};
use super::quantity::Coefficients;
use super::table::scheme_error;
use crate::claim::{Axis, Equation, EquationBody, Identity, Paper};
use crate::diagnostic::Diagnostic;
use crate::exact::{Polynomial, Scalar};
use crate::formula::{LocatedFormula, Scope, evaluate};
use crate::scheme::Mask;

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
        EquationBody::Identity(identity) => {
            let mut failures = Vec::new();
            for (case, left) in identity.left.iter().enumerate() {
                let positions = indices_of(&identity.indices, case);
                failures.extend(compare(paper, identity, library, left, &positions)?);
            }
            let cases = identity.left.len();
            if failures.is_empty() {
                EquationVerdict::Holds { cases }
            } else {
                EquationVerdict::Fails { cases, failures }
            }
        }
    };
    Ok(EquationFinding { id, equation, verdict })
}

/// The position in each axis of the `case`-th combination, the first slowest.
fn indices_of(indices: &[Axis], mut case: usize) -> Vec<usize> {
    let mut positions: Vec<usize> = indices
        .iter()
        .rev()
        .map(|axis| {
            let position = case % axis.entries.len();
            case /= axis.entries.len();
            position
        })
        .collect();
    positions.reverse();
    positions
}

fn compare(
    paper: &Paper,
    identity: &Identity,
    library: &Library<'_>,
    left: &LocatedFormula,
    positions: &[usize],
) -> Result<Option<Failure>, Diagnostic> {
    let Identity { scheme, symbols, indices, right, .. } = identity;
    let scope = |functions| {
        let mut scope = Scope::new(&paper.definitions, functions);
        for symbol in symbols {
            scope = scope.with(symbol, Polynomial::variable(symbol));
        }
        for (axis, &position) in indices.iter().zip(positions) {
            let value = Polynomial::from_rational(&axis.entries[position].value);
            scope = scope.with(&axis.name, value);
        }
        scope
    };
    let none = Coefficients { library, mask: None };
    let mask: Option<Mask<Polynomial>> = match scheme {
        None => None,
        Some(located) => {
            let masks = library.masks(&located.reference, &scope(&none));
            let masks = masks.map_err(|error| match error {
                Unresolved::Scheme(error) => scheme_error(located, &error),
                Unresolved::Formula(error) => {
                    let message = format!("in its parameters: {error}");
                    Diagnostic::new(&located.source, located.span.clone(), message)
                }
            })?;
            masks.into_iter().next()
        }
    };
    let functions = Coefficients { library, mask };
    let scope = scope(&functions);
    let value = |formula: &LocatedFormula| {
        evaluate(&formula.expr, &scope).map_err(|error| formula.diagnostic(&error))
    };
    let (left, right) = (value(left)?, value(right)?);
    if left == right {
        return Ok(None);
    }
    let at = indices
        .iter()
        .zip(positions)
        .map(|(axis, &position)| format!("{} = {}", axis.label, axis.entries[position].printed));
    Ok(Some(Failure { at: at.collect::<Vec<String>>().join(", "), left, right }))
}
