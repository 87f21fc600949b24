//! Formulas and constants as functions of one free parameter.

use super::equation::own_shape;
use super::library::{Library, values};
use super::options::Options;
use super::quantity::{level, moved, total_contraction, undefined};
use super::series;
use super::shape::{Coefficients, Shapes, shape};
use crate::bound::{Terms, power_norm_generic};
use crate::claim::{LocatedReference, Paper};
use crate::diagnostic::Diagnostic;
use crate::exact::{Parametric, PiecewiseLinear, Rational, Scalar};
use crate::formula::{Call, CallError, Context, Functions, LocatedFormula, Scope, evaluate};
use std::collections::BTreeMap;

/// What the formulas of a claim about a free parameter refer to.
pub(super) struct FreeParameter<'a> {
    paper: &'a Paper,
    library: &'a Library<'a>,
    variable: &'a str,
    given: BTreeMap<String, Rational>,
    scheme: Option<&'a LocatedReference>,
}

impl<'a> FreeParameter<'a> {
    pub(super) fn new(
        paper: &'a Paper,
        library: &'a Library<'a>,
        variable: &'a str,
        scheme: Option<&'a LocatedReference>,
    ) -> Result<FreeParameter<'a>, Diagnostic> {
        Ok(FreeParameter { paper, library, variable, given: values(&paper.given)?, scheme })
    }

    /// The value of a formula, as a function of the free parameter.
    pub(super) fn function(&self, formula: &LocatedFormula) -> Result<PiecewiseLinear, Diagnostic> {
        let shapes = Shapes::new(self.library);
        let none = Constants { coefficients: Coefficients { shapes: &shapes, own: None } };
        let own = match self.scheme {
            None => None,
            Some(located) => Some(own_shape(&shapes, located, &self.scope(&none))?),
        };
        let constants = Constants { coefficients: Coefficients { shapes: &shapes, own } };
        let value = evaluate(&formula.expr, &self.scope(&constants));
        match value.map_err(|error| formula.diagnostic(&error))? {
            Parametric::Function(function) => Ok(function),
            Parametric::Outside => {
                let variable = self.variable;
                let message = format!("this is not piecewise linear in `{variable}`");
                Err(Diagnostic::new(&formula.source, formula.span.clone(), message).with_help(
                    format!(
                        "it multiplies or divides two expressions that both depend on \
                         `{variable}`; sums, rational multiples, abs, max and min can be compared"
                    ),
                ))
            }
        }
    }

    fn scope<'s>(&'s self, constants: &'s Constants<'s>) -> Scope<'s, Parametric> {
        let mut scope = Scope::new(&self.paper.definitions, constants);
        for (name, value) in &self.given {
            scope = scope.with(name, Parametric::from_rational(value));
        }
        scope.with(self.variable, Parametric::variable())
    }
}

/// The constants of a scheme that are piecewise linear in its parameter when its
/// mask is.
struct Constants<'a> {
    coefficients: Coefficients<'a, Parametric>,
}

impl Functions<Parametric> for Constants<'_> {
    fn call(
        &self,
        call: &Call<'_, Parametric>,
        context: &dyn Context<Parametric>,
    ) -> Result<Parametric, CallError> {
        let mut options = Options::new(call);
        if let Some(value) =
            series::call(call, context, &mut options, &self.coefficients.shapes.norms)
        {
            return options.finished(value?);
        }
        let found = self.coefficients.shape(call, &mut options)?;
        let mask = &found.mask;
        let value = match (call.function, call.arguments) {
            ("contraction", [c]) => {
                let (order, terms) = (options.order()?, options.terms()?);
                one_level(call.function, c)?;
                let difference = found.difference();
                match terms {
                    Terms::Each => power_norm_generic(difference, 1, order).map_err(undefined)?,
                    Terms::Total => total_contraction(difference),
                }
            }
            ("norm", [c]) => {
                let order = options.order()?;
                one_level(call.function, c)?;
                power_norm_generic(mask.rules(), 1, order).map_err(undefined)?
            }
            ("displacement", []) => moved(mask, &mut options)?,
            (name @ ("tensor" | "surface_displacement" | "levels"), _) => {
                let message = format!("`{name}` is not piecewise linear in a free parameter");
                return Err(CallError::Misuse(message));
            }
            _ => shape(mask, || found.difference(), call, &mut options)?,
        };
        options.finished(value)
    }
}

/// Refuses c ≠ 1: the constants of c ≥ 2 levels are norms of products.
fn one_level(function: &str, c: &Parametric) -> Result<(), CallError> {
    match level(c)? {
        1 => Ok(()),
        c => Err(CallError::Misuse(format!(
            "`{function}({c})` is not piecewise linear in a free parameter; `{function}(1)` is"
        ))),
    }
}
