//! Angles: what stands inside `cos`.

use super::ast::{Expr, Node, Operator, OptionWord, Span};
use super::builtin::{self, COSINE, apply};
use super::error::{FormulaError, FormulaErrorKind};
use super::evaluate::{Evaluator, fail};
use super::value::Value;
use crate::exact::Rational;

/// The name of π, which formulas may use inside `cos` only.
pub const PI: &str = "pi";

/// a + bπ.
struct Angle<V> {
    plain: V,
    pi: V,
}

impl<V: Value> Angle<V> {
    fn combine(
        operator: Operator,
        left: &Angle<V>,
        right: &Angle<V>,
    ) -> Result<Angle<V>, FormulaErrorKind> {
        let each = |left: &Angle<V>, factor: &V| {
            let plain = apply(operator, left.plain.clone(), factor)?;
            Ok(Angle { plain, pi: apply(operator, left.pi.clone(), factor)? })
        };
        match operator {
            Operator::Add | Operator::Subtract => Ok(Angle {
                plain: apply(operator, left.plain.clone(), &right.plain)?,
                pi: apply(operator, left.pi.clone(), &right.pi)?,
            }),
            Operator::Multiply | Operator::Divide if is_zero(&right.pi) => each(left, &right.plain),
            Operator::Multiply if is_zero(&left.pi) => each(right, &left.plain),
            Operator::Multiply => Err(FormulaErrorKind::Angle("a multiple of pi^2".to_owned())),
            Operator::Divide => Err(FormulaErrorKind::Angle("divided by pi".to_owned())),
        }
    }

    /// b, if a = 0 and b is rational.
    fn multiple(&self) -> Result<Rational, FormulaErrorKind> {
        let refuse = |text: String| Err(FormulaErrorKind::Angle(text));
        match self.pi.as_rational() {
            None => refuse(format!("({})*pi", self.pi)),
            Some(multiple) if is_zero(&self.plain) => Ok(multiple),
            Some(multiple) if multiple.is_zero() => refuse(self.plain.to_string()),
            Some(multiple) => refuse(format!("{} + {multiple}*pi", self.plain)),
        }
    }
}

fn is_zero<V: Value>(value: &V) -> bool {
    value.as_rational().is_some_and(|value| value.is_zero())
}

impl<V: Value> Evaluator<'_, V> {
    /// cos of its one argument.
    pub(super) fn cosine(
        &self,
        arguments: &[Expr],
        options: &[OptionWord],
        span: &Span,
        indices: &mut Vec<(String, V)>,
    ) -> Result<V, FormulaError> {
        let [argument] = arguments else {
            return fail(builtin::wrong_count(COSINE, arguments.len()), span);
        };
        if let Some(option) = options.first() {
            return fail(builtin::no_option(COSINE, option), span);
        }
        let angle = self.angle(argument, indices)?;
        let multiple = angle.multiple().or_else(|kind| fail(kind, &argument.span))?;
        let turn = multiple / Rational::from(2);
        V::cosine(&turn).or_else(|error| fail(error.into(), span))
    }

    /// The value of an expression in which `pi` may stand, in sums, in products
    /// and above a division bar. What has no `pi` is any expression.
    fn angle(&self, expr: &Expr, indices: &mut Vec<(String, V)>) -> Result<Angle<V>, FormulaError> {
        match &expr.node {
            Node::Name(name) if name == PI => {
                let pi = self.spend(V::from_rational(&Rational::one()), &expr.span)?;
                Ok(Angle { plain: V::zero(), pi })
            }
            Node::Negate(operand) => {
                let Angle { plain, pi } = self.angle(operand, indices)?;
                Ok(Angle { plain: V::zero().minus(&plain), pi: V::zero().minus(&pi) })
            }
            Node::Chain(first, rest) => {
                let mut angle = self.angle(first, indices)?;
                for (operator, operand) in rest {
                    let right = self.angle(operand, indices)?;
                    let result = Angle::combine(*operator, &angle, &right);
                    angle = result.or_else(|kind| fail(kind, &operand.span))?;
                    angle.plain = self.spend(angle.plain, &operand.span)?;
                    angle.pi = self.spend(angle.pi, &operand.span)?;
                }
                Ok(angle)
            }
            _ => Ok(Angle { plain: self.value(expr, indices)?, pi: V::zero() }),
        }
    }
}
