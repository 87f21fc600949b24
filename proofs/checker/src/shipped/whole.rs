//! The types of integers in programs, and what their operations give.

use super::language::Language;
use crate::numbers::Q;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// The type of an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Whole {
    /// 32 bits with a sign.
    Int,
    /// 32 bits without.
    Unsigned,
    /// 64 bits with a sign.
    Long,
    /// 64 bits without.
    UnsignedLong,
    /// Python's, without bounds.
    Unbounded,
}

impl Whole {
    /// The type of a literal: the first that the language allows for it and that holds it.
    pub fn of(
        value: &Q,
        suffix: &str,
        is_decimal: bool,
        language: Language,
    ) -> Result<Whole, &'static str> {
        use Whole::{Int, Long, Unbounded, Unsigned, UnsignedLong};
        let (unsigned, long) = (suffix.contains('u'), suffix.contains('l'));
        let types: &[Whole] = match (language, unsigned, long) {
            (Language::Python | Language::Wgsl, ..) => &[Unbounded],
            (Language::C, true, true) => &[UnsignedLong],
            (Language::C, true, false) => &[Unsigned, UnsignedLong],
            (Language::C, false, true) if is_decimal => &[Long],
            (Language::C, false, true) => &[Long, UnsignedLong],
            (Language::C, false, false) if is_decimal => &[Int, Long],
            (Language::C, false, false) => &[Int, Unsigned, Long, UnsignedLong],
            (_, true, _) => &[Unsigned],
            (_, false, _) => &[Int],
        };
        let value = value.to_integer();
        let holds = |kind: &&Whole| kind.range().is_none_or(|(_, last)| value <= last);
        types.iter().find(holds).copied().ok_or("an integer that no type of the language holds")
    }

    /// The least and the greatest number of the type.
    fn range(self) -> Option<(BigInt, BigInt)> {
        let power = |bits: u32| BigInt::one() << bits;
        Some(match self {
            Whole::Int => (-power(31), power(31) - 1),
            Whole::Unsigned => (BigInt::zero(), power(32) - 1),
            Whole::Long => (-power(63), power(63) - 1),
            Whole::UnsignedLong => (BigInt::zero(), power(64) - 1),
            Whole::Unbounded => return None,
        })
    }

    /// An integer as one of this type: in types without a sign, modulo the number of their values.
    pub fn wrapped(self, value: BigInt) -> Result<BigInt, Stop> {
        match self.range() {
            None => Ok(value),
            Some((first, last)) if first <= value && value <= last => Ok(value),
            Some((first, last)) if first.is_zero() => Ok(value.mod_floor(&(last + 1))),
            Some(_) => Err(Stop::Undefined("an integer overflows its type")),
        }
    }

    /// A sum, difference, product or quotient cut to an integer. Both are converted to the later
    /// of the two types first, in the order above.
    pub fn operate(self, sign: char, x: &Q, (other, y): (Whole, &Q)) -> Result<(Whole, Q), Stop> {
        let kind = self.max(other);
        let (x, y) = (kind.wrapped(x.to_integer())?, kind.wrapped(y.to_integer())?);
        let value = match sign {
            '+' => x + y,
            '-' => x - y,
            '*' => x * y,
            _ if y.is_zero() => return Err(Stop::Undefined("it divides by 0")),
            _ => (x.abs() / y.abs()) * x.signum() * y.signum(),
        };
        Ok((kind, Q::from_integer(kind.wrapped(value)?)))
    }
}
