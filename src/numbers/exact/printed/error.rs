//! Why a text is not a number.

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
