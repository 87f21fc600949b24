//! Formulas of literals, computed exactly and as the program computes them.

use super::language::{Language, Precision};
use super::number::{Number, Type};
use super::whole::Whole;
use crate::exact::Rational;
use crate::float::{exact, nearest, nearest_f32};

/// A formula.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    Number(Number),
    /// The result of operations on integers.
    Whole(Whole),
    /// The same value with the other sign.
    Minus(Box<Expression>),
    /// A conversion to a type.
    Cast(Precision, Box<Expression>),
    /// An operation on floating-point numbers, or a quotient of Python's integers.
    Operation {
        sign: char,
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
    /// A literal without a type, which is that of the numbers beside it.
    Literal(f64),
}

impl Expression {
    /// −x.
    pub(super) fn minus(self) -> Result<Expression, String> {
        if let Some(whole) = self.whole() {
            let value = -whole.value.clone();
            let negated = whole.negated()?;
            if negated.value != value {
                return Ok(Expression::Whole(negated));
            }
        }
        Ok(Expression::Minus(Box::new(self)))
    }

    /// An operation; the error says why it is not computed.
    pub(super) fn operation(
        sign: char,
        left: Expression,
        right: Expression,
        language: Language,
    ) -> Result<Expression, String> {
        if left.is_long() || right.is_long() {
            return Err("arithmetic of long doubles depends on the machine".to_owned());
        }
        match (left.whole(), right.whole()) {
            (Some(x), Some(y)) if sign != '/' || language.truncates() => {
                Ok(Expression::Whole(x.operate(sign, y)?))
            }
            (Some(_), Some(y)) if y.value.is_zero() => Err("a division by zero".to_owned()),
            _ => Ok(Expression::Operation { sign, sides: Box::new([left, right]) }),
        }
    }

    /// The integer, if the language computes with integers here.
    fn whole(&self) -> Option<Whole> {
        match self {
            Expression::Number(number) => match number.kind {
                Type::Integer(width) => Some(Whole { value: number.value.numerator(), width }),
                _ => None,
            },
            Expression::Whole(whole) => Some(whole.clone()),
            Expression::Minus(inner) => {
                inner.whole().map(|whole| Whole { value: -whole.value, ..whole })
            }
            Expression::Cast(..) | Expression::Operation { .. } => None,
        }
    }

    fn is_long(&self) -> bool {
        match self {
            Expression::Number(number) => number.kind == Type::Long,
            Expression::Minus(inner) => inner.is_long(),
            _ => false,
        }
    }

    /// Whether a table of this precision gets another number where the compiler rounds literals to doubles first.
    pub(super) fn depends_on_compiler(&self, precision: Precision) -> bool {
        let [narrow, wide] = [false, true].map(|wide| self.evaluate(precision, wide).to(precision));
        narrow.to_bits() != wide.to_bits()
    }

    /// Whether the number that a table of floating-point numbers gets depends on the machine: a `long double` is rounded to
    /// 53, 64 or 113 binary digits before.
    pub(super) fn depends_on_machine(&self) -> bool {
        match self {
            Expression::Number(number) => {
                number.kind == Type::Long
                    && exact(nearest(&number.value)).as_ref() != Some(&number.value)
            }
            Expression::Minus(inner) | Expression::Cast(_, inner) => inner.depends_on_machine(),
            Expression::Operation { sides, .. } => sides.iter().any(Expression::depends_on_machine),
            Expression::Whole(_) => false,
        }
    }

    /// The literal, if this is one, and whether a minus stands before it.
    pub(super) fn literal(&self) -> Option<(bool, &Number)> {
        match self {
            Expression::Number(number) => Some((false, number)),
            Expression::Minus(inner) => inner.literal().map(|(minus, number)| (!minus, number)),
            Expression::Cast(_, inner) => inner.literal(),
            Expression::Whole(_) | Expression::Operation { .. } => None,
        }
    }

