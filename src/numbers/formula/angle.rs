//! Angles: the arguments of `cos`.

use super::ast::Operator;
use super::builtin::apply;
use super::error::FormulaErrorKind;
use super::values::value::Value;
use crate::exact::Rational;

/// The name of π, which formulas may use only inside `cos`.
pub const PI: &str = "pi";

/// The angle a + bπ, with a = `plain` and b = `pi`.
pub(super) struct Angle<V> {
    pub(super) plain: V,
    pub(super) pi: V,
}

impl<V: Value> Angle<V> {
    /// left ∘ right for one of the four operations. An error for multiples of π² and for
    /// division by π.
    pub(super) fn combine(
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

    /// The cosine of an angle bπ; an error unless a = 0 and the type has this cosine.
    pub(super) fn cosine(&self) -> Result<V, FormulaErrorKind> {
        let refuse = |text: String| Err(FormulaErrorKind::Angle(text));
        match self.pi.as_rational() {
            None => {
                let half = V::from_rational(&Rational::new(1, 2));
                let turn = self.pi.times(&half);
                let cosine = Some(&turn).filter(|_| is_zero(&self.plain)).and_then(V::cosine_of);
                cosine.map_or_else(|| refuse(format!("({})*pi", self.pi)), Ok)
            }
            Some(multiple) if is_zero(&self.plain) => {
                Ok(V::cosine(&(multiple / Rational::from(2)))?)
            }
            Some(multiple) if multiple.is_zero() => refuse(self.plain.to_string()),
            Some(multiple) => refuse(format!("{} + {multiple}*pi", self.plain)),
        }
    }
}

fn is_zero<V: Value>(value: &V) -> bool {
    value.as_rational().is_some_and(|value| value.is_zero())
}
