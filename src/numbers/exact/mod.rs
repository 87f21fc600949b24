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
//! | [`RealExpression`] | expressions in cosines, square roots and roots of polynomials |
//! | [`IntegerPolynomial`], [`SturmSequence`] | polynomials in one variable, and their real roots |
//! | [`Enclosure`], [`Enclosed`] | intervals of any width around a real number |
//! | [`BivariatePolynomial`] | functions of two free parameters |
//! | [`RationalPolynomial`], [`PiecewisePolynomial`], [`Parametric`] | functions of a free parameter |
//! | [`Interval`], [`IntervalSet`] | where a function of the parameter is below a bound |
//! | [`Scalar`], [`Real`] | the operations that algorithms need of a number type |
//! | [`Matrix`] | matrices with few distinct entries |
//! | [`solve`], [`determinant`], [`interpolated`] | systems of linear equations |
//! | [`characteristic_polynomial`], [`FieldElement`] | eigenvalues of rational matrices, and the fields that they generate |
//! | [`Adjugate`] | characteristic polynomials and eigenvectors over any ring |
//! | [`natural_logarithm`], [`LogSum`] | enclosures of logarithms, and of rational combinations of them |
//! | [`CommonDenominator`] | rationals as integers over one denominator, for hot loops |

mod adjugate;
mod algebraic;
mod backend;
mod bivariate;
mod characteristic;
mod common;
mod comparable;
mod cyclotomic;
mod decimal;
mod descartes;
mod enclosure;
mod expression;
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
mod sign_at;
mod sturm;
mod univariate;
mod vanishing;
mod word;

pub use adjugate::Adjugate;
pub use algebraic::RealAlgebraic;
pub use bivariate::BivariatePolynomial;
pub use characteristic::{
    characteristic_coefficients, characteristic_polynomial, symmetric_square_coefficients,
    symmetric_square_polynomial,
};
pub use common::CommonDenominator;
pub use common::common_denominator;
pub use comparable::comparable;
pub use cyclotomic::{
    CosineError, MAX_CONDUCTOR, RealCyclotomic, StoredForm, common_conductor, cosine_polynomial,
};
pub use decimal::{Decimal, Rounding};
pub use enclosure::{Enclosed, Enclosure};
pub use expression::floor_root;
pub use expression::{MAX_ROOT_DEGREE, RealExpression, RootError};
pub use integer::Integer;
pub use interval::Interval;
pub use interval_set::IntervalSet;
pub use linear::{determinant, interpolated, solve};
pub use log_sum::{LogSum, LogTerm};
pub use logarithm::natural_logarithm;
pub use matrix::{Matrix, Naming};
pub use number_field::{
    AlgebraicNumber, FieldElement, FieldError, MAX_FIELD_DEGREE, MAX_NORM_DEGREE,
};
pub use number_field::{divided, greatest_divisor, square_free, value_at};
pub use parametric::Parametric;
pub use piecewise::PiecewisePolynomial;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use rational_polynomial::RationalPolynomial;
pub use read::{MAX_DIGITS, MAX_EXPONENT, NumberError, parse_decimal, parse_rational};
pub use scalar::{Real, Scalar};
pub use sturm::SturmSequence;
pub use univariate::IntegerPolynomial;
pub use word::within;

/// Items for the tests of this crate; not part of its interface.
#[doc(hidden)]
pub mod internals {
    pub use super::cyclotomic::{cosines, is_prime, pi, primes};
}
