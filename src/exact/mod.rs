//! Exact numbers, without geometry and without floating point.
//!
//! | item | what it is |
//! |---|---|
//! | [`Integer`], [`Rational`] | numbers of any size |
//! | [`Decimal`] | a decimal as printed, with its rounding interval |
//! | [`mod@format`] | correctly rounded decimals of exact values |
//! | [`Polynomial`] | polynomials in named variables, the normal form of an identity |
//! | [`RealCyclotomic`] | real numbers of Q(2cos(2π/n)): sums of cosines |
//! | [`cosine_polynomial`] | the minimal polynomial of 2cos(2π/n) |
//! | [`RealAlgebraic`] | a root of a polynomial in an interval |
//! | [`IntegerPolynomial`], [`SturmSequence`] | polynomials in one variable, and their real roots |
//! | [`Enclosure`], [`Enclosed`] | intervals of any width around a real number |
//! | [`RationalPolynomial`], [`PiecewisePolynomial`], [`Parametric`] | functions of a free parameter |
//! | [`Interval`], [`IntervalSet`] | where a function of the parameter is below a bound |
//! | [`Scalar`], [`Real`] | the operations that algorithms need of a number type |
//! | [`Matrix`] | matrices with few distinct entries |
//! | [`solve`] | systems of linear equations |
//! | [`characteristic_polynomial`], [`FieldElement`] | eigenvalues of rational matrices, and the fields that they generate |
//! | [`natural_logarithm`], [`LogSum`] | enclosures of logarithms, and of rational combinations of them |
//! | [`CommonDenominator`] | rationals as integers over one denominator, for hot loops |

mod algebraic;
mod backend;
mod characteristic;
mod common;
mod comparable;
mod cyclotomic;
mod decimal;
mod enclosure;
mod factor;
pub mod format;
mod integer;
mod interval;
mod interval_set;
mod linear;
mod log_sum;
mod logarithm;
mod matrix;
mod monomial;
mod number_field;
mod one_variable;
mod ops;
mod parametric;
mod piecewise;
mod polynomial;
mod rational;
mod rational_polynomial;
mod read;
mod roots;
mod scalar;
mod sturm;
mod univariate;
mod vanishing;
mod word;

pub use algebraic::RealAlgebraic;
pub use characteristic::{characteristic_polynomial, symmetric_square_polynomial};
pub use common::CommonDenominator;
pub(crate) use common::common_denominator;
pub(crate) use comparable::comparable;
pub use cyclotomic::{
    CosineError, MAX_CONDUCTOR, RealCyclotomic, common_conductor, cosine_polynomial,
};
pub use decimal::{Decimal, Rounding};
pub use enclosure::{Enclosed, Enclosure};
pub use integer::Integer;
pub use interval::Interval;
pub use interval_set::IntervalSet;
pub use linear::solve;
pub use log_sum::{LogSum, LogTerm};
pub use logarithm::natural_logarithm;
pub use matrix::{Matrix, Naming};
pub use number_field::FieldElement;
pub use parametric::Parametric;
pub use piecewise::PiecewisePolynomial;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use rational_polynomial::RationalPolynomial;
pub use read::{MAX_DIGITS, MAX_EXPONENT, NumberError, parse_decimal, parse_rational};
pub use scalar::{Real, Scalar};
pub use sturm::SturmSequence;
pub use univariate::IntegerPolynomial;

/// Items for the tests of this crate; not part of its interface.
#[doc(hidden)]
pub mod internals {
    pub use super::cyclotomic::{cosines, is_prime, pi, primes};
}
