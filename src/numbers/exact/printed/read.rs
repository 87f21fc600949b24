//! Strict reading of numbers as papers and users write them.

use crate::exact::{Decimal, Integer, Rational};

/// The greatest length, in bytes, of the text of a number.
pub const MAX_DIGITS: usize = 10_000;

/// The largest absolute value of a decimal exponent.
pub const MAX_EXPONENT: i32 = 1_000;

/// Why a text is not a number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NumberError {
    /// There is nothing to read.
    #[error("a number is missing; write one such as -35/1296, 0.0266 or 4.35e-5")]
    Empty,
    /// A character that cannot stand at this place of a number.
    #[error(
        "`{text}` is not a number: unexpected `{found}` at character {position}; \
         write -35/1296, 0.0266, 4.35e-5 or 1.99×10^-10"
    )]
    Unexpected {
        /// The text as given.
        text: String,
        /// The character that does not fit.
        found: char,
        /// Its place, counted from 1.
        position: usize,
    },
    /// The text stops where a digit must follow.
    #[error("`{text}` is not a number: a digit must follow at its end")]
    Unfinished {
        /// The text as given.
        text: String,
    },
    /// q = 0 in p/q.
    #[error("`{text}` has denominator 0")]
    ZeroDenominator {
        /// The text as given.
        text: String,
    },
    /// A text longer than [`MAX_DIGITS`].
    #[error("a number of {digits} digits; at most {MAX_DIGITS} are read")]
    TooLong {
        /// The length of the text in bytes.
        digits: usize,
    },
    /// A text that is not an integer in this base.
    #[error(
        "`{text}` is not an integer in base {radix}: write its digits, with - before them if it is negative"
    )]
    NotAnInteger {
        /// The text as given.
        text: String,
        /// The base.
        radix: u32,
    },
    /// A text that is neither an integer nor a fraction in this base.
    #[error(
        "`{text}` is not a fraction in base {radix}: write p or p/q in digits, with - before them if it is negative"
    )]
    NotAFraction {
        /// The text as given.
        text: String,
        /// The base.
        radix: u32,
    },
    /// A base that has no digits.
    #[error("base {radix} is out of range; bases from 2 to 36 are read")]
    Base {
        /// The base.
        radix: u32,
    },
    /// A decimal exponent beyond [`MAX_EXPONENT`] in absolute value.
    #[error("the exponent of `{text}` is out of range; at most ±{MAX_EXPONENT} is read")]
    ExponentTooLarge {
        /// The text as given.
        text: String,
    },
}

/// Reads `-35/1296`, `7`, or any decimal that [`parse_decimal`] reads.
///
/// A fraction need not be in lowest terms, since people write masks such as 2/16, 12/16,
/// 2/16. It is reduced. Its denominator must not have a sign.
///
/// # Errors
/// When the text is anything else, or beyond the caps.
///
/// ```
/// use subcert::exact::{Rational, parse_rational};
///
/// assert_eq!(parse_rational("-35/1296")?, Rational::new(-35, 1296));
/// assert_eq!(parse_rational("2/4")?, Rational::new(1, 2));
/// assert_eq!(parse_rational("4.35e-5")?, Rational::new(435, 10_000_000));
/// assert!(parse_rational("1/-2").is_err());
/// # Ok::<(), subcert::exact::NumberError>(())
/// ```
pub fn parse_rational(text: &str) -> Result<Rational, NumberError> {
    if !text.contains('/') {
        return parse_decimal(text).map(|decimal| decimal.value());
    }
    Reader::new(text)?.fraction()
}

/// Reads the digits of an integer in base `radix`, with a minus sign before them if it is negative.
pub(in crate::exact) fn integer_in(text: &str, radix: u32) -> Result<Integer, NumberError> {
    Reader::in_base(text, radix)?.integer().map_err(|error| match error {
        NumberError::Unexpected { .. } | NumberError::Unfinished { .. } => {
            NumberError::NotAnInteger { text: text.to_owned(), radix }
        }
        other => other,
    })
}

/// Reads p or p/q, both in base `radix`.
pub(in crate::exact) fn rational_in(text: &str, radix: u32) -> Result<Rational, NumberError> {
    let mut reader = Reader::in_base(text, radix)?;
    let read =
        if text.contains('/') { reader.fraction() } else { reader.integer().map(Rational::from) };
    read.map_err(|error| match error {
        NumberError::Unexpected { .. } | NumberError::Unfinished { .. } => {
            NumberError::NotAFraction { text: text.to_owned(), radix }
        }
        other => other,
    })
}

