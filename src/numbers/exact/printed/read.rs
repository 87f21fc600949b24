//! Strict reading of numbers as papers and users write them.

use super::error::{MAX_DIGITS, MAX_EXPONENT, NumberError};
use crate::exact::{Decimal, Integer, Rational};

/// Reads `-35/1296`, `½`, `1½`, or any decimal that [`parse_decimal`] reads.
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
/// assert_eq!(parse_rational("2 / 4")?, parse_rational("½")?);
/// assert_eq!(parse_rational("4.35e-5")?, Rational::new(435, 10_000_000));
/// assert!(parse_rational("1/-2").is_err());
/// # Ok::<(), subcert::exact::NumberError>(())
/// ```
pub fn parse_rational(text: &str) -> Result<Rational, NumberError> {
    parse_printed(text).map(|printed| printed.value())
}

/// Reads a number as printed: a decimal, of which a value may be the rounding, or a fraction, which is exact.
///
/// # Errors
/// As [`parse_rational`].
///
/// ```
/// use subcert::exact::{Rational, Rounding, parse_printed};
///
/// let [decimal, fraction] = [parse_printed("0.667")?, parse_printed("2/3")?];
/// assert_eq!(decimal.rounding_of(&Rational::new(2, 3)), Rounding::Nearest);
/// assert_eq!(fraction.rounding_of(&Rational::new(2, 3)), Rounding::Exact);
/// assert_eq!(fraction.rounding_of(&Rational::new(667, 1000)), Rounding::Neither);
/// # Ok::<(), subcert::exact::NumberError>(())
/// ```
pub fn parse_printed(text: &str) -> Result<Decimal, NumberError> {
    let mut reader = Reader::new(text)?;
    let printed = reader.printed()?;
    reader.end().map(|()| printed)
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
    let read = if text.contains('/') {
        reader.printed().and_then(|printed| reader.end().map(|()| printed.value()))
    } else {
        reader.integer().map(Rational::from)
    };
    read.map_err(|error| match error {
        NumberError::Unexpected { .. } | NumberError::Unfinished { .. } => {
            NumberError::NotAFraction { text: text.to_owned(), radix }
        }
        other => other,
    })
}

/// Reads a decimal as printed: `7`, `-0.0266`, `+.625`, `4.35e-5`, `4.35E-5`,
/// `1.99×10^-10`, `1.99 x 10^-10`, `1.99*10^-10`. White space may stand around it and behind its sign.
///
/// # Errors
/// When the text is anything else (a second sign, a fraction), or
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
    let decimal = reader.decimal(negative)?;
    reader.end().map(|()| decimal)
}

/// Whether nothing is printed here: no character but dashes of one kind, at most three, and blanks.
///
/// ```
/// use subcert::exact::is_blank;
///
/// assert!(is_blank("") && is_blank(" — ") && is_blank("--"));
/// assert!(!is_blank("-1") && !is_blank("0"));
/// ```
#[must_use]
pub fn is_blank(text: &str) -> bool {
    let text = text.trim();
    let first = text.chars().next();
    let dash = first.is_none_or(|first| DASHES.contains(&first));
    dash && text.chars().count() <= 3 && text.chars().all(|c| Some(c) == first)
}

/// What stands in a cell without a number: a hyphen, a minus, and the dashes.
const DASHES: [char; 4] = ['-', '\u{2212}', '\u{2013}', '\u{2014}'];

/// The fractions that are one character, with numerator and denominator.
const VULGAR: [(char, i64, i64); 19] = [
    ('½', 1, 2),
    ('⅓', 1, 3),
    ('⅔', 2, 3),
    ('¼', 1, 4),
    ('¾', 3, 4),
    ('⅕', 1, 5),
    ('⅖', 2, 5),
    ('⅗', 3, 5),
    ('⅘', 4, 5),
    ('⅙', 1, 6),
    ('⅚', 5, 6),
    ('⅐', 1, 7),
    ('⅛', 1, 8),
    ('⅜', 3, 8),
    ('⅝', 5, 8),
    ('⅞', 7, 8),
    ('⅑', 1, 9),
    ('⅒', 1, 10),
    ('↉', 0, 3),
];

