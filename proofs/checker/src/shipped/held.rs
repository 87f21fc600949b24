//! Numbers as programs hold them, and operations on them.

use super::language::Language;
use super::rounding::{DOUBLE, Format, SINGLE, Type};
use super::whole::Whole;
use crate::numbers::Q;
use crate::text::Stop;
use num_traits::Zero;

/// The type of the table in which a number stands.
pub type Target = Type;

/// The type of a number in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An integer of this type.
    Integer(Whole),
    /// IEEE binary32.
    Single,
    /// IEEE binary64.
    Double,
    /// A double without a type, which is that of the numbers beside it.
    Literal,
    /// A `long double`, whose format depends on the machine.
    Long,
    /// The type of the table.
    Table,
    /// A number that is not rounded: in tables of decimals.
    Exact,
}

/// A number that a program holds.
#[derive(Clone, Debug)]
pub struct Held {
    /// The value; `None` if it is infinite or no number.
    value: Option<Q>,
    kind: Kind,
}

impl Kind {
    fn format(self) -> Option<Format> {
        match self {
            Kind::Single => Some(SINGLE),
            Kind::Double | Kind::Literal => Some(DOUBLE),
            _ => None,
        }
    }

    /// What it is in a table of this type.
    fn within(self, target: Target) -> Kind {
        match (self, target) {
            (Kind::Integer(_), _) => self,
            (_, Type::Decimal(_)) => Kind::Exact,
            (Kind::Table, Type::Binary(format)) if format == SINGLE => Kind::Single,
            (Kind::Table, _) => Kind::Double,
            (kind, _) => kind,
        }
    }
}

/// A value in this type, rounded half to even.
fn rounded(value: Q, kind: Kind) -> Option<Q> {
    match kind.format() {
        Some(format) => format.round(&value),
        None => Some(value),
    }
}

impl Held {
    /// A literal of this kind.
    pub fn new(value: Q, kind: Kind, target: Target) -> Held {
        let kind = kind.within(target);
        Held { value: rounded(value, kind), kind }
    }

    /// Whether this is a `long double` that is no double: what becomes of it depends on the machine.
    pub fn depends_on_machine(&self) -> bool {
        let double = |value: &Q| DOUBLE.round(value).as_ref() == Some(value);
        self.kind == Kind::Long && !self.value.as_ref().is_some_and(double)
    }

    /// −x.
    pub fn negated(self) -> Result<Held, Stop> {
        let value = self.value.map(|value| match self.kind {
            Kind::Integer(whole) => Ok(Q::from_integer(whole.wrapped(-value.to_integer())?)),
            _ => Ok(-value),
        });
        Ok(Held { value: value.transpose()?, kind: self.kind })
    }

    /// Whether this is an integer of another value, as a type without a sign holds it.
    pub fn is_integer_other_than(&self, value: &Q) -> bool {
        matches!(self.kind, Kind::Integer(_)) && self.value.as_ref() != Some(value)
    }

    /// The number as one of this kind.
    pub fn cast(self, kind: Kind, target: Target) -> Held {
        let kind = kind.within(target);
        Held { value: self.value.and_then(|value| rounded(value, kind)), kind }
    }

    /// The number that a table of this type gets; `None` if it is not finite.
    pub fn stored(self, target: Target) -> Option<Q> {
        match target {
            Type::Binary(format) => self.value.and_then(|value| format.round(&value)),
            Type::Decimal(_) => self.value,
        }
    }

    /// The result of an operation.
    pub fn operate(self, sign: char, right: Held, language: Language) -> Result<Held, Stop> {
        let kinds = [self.kind, right.kind];
        if kinds.contains(&Kind::Long) {
            return Err(Stop::Capped("arithmetic of long doubles depends on the machine"));
        }
        let (Some(x), Some(y)) = (self.value, right.value) else {
            return Err(Stop::Capped("arithmetic of numbers that are not finite"));
        };
        let integers = match kinds {
            [Kind::Integer(one), Kind::Integer(other)] => Some((one, other)),
            _ => None,
        };
        if let Some((one, other)) = integers.filter(|_| sign != '/' || language.truncates()) {
            let (whole, value) = one.operate(sign, &x, (other, &y))?;
            return Ok(Held { value: Some(value), kind: Kind::Integer(whole) });
        }
        let integers = integers.is_some();
        if integers && y.is_zero() {
            return Err(Stop::Undefined("it divides by 0"));
        }
        let kind = match kinds {
            _ if kinds.contains(&Kind::Exact) => Kind::Exact,
            _ if kinds.contains(&Kind::Double) || integers => Kind::Double,
            _ if kinds.contains(&Kind::Literal) && !kinds.contains(&Kind::Single) => Kind::Literal,
            _ => Kind::Single,
        };
        // An integer becomes a number of the type first, except in a quotient of two.
        let convert = |value: Q| if integers { Some(value) } else { rounded(value, kind) };
        let (Some(x), Some(y)) = (convert(x), convert(y)) else {
            return Err(Stop::Capped("arithmetic of numbers that are not finite"));
        };
        let value = match sign {
            '+' => x + y,
            '-' => x - y,
            '*' => x * y,
            _ if y.is_zero() => return Ok(Held { value: None, kind }),
            _ => x / y,
        };
        Ok(Held { value: rounded(value, kind), kind })
    }
}
