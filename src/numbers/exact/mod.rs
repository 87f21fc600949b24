//! Exact numbers, without geometry and without floating point.
//!
//! | item | what it is |
//! |---|---|
//! | [`Integer`], [`Rational`] | numbers of any size |
//! | [`crates`], [`ConversionError`] | numbers of other crates, and which do not fit |
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
//! | [`RationalPolynomial`], [`PiecewisePolynomial`], [`Parametric`], [`QuotientAt`] | functions of a free parameter |
//! | [`Interval`], [`IntervalSet`] | where a function of the parameter is below a bound |
//! | [`IntegerFunction`], [`Turned`] | functions of an integer t, for all t from one on |
//! | [`Scalar`], [`Real`] | the operations that algorithms need of a number type |
//! | [`Matrix`] | matrices with few distinct entries |
//! | [`solve`], [`determinant`], [`interpolated`] | systems of linear equations over the rationals |
//! | [`echelon`], [`only_solution`], [`null_rows`] | elimination over any field of real numbers |
//! | [`characteristic_polynomial`], [`FieldElement`] | eigenvalues of rational matrices, and the fields that they generate |
//! | [`Adjugate`] | characteristic polynomials and eigenvectors over any ring |
//! | [`natural_logarithm`], [`LogSum`] | enclosures of logarithms, and of rational combinations of them |
//! | [`CommonDenominator`] | rationals as integers over one denominator, for hot loops |

mod backend;
mod common;
mod conversion;
mod enclosures;
mod integer;
mod integers;
mod matrices;
mod ops;
mod parameter;
mod polynomials;
mod printed;
mod rational;
mod real;
mod scalar;
mod symbolic;
mod text;
mod traits;
mod word;

pub use common::{CommonDenominator, common_denominator};
pub use conversion::ConversionError;
pub use enclosures::enclosure::{Enclosed, Enclosure};
pub use enclosures::format;
pub use enclosures::log_sum::{LogSum, LogTerm};
pub use enclosures::logarithm::natural_logarithm;
pub use integer::Integer;
pub use integers::function::IntegerFunction;
pub use integers::turned::Turned;
pub use matrices::adjugate::Adjugate;
pub use matrices::characteristic::{
    characteristic_coefficients, symmetric_square_coefficients, symmetric_square_polynomial,
};
pub use matrices::elimination::{echelon, null_rows, only_solution, row_times};
pub use matrices::linear::{determinant, interpolated, solve};
pub use matrices::matrix::{Matrix, Naming};
pub use matrices::modular::{Modulus, Residues, characteristic_polynomial};
pub use matrices::short_echelon::short_echelon;
pub use parameter::interval::Interval;
pub use parameter::interval_set::IntervalSet;
pub use parameter::parametric::Parametric;
pub use parameter::piecewise::PiecewisePolynomial;
pub use parameter::quotient_at::{Place, QuotientAt};
pub use polynomials::dense::{divided, greatest_divisor, square_free, stretched, value_at};
pub use polynomials::rational_polynomial::{MAX_TRIED_INTEGERS, RationalPolynomial};
pub use polynomials::sturm::SturmSequence;
pub use polynomials::univariate::IntegerPolynomial;
pub use printed::decimal::{Decimal, Rounding};
pub use printed::error::{MAX_DIGITS, MAX_EXPONENT, NumberError};
pub use printed::read::{is_blank, is_vulgar, parse_decimal, parse_printed, parse_rational};
pub use rational::Rational;
pub use real::algebraic::RealAlgebraic;
pub use real::comparable::comparable;
pub use real::cyclotomic::{
    CosineError, MAX_CONDUCTOR, RealCyclotomic, StoredForm, common_conductor, cosine_polynomial,
};
pub use real::expression::{MAX_ROOT_DEGREE, RealExpression, RootError};
pub use real::number_field::{
    AlgebraicNumber, FieldElement, FieldError, MAX_FIELD_DEGREE, MAX_NORM_DEGREE,
};
pub use real::square::floor_root;
pub use scalar::{Real, Scalar};
pub use symbolic::bivariate::BivariatePolynomial;
pub use symbolic::polynomial::Polynomial;
pub use word::within;

/// The crates whose numbers convert from and to those here, in the versions that do.
pub mod crates {
    #[cfg(feature = "gmp")]
    pub use rug;
    pub use {num_bigint, num_rational, num_traits};
}

/// Items for the tests of this crate; not part of its interface.
#[doc(hidden)]
pub mod internals {
    pub use super::real::cyclotomic::{cosines, is_prime, pi, primes};
}