/// Whether this character is a fraction, such as `½`.
#[must_use]
pub fn is_vulgar(c: char) -> bool {
    VULGAR.iter().any(|(one, ..)| *one == c)
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
        if text.trim().is_empty() {
            return Err(NumberError::Empty);
        }
        if text.len() > MAX_DIGITS {
            return Err(NumberError::TooLong { digits: text.len() });
        }
        Ok(Reader { text, rest: text.trim_start(), radix: 10 })
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

    fn eat(&mut self, prefix: &str) -> bool {
        match self.rest.strip_prefix(prefix) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn eat_any(&mut self, prefixes: &[&str]) -> bool {
        prefixes.iter().any(|prefix| self.eat(prefix))
    }

    fn blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }

    /// Whether a minus stands here; a plus is passed over. Papers print the minus U+2212, or an en dash in its place.
    fn sign(&mut self) -> bool {
        let negative = self.eat_any(&["-", "\u{2212}", "\u{2013}"]);
        if negative || self.eat("+") {
            self.blanks();
        }
        negative
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

    fn digit_run(&mut self) -> &'a str {
        let digit = |byte: &u8| char::from(*byte).is_digit(self.radix);
        let end = self.rest.bytes().take_while(digit).count();
        let (run, rest) = self.rest.split_at(end);
        self.rest = rest;
        run
    }

    fn digits(&mut self) -> Result<Integer, NumberError> {
        let run = self.digit_run();
        Integer::from_digits_in(run, self.radix).ok_or_else(|| self.unexpected())
    }

    /// A decimal or a fraction, with its sign.
    fn printed(&mut self) -> Result<Decimal, NumberError> {
        let negative = self.sign();
        let start = self.rest;
        let whole = Integer::from_digits_in(self.digit_run(), self.radix);
        let first = self.rest.chars().next();
        let vulgar = VULGAR.iter().find(|(c, ..)| Some(*c) == first);
        let (numerator, denominator) = if let Some((c, p, q)) = vulgar {
            self.rest = &self.rest[c.len_utf8()..];
            let whole = whole.unwrap_or_else(Integer::zero);
            (whole * Integer::from(*q) + Integer::from(*p), Integer::from(*q))
        } else {
            self.blanks();
            match whole {
                // The fraction slash and the division slash too.
                Some(whole) if self.eat_any(&["/", "\u{2044}", "\u{2215}"]) => {
                    self.blanks();
                    (whole, self.digits()?)
                }
                _ => {
                    self.rest = start;
                    return self.decimal(negative);
                }
            }
        };
        let numerator = if negative { -numerator } else { numerator };
        let zero = || NumberError::ZeroDenominator { text: self.text.to_owned() };
        Decimal::fraction(numerator, denominator).ok_or_else(zero)
    }

    /// A decimal behind its sign.
    fn decimal(&mut self, negative: bool) -> Result<Decimal, NumberError> {
        let mut digits = self.digit_run().to_owned();
        let mut places = 0;
        if self.eat(".") {
            let fraction = self.digit_run();
            places = fraction.len();
            digits.push_str(fraction);
        }
        let mantissa = Integer::from_digits(&digits).ok_or_else(|| self.unexpected())?;
        let exponent = if self.power() { self.exponent()? } else { 0 };
        let places = i32::try_from(places).unwrap_or(i32::MAX);
        Ok(Decimal::new(if negative { -mantissa } else { mantissa }, exponent - places))
    }

    /// Passes over `e` or `×10^`, if an exponent follows.
    fn power(&mut self) -> bool {
        if self.eat_any(&["e", "E"]) {
            return true;
        }
        let before = self.rest;
        self.blanks();
        let times = self.eat_any(&["×", "x", "*", "·"]);
        self.blanks();
        let found = times && self.eat("10^");
        if !found {
            self.rest = before;
        }
        found
    }

    fn exponent(&mut self) -> Result<i32, NumberError> {
        let negative = self.sign();
        let magnitude = self.digits()?;
        let value = magnitude.to_i64().and_then(|value| i32::try_from(value).ok());
        match value {
            Some(value) if value <= MAX_EXPONENT => Ok(if negative { -value } else { value }),
            _ => Err(NumberError::ExponentTooLarge { text: self.text.to_owned() }),
        }
    }

    fn end(&mut self) -> Result<(), NumberError> {
        self.blanks();
        if self.rest.is_empty() { Ok(()) } else { Err(self.unexpected()) }
    }
}
