//! From tree to value.

use super::ast::{Expr, Node, Operator, OptionWord, Span};
use super::builtin;
use super::error::{CallError, FormulaError, FormulaErrorKind};
use super::value::Value;
use crate::exact::Rational;
use std::cell::Cell;
use std::collections::BTreeMap;

/// The most nodes that one evaluation visits, sums unrolled.
const MAX_STEPS: u64 = 1_000_000;

/// What a name means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lookup<V> {
    /// It has this value.
    Found(V),
    /// It exists, but nobody has said its value.
    Unstated,
    /// There is no such name.
    Unknown,
}

/// A call of a function that is not the language's own.
pub struct Call<'a, V> {
    /// The function's name.
    pub function: &'a str,
    /// Its arguments, evaluated.
    pub arguments: &'a [V],
    /// Its options, as written.
    pub options: &'a [OptionWord],
    /// The sum indices in force where it is called, innermost first.
    pub indices: &'a [(String, V)],
}

/// Names and functions beyond the language's own.
pub trait Context<V> {
    /// The meaning of a name.
    ///
    /// # Errors
    /// When the name stands for a formula, and that has no value.
    fn name(&self, name: &str, indices: &[(String, V)]) -> Result<Lookup<V>, CallError>;

    /// The names that [`Context::name`] knows, for error messages.
    fn names(&self) -> Vec<String>;

    /// The value of a function.
    ///
    /// # Errors
    /// When there is no such function, or no such value.
    fn call(&self, call: &Call<'_, V>) -> Result<V, CallError> {
        let _ = call;
        Err(CallError::UnknownFunction(Vec::new()))
    }
}

/// The plain context: parameters with values, and no functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters<V = Rational>(pub BTreeMap<String, V>);

impl<V> Default for Parameters<V> {
    fn default() -> Parameters<V> {
        Parameters(BTreeMap::new())
    }
}

impl<V, const N: usize> From<[(&str, V); N]> for Parameters<V> {
    fn from(pairs: [(&str, V); N]) -> Parameters<V> {
        Parameters(pairs.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }
}

impl<V: Value> Context<V> for Parameters<V> {
    fn name(&self, name: &str, _: &[(String, V)]) -> Result<Lookup<V>, CallError> {
        Ok(self.0.get(name).map_or(Lookup::Unknown, |value| Lookup::Found(value.clone())))
    }
    fn names(&self) -> Vec<String> {
        self.0.keys().cloned().collect()
    }
}

/// The value of a formula.
///
/// # Errors
/// When a name or function is unknown or unstated, a value does not exist, or a
/// cap (size of a power, length of a sum, total work) is reached.
pub fn evaluate<V: Value>(expr: &Expr, context: &dyn Context<V>) -> Result<V, FormulaError> {
    evaluate_with(expr, context, &[])
}

/// [`evaluate`] where the indices of surrounding sums have values.
pub(crate) fn evaluate_with<V: Value>(
    expr: &Expr,
    context: &dyn Context<V>,
    indices: &[(String, V)],
) -> Result<V, FormulaError> {
    let evaluator = Evaluator { context, steps: Cell::new(0) };
    evaluator.value(expr, &mut indices.to_vec())
}

struct Evaluator<'a, V> {
    context: &'a dyn Context<V>,
    steps: Cell<u64>,
}

fn fail<T>(kind: FormulaErrorKind, span: &Span) -> Result<T, FormulaError> {
    Err(FormulaError { kind, span: span.clone() })
}

impl<V: Value> Evaluator<'_, V> {
    fn value(&self, expr: &Expr, indices: &mut Vec<(String, V)>) -> Result<V, FormulaError> {
        self.steps.set(self.steps.get() + 1);
        if self.steps.get() > MAX_STEPS {
            let kind =
                FormulaErrorKind::TooLarge { what: "the work of this formula", cap: MAX_STEPS };
            return fail(kind, &expr.span);
        }
        match &expr.node {
            Node::Number(number) => Ok(V::from_rational(number)),
            Node::Name(name) => self.name(name, &expr.span, indices),
            Node::Negate(operand) => Ok(V::zero().minus(&self.value(operand, indices)?)),
            Node::Chain(first, rest) => {
                let mut value = self.value(first, indices)?;
                for (operator, operand) in rest {
                    let right = self.value(operand, indices)?;
                    value = apply(*operator, &value, &right)
                        .or_else(|kind| fail(kind, &operand.span))?;
                }
                Ok(value)
            }
            Node::Power(base, exponent) => {
                let base = self.value(base, indices)?;
                let power = self.value(exponent, indices)?;
                builtin::power(&base, &power).or_else(|kind| fail(kind, &expr.span))
            }
            Node::Call { function, arguments, options } => {
                let arguments = arguments
                    .iter()
                    .map(|argument| self.value(argument, indices))
                    .collect::<Result<Vec<V>, FormulaError>>()?;
                self.call(function, &arguments, options, indices)
                    .or_else(|kind| fail(kind, &expr.span))
            }
            Node::Sum { index, from, to, body } => {
                let first = self.integer("the first index of a sum", from, indices)?;
                let last = self.integer("the last index of a sum", to, indices)?;
                let mut total = V::zero();
                for i in first..=last {
                    indices.insert(0, (index.clone(), V::from_rational(&Rational::from(i))));
                    let term = self.value(body, indices);
                    indices.remove(0);
                    total = total.plus(&term?);
                }
                Ok(total)
            }
        }
    }

    fn name(&self, name: &str, span: &Span, indices: &[(String, V)]) -> Result<V, FormulaError> {
        if let Some((_, value)) = indices.iter().find(|(index, _)| index == name) {
            return Ok(value.clone());
        }
        match self.context.name(name, indices) {
            Ok(Lookup::Found(value)) => Ok(value),
            Ok(Lookup::Unstated) => fail(FormulaErrorKind::Unstated(name.to_owned()), span),
            Ok(Lookup::Unknown) => {
                let known = self.context.names();
                fail(FormulaErrorKind::UnknownName { name: name.to_owned(), known }, span)
            }
            Err(error) => fail(kind_of(error, name), span),
        }
    }

    fn integer(
        &self,
        what: &'static str,
        expr: &Expr,
        indices: &mut Vec<(String, V)>,
    ) -> Result<i64, FormulaError> {
        let value = self.value(expr, indices)?;
        builtin::integer(what, &value).or_else(|kind| fail(kind, &expr.span))
    }

    fn call(
        &self,
        function: &str,
        arguments: &[V],
        options: &[OptionWord],
        indices: &[(String, V)],
    ) -> Result<V, FormulaErrorKind> {
        if let Some(value) = builtin::call(function, arguments, options) {
            return value;
        }
        let call = Call { function, arguments, options, indices };
        self.context.call(&call).map_err(|error| kind_of(error, function))
    }
}

fn kind_of(error: CallError, name: &str) -> FormulaErrorKind {
    match error {
        CallError::UnknownFunction(mut known) => {
            known.extend(builtin::NAMES.iter().map(|&name| name.to_owned()));
            FormulaErrorKind::UnknownFunction { name: name.to_owned(), known }
        }
        CallError::Misuse(message) => FormulaErrorKind::Call(message),
        CallError::Undefined(message) => FormulaErrorKind::Undefined(message),
        CallError::Inner(kind) => kind,
    }
}

fn apply<V: Value>(operator: Operator, left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    match operator {
        Operator::Add => Ok(left.plus(right)),
        Operator::Subtract => Ok(left.minus(right)),
        Operator::Multiply => builtin::multiply(left, right),
        Operator::Divide => builtin::divide(left, right),
    }
}
