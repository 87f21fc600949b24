//! Numbers: no geometry and no floating point.
//!
//! | item | what it is |
//! |---|---|
//! | [`Integer`], [`Rational`] | numbers of any size |
//! | [`Decimal`] | a decimal as printed, which knows its rounding interval |
//! | [`mod@format`] | correctly rounded decimals of exact values |
//! | [`Polynomial`] | polynomials in named variables, the normal form of an identity |
//! | [`Scalar`], [`Real`] | what the algorithms ask of a number type |
//! | [`CommonDenominator`] | rationals as integers over one denominator, for hot loops |

mod backend;
mod common;
mod decimal;
pub mod format;
mod integer;
mod ops;
mod polynomial;
mod rational;
mod read;
mod scalar;

pub use common::CommonDenominator;
pub use decimal::{Decimal, Rounding};
pub use integer::Integer;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use read::{MAX_DIGITS, MAX_EXPONENT, NumberError, parse_decimal, parse_rational};
pub use scalar::{Real, Scalar};
