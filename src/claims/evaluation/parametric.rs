//! Formulas and constants as functions of one free parameter.

use crate::bound::{
    Order, RangeError, Suprema, Terms, joint_norm_function_on, norm_function, norm_function_on,
    power_norm_generic,
};
use crate::claim::{LocatedReference, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{CellReading, TableContext};
use crate::evaluation::library::{Library, values};
use crate::evaluation::masks::constants::{levels, moved, total_contraction};
use crate::evaluation::masks::rules::shape;
use crate::evaluation::options::Options;
use crate::evaluation::series;
use crate::evaluation::settings::Settings;
use crate::evaluation::shape::{Coefficients, Shapes, own_shape};
use crate::evaluation::table::Evaluator;
use crate::exact::{Parametric, PiecewisePolynomial, Rational, RationalPolynomial, Scalar};
use crate::formula::{Call, CallError, Context, Functions, LocatedFormula, Scope, evaluate};
use crate::scheme::Rules;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The context of the formulas of a claim about a free parameter.
pub(crate) struct FreeParameter<'a> {
    paper: &'a Paper,
    library: &'a Library<'a>,
    variable: &'a str,
    given: BTreeMap<String, Rational>,
    scheme: Option<&'a LocatedReference>,
}

impl<'a> FreeParameter<'a> {
    pub(crate) fn new(
        paper: &'a Paper,
        library: &'a Library<'a>,
        variable: &'a str,
        scheme: Option<&'a LocatedReference>,
    ) -> Result<FreeParameter<'a>, Diagnostic> {
        Ok(FreeParameter { paper, library, variable, given: values(&paper.given)?, scheme })
    }

    /// The value of a formula, as a function of the free parameter.
    pub(crate) fn function(
        &self,
        formula: &LocatedFormula,
    ) -> Result<PiecewisePolynomial, Diagnostic> {
        let shapes = Shapes::new(self.library);
        let none = Constants::of(Coefficients { shapes: &shapes, own: None });
        let own = match self.scheme {
            None => None,
            Some(located) => Some(own_shape(&shapes, located, &self.scope(&none))?),
        };
        let constants = Constants::of(Coefficients { shapes: &shapes, own });
        let value = evaluate(&formula.expr, &self.scope(&constants));
        match value.map_err(|error| formula.diagnostic(&error))? {
            Parametric::Function(function) => Ok(function),
            Parametric::Outside(Some(cap)) => {
                let (source, span) = (&formula.source, formula.span.clone());
                Err(Diagnostic::new(source, span, cap.to_string()).with_cap(Some(cap)))
            }
            Parametric::Outside(None) => {
                let variable = self.variable;
                let message = format!("this is not piecewise polynomial in `{variable}`");
                Err(Diagnostic::new(&formula.source, formula.span.clone(), message).with_help(
                    format!(
                        "it divides by an expression that depends on `{variable}`; sums, products, \
                         abs, max and min can be compared"
                    ),
                ))
            }
        }
    }

    fn scope<'s>(&'s self, constants: &'s Constants<'s>) -> Scope<'s, Parametric> {
        let mut scope =
            Scope::new(&self.paper.definitions, constants).with_formulas(&self.paper.given);
        for (name, value) in &self.given {
            scope = scope.with(name, Parametric::from_rational(value));
        }
        scope.with(self.variable, Parametric::variable())
    }
}

/// The functions of schemes that are not computed as functions of a free parameter.
const NO_FUNCTIONS: [&str; 2] = ["surface_displacement", "levels"];

/// Whether no part of a table's formula is a quantity that is not computed as a function of a free
/// parameter. It is asked first, as the arguments of such a quantity may take long.
pub(crate) fn is_function(judge: &Evaluator<'_>) -> bool {
    let value = &judge.table.value;
    let led = judge.paper.definitions_in(value).into_values();
    let mut all = [value].into_iter().chain(led);
    all.all(|formula| NO_FUNCTIONS.iter().all(|name| !formula.expr.functions().contains(name)))
}

