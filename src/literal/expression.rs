//! Formulas of literals, computed exactly and as the program computes them.

use super::language::{Language, Precision};
use super::number::{Number, Type};
use crate::exact::Rational;
use crate::float::{nearest, nearest_f32};

/// A formula.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    Number(Number),
    Minus(Box<Expression>),
    /// A conversion to a type.
    Cast(Precision, Box<Expression>),
    Operation {
        sign: char,
        language: Language,
        sides: Box<[Expression; 2]>,
    },
}

/// A value as the program holds it.
#[derive(Clone, Debug)]
enum Held {
    Integer(Rational),
    Single(f32),
    Double(f64),
    Long(Rational),
}

impl Expression {
    /// The literal, if this is one, and whether a minus stands before it.
    pub(super) fn literal(&self) -> Option<(bool, &Number)> {
        match self {
            Expression::Number(number) => Some((false, number)),
            Expression::Minus(inner) => inner.literal().map(|(minus, number)| (!minus, number)),
            Expression::Cast(_, inner) => inner.literal(),
            Expression::Operation { .. } => None,
        }
    }

    /// The value without any rounding but that of a division of integers.
    pub(super) fn exact(&self) -> Option<Rational> {
        match self {
            Expression::Number(number) => Some(number.value.clone()),
            Expression::Minus(inner) => inner.exact().map(|value| -value),
            Expression::Cast(_, inner) => inner.exact(),
            Expression::Operation { sign, sides, .. } => {
                let [left, right] = [sides[0].exact()?, sides[1].exact()?];
                let truncates = self.is_integer();
                operate(*sign, left, right, truncates)
            }
        }
    }

    /// Whether the language computes with integers here.
    fn is_integer(&self) -> bool {
        match self {
            Expression::Number(number) => number.kind == Type::Integer,
            Expression::Minus(inner) => inner.is_integer(),
            Expression::Cast(..) => false,
            Expression::Operation { sign, language, sides } => {
                let quotient = *sign == '/' && !language.truncates();
                !quotient && sides.iter().all(Expression::is_integer)
            }
        }
    }

    /// The value that a table of this precision gets.
    pub(super) fn held(&self, precision: Precision) -> f64 {
        self.evaluate(precision).to(precision)
    }

    fn evaluate(&self, table: Precision) -> Held {
        match self {
            Expression::Number(number) => match number.kind {
                Type::Integer => Held::Integer(number.value.clone()),
                Type::Long => Held::Long(number.value.clone()),
                Type::Float(precision) => Held::new(&number.value, precision),
                Type::Table => Held::new(&number.value, table),
            },
            Expression::Minus(inner) => match inner.evaluate(table) {
                Held::Integer(value) => Held::Integer(-value),
                Held::Single(value) => Held::Single(-value),
                Held::Double(value) => Held::Double(-value),
                Held::Long(value) => Held::Long(-value),
            },
            Expression::Cast(precision, inner) => {
                let value = inner.evaluate(table).to(*precision);
                Held::rounded(value, *precision)
            }
            Expression::Operation { sign, language, sides } => {
                let [left, right] = [sides[0].evaluate(table), sides[1].evaluate(table)];
                compute(*sign, &left, &right, *language)
            }
        }
    }
}

impl Language {
    /// Whether a quotient of integers is an integer.
    fn truncates(self) -> bool {
        matches!(self, Language::C | Language::Shader)
    }
}

impl Held {
    fn new(value: &Rational, precision: Precision) -> Held {
        match precision {
            Precision::Single => Held::Single(nearest_f32(value)),
            Precision::Double => Held::Double(nearest(value)),
        }
    }

    fn rounded(value: f64, precision: Precision) -> Held {
        match precision {
            Precision::Single => Held::Single(single(value)),
            Precision::Double => Held::Double(value),
        }
    }

    fn to(&self, precision: Precision) -> f64 {
        match (self, precision) {
            (Held::Integer(value) | Held::Long(value), Precision::Single) => {
                f64::from(nearest_f32(value))
            }
            (Held::Integer(value) | Held::Long(value), Precision::Double) => nearest(value),
            (Held::Single(value), _) => f64::from(*value),
            (Held::Double(value), Precision::Single) => f64::from(single(*value)),
            (Held::Double(value), Precision::Double) => *value,
        }
    }
}

/// The f32 nearest to an f64, half to even.
#[expect(clippy::cast_possible_truncation, reason = "rounding is what the program does")]
fn single(value: f64) -> f32 {
    value as f32
}

fn compute(sign: char, left: &Held, right: &Held, language: Language) -> Held {
    match (left, right) {
        (Held::Integer(x), Held::Integer(y)) if sign != '/' || language.truncates() => {
            match operate(sign, x.clone(), y.clone(), true) {
                Some(value) => Held::Integer(value),
                None => Held::Double(f64::NAN),
            }
        }
        (Held::Single(_), Held::Single(_) | Held::Integer(_))
        | (Held::Integer(_), Held::Single(_)) => {
            // With 24 bits of 53, one operation in f64 and one rounding give the right f32.
            let [x, y] = [left.to(Precision::Single), right.to(Precision::Single)];
            Held::Single(single(arithmetic(sign, x, y)))
        }
        _ => {
            Held::Double(arithmetic(sign, left.to(Precision::Double), right.to(Precision::Double)))
        }
    }
}

fn arithmetic(sign: char, x: f64, y: f64) -> f64 {
    match sign {
        '+' => x + y,
        '-' => x - y,
        '*' => x * y,
        _ => x / y,
    }
}

/// The exact result; `None` of a division by zero.
fn operate(sign: char, x: Rational, y: Rational, truncates: bool) -> Option<Rational> {
    Some(match sign {
        '+' => x + y,
        '-' => x - y,
        '*' => x * y,
        _ if y.is_zero() => return None,
        _ if truncates => {
            let quotient = (x / y).clone();
            let size = quotient.abs();
            let (whole, _) = size.numerator().div_rem_floor(&size.denominator());
            let whole = Rational::from(whole);
            if quotient.sign() < 0 { -whole } else { whole }
        }
        _ => x / y,
    })
}