    /// The value without any rounding; integers are computed as the language does.
    pub(super) fn exact(&self) -> Option<Rational> {
        match self {
            Expression::Number(number) => Some(number.value.clone()),
            Expression::Minus(inner) => inner.exact().map(|value| -value),
            Expression::Cast(_, inner) => inner.exact(),
            Expression::Whole(whole) => Some(whole.value.clone().into()),
            Expression::Operation { sign, sides } => {
                operate(*sign, sides[0].exact()?, sides[1].exact()?)
            }
        }
    }

    /// The value that a table of this precision gets.
    pub(super) fn held(&self, precision: Precision) -> f64 {
        self.evaluate(precision, false).to(precision)
    }

    /// The value; `wide` where the compiler rounds literals that may be either to doubles.
    fn evaluate(&self, table: Precision, wide: bool) -> Held {
        match self {
            Expression::Number(number) => match number.kind {
                Type::Integer(_) => Held::Integer(number.value.clone()),
                Type::Long => Held::Long(number.value.clone()),
                Type::Float(precision) => Held::new(&number.value, precision),
                Type::Table => Held::new(&number.value, table),
                Type::Either { .. } if !wide => Held::new(&number.value, Precision::Single),
                Type::Either { typed: true } => Held::Single(single(nearest(&number.value))),
                Type::Either { typed: false } => Held::Literal(nearest(&number.value)),
            },
            Expression::Whole(whole) => Held::Integer(whole.value.clone().into()),
            Expression::Minus(inner) => match inner.evaluate(table, wide) {
                Held::Integer(value) => Held::Integer(-value),
                Held::Single(value) => Held::Single(-value),
                Held::Double(value) => Held::Double(-value),
                Held::Long(value) => Held::Long(-value),
                Held::Literal(value) => Held::Literal(-value),
            },
            Expression::Cast(precision, inner) => {
                let value = inner.evaluate(table, wide).to(*precision);
                Held::rounded(value, *precision)
            }
            Expression::Operation { sign, sides } => {
                compute(*sign, &sides[0].evaluate(table, wide), &sides[1].evaluate(table, wide))
            }
        }
    }
}

impl Language {
    /// Whether a quotient of integers is an integer.
    fn truncates(self) -> bool {
        self.is_native() || self == Language::Wgsl
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
            (Held::Double(value) | Held::Literal(value), Precision::Single) => {
                f64::from(single(*value))
            }
            (Held::Double(value) | Held::Literal(value), Precision::Double) => *value,
        }
    }
}

/// The f32 nearest to an f64, half to even.
#[expect(clippy::cast_possible_truncation, reason = "rounding is what the program does")]
fn single(value: f64) -> f32 {
    value as f32
}

fn compute(sign: char, left: &Held, right: &Held) -> Held {
    match (left, right) {
        // Python rounds the quotient of two integers once.
        (Held::Integer(x), Held::Integer(y)) => {
            Held::Double(operate(sign, x.clone(), y.clone()).as_ref().map_or(f64::NAN, nearest))
        }
        (Held::Single(_), Held::Single(_) | Held::Integer(_) | Held::Literal(_))
        | (Held::Integer(_) | Held::Literal(_), Held::Single(_)) => {
            // With 24 bits of 53, one operation in f64 and one rounding give the right f32.
            let [x, y] = [left.to(Precision::Single), right.to(Precision::Single)];
            Held::Single(single(arithmetic(sign, x, y)))
        }
        _ => {
            let value = arithmetic(sign, left.to(Precision::Double), right.to(Precision::Double));
            let typed = [left, right].iter().any(|side| matches!(side, Held::Double(_)));
            if typed { Held::Double(value) } else { Held::Literal(value) }
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
fn operate(sign: char, x: Rational, y: Rational) -> Option<Rational> {
    Some(match sign {
        '+' => x + y,
        '-' => x - y,
        '*' => x * y,
        _ if y.is_zero() => return None,
        _ => x / y,
    })
}