/// The value of a table's formula in one cell as a function of an unstated parameter. The function
/// is exact on `window`. `None` where the value is not piecewise polynomial.
pub(crate) fn of_cell(
    judge: &Evaluator<'_>,
    at: CellReading<'_>,
    parameter: &str,
    window: &(Rational, Rational),
) -> Option<PiecewisePolynomial> {
    let TableContext { table, library, .. } = &**judge;
    let shapes = Shapes::new(library);
    let constants = |own| {
        let coefficients = Coefficients { shapes: &shapes, own };
        Constants { coefficients, settings: Some(at.settings), window: Some(window) }
    };
    let none = constants(None);
    let own = match table.scheme_at(at.row, at.column) {
        None => None,
        Some(located) => {
            let scope = cell_scope(judge, at, parameter, &none);
            Some(own_shape(&shapes, located, &scope).ok()?)
        }
    };
    let constants = constants(own);
    let value = evaluate(&table.value.expr, &cell_scope(judge, at, parameter, &constants));
    value.ok()?.function().cloned()
}

fn cell_scope<'s>(
    judge: &'s Evaluator<'_>,
    at: CellReading<'s>,
    parameter: &'s str,
    functions: &'s Constants<'s>,
) -> Scope<'s, Parametric> {
    let definitions = at.settings.definitions.as_deref().unwrap_or(&judge.paper.definitions);
    let mut scope = Scope::new(definitions, functions);
    for (name, value) in judge.given.iter().chain(&judge.assumed) {
        let value = at.settings.parameters.get(name).unwrap_or(value);
        scope = scope.with(name, Parametric::from_rational(value));
    }
    for (name, value) in judge.header_values(at) {
        scope = scope.with(name, Parametric::from_rational(&value));
    }
    scope.with(parameter, Parametric::variable())
}

/// The constants of a scheme as functions of a parameter: piecewise polynomial if the mask is.
pub(crate) struct Constants<'a> {
    pub(crate) coefficients: Coefficients<'a, Parametric>,
    /// How the formula is read.
    pub(crate) settings: Option<&'a Settings>,
    /// The interval of the parameter on which the constants have to be exact; `None` for all
    /// values.
    pub(crate) window: Option<&'a (Rational, Rational)>,
}

impl<'a> Constants<'a> {
    pub(crate) fn of(coefficients: Coefficients<'a, Parametric>) -> Constants<'a> {
        Constants { coefficients, settings: None, window: None }
    }
}

impl Functions<Parametric> for Constants<'_> {
    fn call(
        &self,
        call: &Call<'_, Parametric>,
        context: &dyn Context<Parametric>,
    ) -> Result<Parametric, CallError> {
        let mut options = Options::new(call);
        if let Some(settings) = self.settings {
            options = options.read_as(settings);
        }
        if let Some(value) =
            series::call(call, context, &mut options, &self.coefficients.shapes.norms, None)
        {
            return options.finished(value?);
        }
        let found = self.coefficients.shape(call, &mut options, context)?;
        let mask = &found.mask;
        let value = match (call.function, call.arguments) {
            ("contraction", c @ ([] | [_])) => {
                let (order, terms) = (options.order()?, options.terms()?);
                let difference = found.difference();
                match (terms, levels(c)?) {
                    (Terms::Each, c) => self.norm(difference, c, order)?,
                    (Terms::Total, 1) => total_contraction(difference),
                    (Terms::Total, _) => {
                        let message = "`terms = total` is defined for c = 1 only";
                        return Err(CallError::Misuse(message.to_owned()));
                    }
                }
            }
            ("norm", c @ ([] | [_])) => {
                let order = options.order()?;
                self.norm(mask.rules(), levels(c)?, order)?
            }
            ("displacement", []) => moved(mask, &mut options, || None)?,
            ("tensor", c @ ([] | [_])) => {
                let (order, suprema, c) = (options.order()?, options.suprema()?, levels(c)?);
                match suprema {
                    Suprema::Independent => {
                        let norm = self.norm(found.difference(), c, order)?;
                        norm.times(&self.norm(mask.rules(), c, order)?)
                    }
                    Suprema::Joint => self.joint([found.difference(), mask.rules()], c, order)?,
                }
            }
            (name, _) if NO_FUNCTIONS.contains(&name) => {
                let message = format!("`{name}` is not computed as a function of a free parameter");
                return Err(CallError::Misuse(message));
            }
            _ => {
                let other = |name: &str| self.coefficients.named(call.function, name, context);
                let known = &self.coefficients.shapes.library().limits;
                shape(mask, || found.difference(), call, &mut options, (other, known))?
            }
        };
        options.finished(value)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.coefficients.is_scheme(function, name)
    }
}

