//! Masks on Z^d as formulas over parameters.

use super::boxes;
use super::dilation::{Dilation, Point};
use super::mask::{LatticeError, LatticeMask};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{
    FormulaErrorKind, Functions, LATTICE_VARIABLES, Laurent, LocatedFormula, Scope, Value, evaluate,
};
use crate::scheme::typed::symbol::states;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// A mask on Z^d as it is written: a dilation matrix, edges, and the coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct LatticeFormulas {
    pub(in crate::scheme) dilation: Dilation,
    /// None stand for the axes.
    pub(in crate::scheme) edges: Vec<Point>,
    pub(in crate::scheme) coefficients: LatticeCoefficients,
    pub(in crate::scheme) source: Arc<SourceText>,
    pub(in crate::scheme) span: Range<usize>,
}

/// The three ways to write the coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) enum LatticeCoefficients {
    /// A Laurent polynomial in x, y and z.
    Symbol(Box<LocatedFormula>),
    /// A formula at each place.
    Listed(Vec<(Point, LocatedFormula)>),
    /// The directions of a box spline.
    Directions(Vec<Point>),
}

impl LatticeFormulas {
    /// The formulas of the coefficients.
    pub(in crate::scheme) fn formulas(&self) -> Vec<&LocatedFormula> {
        match &self.coefficients {
            LatticeCoefficients::Symbol(formula) => vec![formula],
            LatticeCoefficients::Listed(all) => all.iter().map(|(_, formula)| formula).collect(),
            LatticeCoefficients::Directions(_) => Vec::new(),
        }
    }

    /// The mask at these values of the parameters.
    ///
    /// # Errors
    /// When a formula has no value, or the coefficients are no mask.
    pub(in crate::scheme) fn mask<V: Value + PartialEq>(
        &self,
        definitions: &BTreeMap<String, LocatedFormula>,
        parameters: &BTreeMap<String, V>,
        functions: &dyn Functions<Laurent<V, Point>>,
    ) -> Result<LatticeMask<V>, Diagnostic> {
        let wrong = |message: String| Diagnostic::new(&self.source, self.span.clone(), message);
        let terms: Vec<(Point, V)> = match &self.coefficients {
            LatticeCoefficients::Symbol(formula) => {
                let value = self.value(formula, definitions, parameters, functions)?;
                value.terms().map(|(power, c)| (power, c.clone())).collect()
            }
            LatticeCoefficients::Listed(all) => {
                let scope = Scope::new(definitions, &()).with_all(parameters);
                let value = |(place, formula): &(Point, LocatedFormula)| {
                    let value = evaluate(&formula.expr, &scope);
                    Ok((*place, value.map_err(|error| formula.diagnostic(&error))?))
                };
                all.iter().map(value).collect::<Result<_, Diagnostic>>()?
            }
            LatticeCoefficients::Directions(directions) => {
                let symbol = boxes::symbol(directions, &self.dilation).ok_or_else(|| {
                    wrong("the dilation matrix takes these directions to no multiples of directions, one each".to_owned())
                })?;
                symbol.terms().map(|(power, c)| (power, V::from_rational(c))).collect()
            }
        };
        let values = terms.iter().map(|(_, c)| c.clone()).collect();
        let values =
            V::together(values).map_err(|error| wrong(error.to_string()).with_cap(error.cap()))?;
        let places = terms.into_iter().map(|(place, _)| place);
        LatticeMask::new(self.dilation.clone(), places.zip(values), self.edges.clone()).map_err(
            |error| {
                let diagnostic = wrong(error.to_string()).with_cap(error.cap());
                match error {
                    LatticeError::NotAffine { .. } => diagnostic.with_help(OTHER_DILATION),
                    _ => diagnostic,
                }
            },
        )
    }

    fn value<V: Value + PartialEq>(
        &self,
        formula: &LocatedFormula,
        definitions: &BTreeMap<String, LocatedFormula>,
        parameters: &BTreeMap<String, V>,
        functions: &dyn Functions<Laurent<V, Point>>,
    ) -> Result<Laurent<V, Point>, Diagnostic> {
        let constant =
            |(name, value): (&String, &V)| (name.clone(), Laurent::constant(value.clone()));
        let constants: BTreeMap<String, Laurent<V, Point>> =
            parameters.iter().map(constant).collect();
        let variables = LATTICE_VARIABLES.into_iter().take(self.dilation.dimension()).enumerate();
        let scope = Scope::new(definitions, functions).with_all(&constants);
        let scope = variables.fold(scope, |scope, (axis, name)| {
            let power = std::array::from_fn(|i| i64::from(i == axis));
            scope.with(name, Laurent::power(power))
        });
        evaluate(&formula.expr, &scope).map_err(|error| {
            let diagnostic = formula.diagnostic(&error);
            match &error.kind {
                FormulaErrorKind::UnknownName { name, .. } if error.definition.is_none() => {
                    diagnostic.with_help(states(name))
                }
                _ => diagnostic,
            }
        })
    }
}

/// What helps where classes do not sum to 1.
const OTHER_DILATION: &str = "the dilation matrix is 2I where no other is given: dilation = [[1, 1], [1, -1]]; a factor may be missing";