/// Reads a decimal as printed: `7`, `-0.0266`, `4.35e-5`, `4.35E-5`,
/// `1.99×10^-10`, `1.99x10^-10`, `1.99*10^-10`.
///
/// # Errors
/// When the text is anything else (white space, a second sign, `.5`, `5.`), or
/// beyond the caps. Damaged text such as `6.02 - 7` is refused, never repaired.
///
/// ```
/// use subcert::exact::parse_decimal;
///
/// assert_eq!(parse_decimal("1.99×10^-10")?.value(), parse_decimal("1.99e-10")?.value());
/// assert!(parse_decimal("6.02 - 7").is_err());
/// # Ok::<(), subcert::exact::NumberError>(())
/// ```
pub fn parse_decimal(text: &str) -> Result<Decimal, NumberError> {
    let mut reader = Reader::new(text)?;
    let negative = reader.sign();
    let mut digits = reader.digit_run()?.to_owned();
    let mut places = 0;
    if reader.eat(".") {
        let fraction = reader.digit_run()?;
        places = fraction.len();
        digits.push_str(fraction);
    }
    let mut exponent = 0;
    if ["e", "E", "×10^", "x10^", "*10^"].iter().any(|mark| reader.eat(mark)) {
        exponent = reader.exponent()?;
    }
    reader.end()?;
    let mantissa = Integer::from_digits(&digits).unwrap_or_else(Integer::zero);
    let places = i32::try_from(places).unwrap_or(i32::MAX);
    Ok(Decimal::new(if negative { -mantissa } else { mantissa }, exponent - places))
}

/// A cursor over one number.
struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
    /// The base of its digits.
    radix: u32,
}

impl<'a> Reader<'a> {
    fn new(text: &'a str) -> Result<Reader<'a>, NumberError> {
        if text.is_empty() {
            return Err(NumberError::Empty);
        }
        if text.len() > MAX_DIGITS {
            return Err(NumberError::TooLong { digits: text.len() });
        }
        Ok(Reader { text, rest: text, radix: 10 })
    }

    fn in_base(text: &'a str, radix: u32) -> Result<Reader<'a>, NumberError> {
        if !(2..=36).contains(&radix) {
            return Err(NumberError::Base { radix });
        }
        Ok(Reader { radix, ..Reader::new(text)? })
    }

    /// An integer, and nothing after it.
    fn integer(&mut self) -> Result<Integer, NumberError> {
        let negative = self.sign();
        let magnitude = self.digits()?;
        self.end()?;
        Ok(if negative { -magnitude } else { magnitude })
    }

    /// p/q, and nothing after it.
    fn fraction(&mut self) -> Result<Rational, NumberError> {
        let negative = self.sign();
        let numerator = self.digits()?;
        self.expect('/')?;
        let denominator = self.digits()?;
        self.end()?;
        if denominator.is_zero() {
            return Err(NumberError::ZeroDenominator { text: self.text.to_owned() });
        }
        Ok(Rational::new(if negative { -numerator } else { numerator }, denominator))
    }

    fn eat(&mut self, prefix: &str) -> bool {
        match self.rest.strip_prefix(prefix) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sign(&mut self) -> bool {
        // Papers print the minus sign U+2212.
        self.eat("-") || self.eat("\u{2212}")
    }

    fn unexpected(&self) -> NumberError {
        let consumed = &self.text[..self.text.len() - self.rest.len()];
        match self.rest.chars().next() {
            Some(found) => NumberError::Unexpected {
                text: self.text.to_owned(),
                found,
                position: consumed.chars().count() + 1,
            },
            None => NumberError::Unfinished { text: self.text.to_owned() },
        }
    }

    fn expect(&mut self, prefix: char) -> Result<(), NumberError> {
        if self.eat(prefix.encode_utf8(&mut [0; 4])) { Ok(()) } else { Err(self.unexpected()) }
    }

    fn digit_run(&mut self) -> Result<&'a str, NumberError> {
        let end =
            self.rest.bytes().take_while(|byte| char::from(*byte).is_digit(self.radix)).count();
        if end == 0 {
            return Err(self.unexpected());
        }
        let (run, rest) = self.rest.split_at(end);
        self.rest = rest;
        Ok(run)
    }

    fn digits(&mut self) -> Result<Integer, NumberError> {
        let radix = self.radix;
        Ok(Integer::from_digits_in(self.digit_run()?, radix).unwrap_or_else(Integer::zero))
    }

    fn exponent(&mut self) -> Result<i32, NumberError> {
        let negative = self.sign();
        if !negative {
            self.eat("+");
        }
        let magnitude = self.digits()?;
        let value = magnitude.to_i64().and_then(|value| i32::try_from(value).ok());
        match value {
            Some(value) if value <= MAX_EXPONENT => Ok(if negative { -value } else { value }),
            _ => Err(NumberError::ExponentTooLarge { text: self.text.to_owned() }),
        }
    }

    fn end(&self) -> Result<(), NumberError> {
        if self.rest.is_empty() { Ok(()) } else { Err(self.unexpected()) }
    }
}
