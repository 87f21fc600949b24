//! Integers of programs, with the types and conversions of their languages.

use super::language::Language;
use crate::exact::Integer;

/// The type of an integer: how many bits it has, `None` in Python and of literals of WGSL, and whether it has a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Width {
    bits: Option<u32>,
    signed: bool,
}

/// An integer of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Whole {
    pub(super) value: Integer,
    pub(super) width: Width,
}

impl Width {
    fn holds(self, value: &Integer) -> bool {
        let Some(bits) = self.bits else { return true };
        let half = Integer::from(2_i64).pow(bits - 1);
        if self.signed {
            *value < half && *value >= -half
        } else {
            value.sign() >= 0 && *value < half * Integer::from(2_i64)
        }
    }

    /// The type to which two types are converted: the wider one and, of two as wide, the one
    /// without a sign.
    fn common(self, other: Width) -> Width {
        if self.bits == other.bits {
            return Width { signed: self.signed && other.signed, ..self };
        }
        if self.bits > other.bits { self } else { other }
    }

    /// The value in this type: modulo 2^bits without a sign.
    fn converted(self, value: Integer) -> Result<Integer, String> {
        match self.bits {
            _ if self.holds(&value) => Ok(value),
            Some(bits) if !self.signed => {
                Ok(value.div_rem_floor(&Integer::from(2_i64).pow(bits)).1)
            }
            _ => Err(format!("the integer {value} overflows its type, which is undefined")),
        }
    }
}

impl Whole {
    /// A literal of this value and suffix. In C, an int has 32 bits and a long 64; a literal has
    /// the first type that holds it, and only one in hexadecimal, or with `u`, may have no sign.
    pub(super) fn literal(
        value: Integer,
        suffix: &str,
        decimal: bool,
        language: Language,
    ) -> Result<Whole, String> {
        let unsigned = suffix.contains('u');
        let all = [(32, true), (32, false), (64, true), (64, false)];
        let possible = |&(bits, signed): &(u32, bool)| match language {
            Language::C => {
                (bits == 64 || !suffix.contains('l'))
                    && if signed { !unsigned } else { unsigned || !decimal }
            }
            _ => bits == 32 && signed != unsigned,
        };
        let mut widths: Vec<Width> = all
            .iter()
            .filter(|width| possible(width))
            .map(|&(bits, signed)| Width { bits: Some(bits), signed })
            .collect();
        if matches!(language, Language::Python | Language::Wgsl) {
            widths = vec![Width { bits: None, signed: true }];
        }
        match widths.into_iter().find(|width| width.holds(&value)) {
            Some(width) => Ok(Whole { value, width }),
            None => Err("no integer type of the language holds it".to_owned()),
        }
    }

    /// −x.
    pub(super) fn negated(self) -> Result<Whole, String> {
        Ok(Whole { value: self.width.converted(-self.value)?, width: self.width })
    }

    /// A sum, difference or product, or a quotient cut to an integer.
    pub(super) fn operate(self, sign: char, other: Whole) -> Result<Whole, String> {
        let width = self.width.common(other.width);
        let [x, y] = [width.converted(self.value)?, width.converted(other.value)?];
        let value = match sign {
            '+' => x + y,
            '-' => x - y,
            '*' => x * y,
            _ if y.is_zero() => return Err("a division by zero".to_owned()),
            _ => {
                let negative = x.sign() * y.sign() < 0;
                let (size, _) = x.abs().div_rem_floor(&y.abs());
                if negative { -size } else { size }
            }
        };
        Ok(Whole { value: width.converted(value)?, width })
    }
}
