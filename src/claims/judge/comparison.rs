//! The values of the sides of an identity, in one case of its indices.

use crate::claim::{Hypothesis, Identity, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::identities::families::{Families, is_open};
use crate::evaluation::identities::integer_functions::IntegerFunctions;
use crate::evaluation::identities::real_formulas::Reals;
use crate::evaluation::reference;
use crate::evaluation::shape::{Coefficients, Own, Shapes, own_shape};
use crate::exact::{AlgebraicNumber, IntegerFunction, Polynomial, Rational};
use crate::finding::SideValue;
use crate::formula::{
    CallError, Context as _, Expr, FormulaError, Functions, LocatedFormula, RealValue, Scope,
    Value, Work, evaluate,
};
use crate::judge::cases::Case;
use crate::judge::hypotheses;
use std::cell::Cell;
use std::collections::BTreeMap;

/// An identity with what its formulas refer to.
pub(crate) struct Sides<'a> {
    pub(crate) paper: &'a Paper,
    pub(crate) identity: &'a Identity,
    pub(crate) shapes: &'a Shapes<'a, Polynomial>,
    /// The schemes whose masks are over other real fields.
    pub(crate) in_fields: &'a Shapes<'a, AlgebraicNumber>,
    /// The values that the paper states, for a relation, without those that its own names hide.
    pub(crate) given: BTreeMap<String, Rational>,
    /// The steps of all evaluations so far.
    pub(crate) spent: Cell<u64>,
}