impl Constants<'_> {
    /// The rules with the numbers of the points that the reading says, if they are read forwards.
    fn numbered<'r>(
        &self,
        rules: &'r Rules<Parametric>,
        order: Order,
    ) -> Cow<'r, Rules<Parametric>> {
        let first = self.settings.map_or(0, |settings| settings.first) % rules.arity();
        match order {
            Order::Forward if first > 0 => Cow::Owned(rules.numbered_from(first)),
            Order::Forward | Order::Adjoint => Cow::Borrowed(rules),
        }
    }

    /// ‖Rᶜ‖_∞ as a function of the parameter: for polynomial rules by [`norm_function`], and for c
    /// ≤ 1 also for rules with |·| or max in them.
    fn norm(
        &self,
        rules: &Rules<Parametric>,
        c: u32,
        order: Order,
    ) -> Result<Parametric, CallError> {
        let rules = &*self.numbered(rules, order);
        if let Some(rules) = polynomial(rules) {
            let function = match self.window {
                None => norm_function(&rules, c, order),
                Some(window) => norm_function_on(&rules, c, order, window),
            };
            return function.map(Parametric::Function).map_err(|error| undefined(&error));
        }
        match c {
            0 | 1 => power_norm_generic(rules, c, order)
                .map_err(|error| CallError::BeyondCap(error.cap())),
            c => Err(CallError::Misuse(format!(
                "the norm of {c} levels needs a mask that is polynomial in the free parameter"
            ))),
        }
    }

    /// The product of two norms, maximised over a common row.
    fn joint(
        &self,
        rules: [&Rules<Parametric>; 2],
        c: u32,
        order: Order,
    ) -> Result<Parametric, CallError> {
        let misuse = |message: &str| CallError::Misuse(message.to_owned());
        let window = self.window.ok_or_else(|| {
            misuse("joint suprema are not computed as a function of a free parameter")
        })?;
        let rules = rules.map(|rules| self.numbered(rules, order));
        let [Some(first), Some(second)] = rules.each_ref().map(|rules| polynomial(rules)) else {
            return Err(misuse("joint suprema need a mask that is polynomial in the parameter"));
        };
        let function = joint_norm_function_on([&first, &second], c, order, window);
        function.map(Parametric::Function).map_err(|error| undefined(&error))
    }
}

/// Rules whose coefficients are polynomials.
pub(crate) fn polynomial(rules: &Rules<Parametric>) -> Option<Rules<RationalPolynomial>> {
    let all = rules.rows().iter().flatten().all(|entry| one_piece(entry).is_some());
    let zero = || RationalPolynomial::constant(Rational::zero());
    all.then(|| rules.map(|entry| one_piece(entry).unwrap_or_else(zero)))
}

/// The polynomial that a function is, if it is one.
pub(crate) fn one_piece(entry: &Parametric) -> Option<RationalPolynomial> {
    match entry.function()?.pieces() {
        [only] => Some(only.clone()),
        _ => None,
    }
}

fn undefined(error: &RangeError) -> CallError {
    error.cap().map_or_else(|| CallError::Undefined(error.to_string()), CallError::BeyondCap)
}
