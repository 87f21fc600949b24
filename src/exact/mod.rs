//! Numbers: no geometry and no floating point.
//!
//! | item | what it is |
//! |---|---|
//! | [`Integer`], [`Rational`] | numbers of any size |
//! | [`Decimal`] | a decimal as printed, which knows its rounding interval |
//! | [`mod@format`] | correctly rounded decimals of exact values |
//! | [`Polynomial`] | polynomials in named variables, the normal form of an identity |
//! | [`PiecewiseLinear`], [`Parametric`] | functions of a free parameter |
//! | [`Interval`], [`IntervalSet`] | where such a function is below a bound |
//! | [`Scalar`], [`Real`] | what the algorithms ask of a number type |
//! | [`CommonDenominator`] | rationals as integers over one denominator, for hot loops |

mod backend;
mod common;
mod decimal;
pub mod format;
mod integer;
mod interval;
mod ops;
mod parametric;
mod piecewise;
mod polynomial;
mod rational;
mod read;
mod scalar;

pub use common::CommonDenominator;
pub use decimal::{Decimal, Rounding};
pub use integer::Integer;
pub use interval::{Interval, IntervalSet};
pub use parametric::Parametric;
pub use piecewise::PiecewiseLinear;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use read::{MAX_DIGITS, MAX_EXPONENT, NumberError, parse_decimal, parse_rational};
pub use scalar::{Real, Scalar};