impl Sides<'_> {
    /// The value of `expr`, which stands in `formula` or instead of it.
    pub(crate) fn value(
        &self,
        formula: &LocatedFormula,
        expr: &Expr,
        case: &Case,
    ) -> Result<Polynomial, Diagnostic> {
        let value = self.evaluated(expr, case)?;
        value.map_err(|error| formula.diagnostic(&error))
    }

    /// The value of a side: a polynomial, or a real number where it is none and there are no symbols.
    pub(crate) fn side(
        &self,
        formula: &LocatedFormula,
        case: &Case,
    ) -> Result<SideValue, Diagnostic> {
        let found = self.evaluated(&formula.expr, case);
        let error = match found {
            Ok(Ok(value)) => return Ok(SideValue::Polynomial(value)),
            Ok(Err(error)) if error.kind.is_other_real() && self.is_of_numbers(case) => {
                return self.real(formula, case).map(SideValue::Real);
            }
            Ok(Err(error)) => formula.diagnostic(&error),
            Err(error) => error,
        };
        // The mask may have coefficients in another real field.
        if error.cap.is_some() || !self.is_of_numbers(case) {
            return Err(error);
        }
        self.real(formula, case).map(SideValue::Real)
    }

    /// Whether the sides have neither symbols nor hypotheses about them, and every index has a value.
    fn is_of_numbers(&self, case: &Case) -> bool {
        let Identity { symbols, hypotheses, states, .. } = self.identity;
        states.is_some() && case.symbolic.is_empty() && symbols.is_empty() && hypotheses.is_empty()
    }

    /// The names with numbers as values.
    fn numbers<'s, V: Value>(
        &'s self,
        case: &'s Case,
        functions: &'s dyn Functions<V>,
    ) -> Scope<'s, V> {
        let mut scope = Scope::new(&self.paper.definitions, functions);
        let values = case.values.iter().map(|(name, value)| (name, value));
        for (name, value) in self.given.iter().chain(values) {
            scope = scope.with(name, V::from_rational(value));
        }
        scope
    }

    /// The value of a side as a real number.
    fn real(&self, formula: &LocatedFormula, case: &Case) -> Result<RealValue, Diagnostic> {
        let own = self.own(case).ok();
        let coefficients = own.map(|own| Coefficients { shapes: self.shapes, own });
        let in_fields = || {
            let own = self.own_in_field(case);
            let own = own.map_err(|error| CallError::Misuse(error.message.clone()))?;
            Ok(Coefficients { shapes: self.in_fields, own })
        };
        let functions = Reals { coefficients: coefficients.as_ref(), in_fields: &in_fields };
        let scope = self.numbers(case, &functions);
        let value = evaluate(&formula.expr, &scope);
        self.spend(scope.work());
        value.map_err(|error| formula.diagnostic(&error))
    }

    /// The functions of formulas in which an index stands for all integers from one on.
    pub(crate) fn in_family<'s>(
        &'s self,
        case: &Case,
        (index, first): (&'s str, i64),
    ) -> Result<Families<'s>, Diagnostic> {
        let none = Coefficients { shapes: self.shapes, own: None };
        let own = match &self.identity.scheme {
            None => None,
            Some(located) => {
                let scope = self.scope(case, &none, &|name: &str| Polynomial::variable(name))?;
                let found = self.shapes.library().instances(&located.reference, &scope);
                let found = found.map_err(|error| reference::located(located, &error))?;
                Some(found).filter(|scheme| is_open(scheme))
            }
        };
        let fixed = if own.is_some() { None } else { self.own(case)? };
        let others = Coefficients { shapes: self.shapes, own: fixed };
        Ok(Families { others, own, index, first })
    }

    /// The value of a formula with these functions.
    pub(crate) fn value_with(
        &self,
        functions: &dyn Functions<Polynomial>,
        formula: &LocatedFormula,
        case: &Case,
    ) -> Result<Polynomial, Diagnostic> {
        let scope = self.scope(case, functions, &|name: &str| Polynomial::variable(name))?;
        let value = evaluate(&formula.expr, &scope);
        self.spend(scope.work());
        value.map_err(|error| formula.diagnostic(&error))
    }

    /// The values of some formulas for all integers from `first` on, which the one index without a value has; `None` where one is not known.
    pub(crate) fn for_integers<'f>(
        &self,
        formulas: impl Iterator<Item = &'f LocatedFormula>,
        case: &Case,
        first: i64,
    ) -> Option<Vec<IntegerFunction>> {
        let [(name, least)] = &case.symbolic[..] else { return None };
        let shapes = Shapes::with_filters(self.shapes.library());
        let index = IntegerFunction::index(first);
        let none = Coefficients { shapes: &shapes, own: None };
        let own = match &self.identity.scheme {
            None => None,
            Some(located) => {
                let scope = self.numbers(case, &none).with(name, index.clone());
                Some(shapes.library().instances(&located.reference, &scope).ok()?)
            }
        };
        let fixed = own.as_ref().filter(|scheme| !is_open(scheme));
        let fixed = fixed.map(|scheme| shapes.scheme(scheme)).transpose().ok()?;
        let families = self.in_family(case, (name, *least)).ok()?;
        let others = Coefficients { shapes: &shapes, own: fixed };
        let functions = IntegerFunctions { others, families, own, first };
        let scope = self.numbers(case, &functions).with(name, index);
        let value = |formula: &LocatedFormula| {
            let value = evaluate(&formula.expr, &scope);
            self.spend(scope.work());
            value.ok()
        };
        formulas.map(value).collect()
    }

    fn spend(&self, work: Option<&Work>) {
        let spent = work.map_or(0, Work::spent);
        self.spent.set(self.spent.get().saturating_add(spent));
    }

    /// The scheme of the claim.
    fn own(&self, case: &Case) -> Result<Option<Own<Polynomial>>, Diagnostic> {
        let member = |name: &str| Polynomial::variable(name);
        let none = Coefficients { shapes: self.shapes, own: None };
        let Some(located) = &self.identity.scheme else { return Ok(None) };
        let scope = self.scope(case, &none, &member)?;
        own_shape(self.shapes, located, &scope).map(Some)
    }

    /// The scheme of the claim, with a mask over any real field.
    fn own_in_field(&self, case: &Case) -> Result<Option<Own<AlgebraicNumber>>, Diagnostic> {
        let none = Coefficients { shapes: self.in_fields, own: None };
        let Some(located) = &self.identity.scheme else { return Ok(None) };
        own_shape(self.in_fields, located, &self.numbers(case, &none)).map(Some)
    }

    fn evaluated(
        &self,
        expr: &Expr,
        case: &Case,
    ) -> Result<Result<Polynomial, FormulaError>, Diagnostic> {
        let member = |name: &str| Polynomial::variable(name);
        let functions = Coefficients { shapes: self.shapes, own: self.own(case)? };
        let scope = self.scope(case, &functions, &member)?;
        let value = evaluate(expr, &scope);
        self.spend(scope.work());
        Ok(value)
    }

    /// Whether the scheme of the claim has numbers for parameters in this case.
    pub(crate) fn has_scheme_of_numbers(&self, case: &Case) -> Result<bool, Diagnostic> {
        let Some(located) = &self.identity.scheme else { return Ok(true) };
        let none = Coefficients { shapes: self.shapes, own: None };
        let scope = self.scope(case, &none, &|name: &str| Polynomial::variable(name))?;
        let instances = self.shapes.library().instances(&located.reference, &scope);
        let instances = instances.map_err(|error| reference::located(located, &error))?;
        Ok(!is_open(&instances))
    }

    fn scope<'s>(
        &'s self,
        case: &'s Case,
        functions: &'s dyn Functions<Polynomial>,
        member: &'s dyn Fn(&str) -> Polynomial,
    ) -> Result<Scope<'s, Polynomial>, Diagnostic> {
        let identity = self.identity;
        let plain = || {
            // The names of symbols and indices hide those that are given; no two of them are the same.
            let mut scope = self.numbers(case, functions);
            for symbol in &identity.symbols {
                let variable = Polynomial::variable(symbol);
                scope = scope.with(symbol, variable).with_family(symbol, member);
            }
            for (name, _) in &case.symbolic {
                scope = scope.with(name, Polynomial::variable(name));
            }
            scope
        };
        // The members of a family that hypotheses name are symbols while these are solved.
        let mut symbols = plain();
        for family in identity.hypotheses.iter().filter_map(Hypothesis::family) {
            symbols = symbols.with_family(family, member);
        }
        let solved = hypotheses::solve(&identity.hypotheses, &symbols)?;
        let mut scope = plain();
        for (name, value) in solved {
            // The value may not depend on a member of a family that only hypotheses name.
            let unknown = value.linear().into_iter().flatten().find(|name| {
                let family = name.split_once('[').map(|(family, _)| family);
                family.is_some_and(|family| identity.symbols.iter().all(|known| known != family))
            });
            if let Some(unknown) = unknown {
                let right = identity.first().right();
                let message = format!("the hypotheses leave `{unknown}` open");
                return Err(Diagnostic::new(&right.source, right.span.clone(), message)
                    .with_help("give it a value too, or name its family in `symbols`"));
            }
            scope = scope.with(name, value);
        }
        Ok(scope)
    }
}
