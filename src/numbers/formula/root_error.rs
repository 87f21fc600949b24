//! Rational roots of polynomials, and why a root is not a value.

use super::error::FormulaErrorKind;
use crate::exact::{
    FieldError, IntegerPolynomial, MAX_NORM_DEGREE, MAX_ROOT_DEGREE, Rational, RealAlgebraic,
};

/// Why a root is not a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootError {
    /// It does not exist, or is beyond the caps.
    Field(FieldError),
    /// It is irrational, and the values are rational.
    Irrational,
    /// The values are of a type without roots.
    NotHere,
    /// The degree of the polynomial is too large.
    Degree,
    /// The coefficients themselves have roots in them.
    Coefficients,
    /// The coefficients have the variable of a symbol in them.
    Variable,
    /// The sign of a radicand is not decided.
    Undecided,
    /// A coefficient is known by bounds only.
    Enclosed,
}

impl From<RootError> for FormulaErrorKind {
    fn from(error: RootError) -> FormulaErrorKind {
        match error {
            RootError::Field(error) => FormulaErrorKind::Field(error),
            RootError::Irrational => FormulaErrorKind::Irrational("this root".to_owned()),
            RootError::NotHere => FormulaErrorKind::OtherReal("this root".to_owned()),
            RootError::Degree => FormulaErrorKind::too_large(
                "the degree of a polynomial of a root",
                MAX_ROOT_DEGREE as u64,
            ),
            RootError::Coefficients => FormulaErrorKind::Unsupported(
                "the coefficients of `root` are numbers without `sqrt` and `root` here",
            ),
            RootError::Variable => FormulaErrorKind::Unsupported(
                "`sqrt` and `root` are for numbers, and this has the variable z of a symbol in it",
            ),
            RootError::Undecided => {
                FormulaErrorKind::Unsupported("it is not decided whether this is 0 or positive")
            }
            RootError::Enclosed => FormulaErrorKind::Unsupported(
                "`sqrt` and `root` are for numbers that are known exactly, and of this one only bounds are",
            ),
        }
    }
}

/// The real root of this number, counted from 1, of a polynomial with these coefficients, if it is rational.
pub(super) fn rational_root(coefficients: &[Rational], number: i64) -> Result<Rational, RootError> {
    let polynomial = IntegerPolynomial::over_common_denominator(coefficients);
    let degree = polynomial.degree().ok_or(RootError::Field(FieldError::Zero))?;
    if degree > MAX_NORM_DEGREE {
        return Err(RootError::Field(FieldError::Norm(degree)));
    }
    let roots = RealAlgebraic::roots_of(&polynomial);
    let place = usize::try_from(number).ok().and_then(|number| number.checked_sub(1));
    let no_such = FieldError::NoSuchRoot { found: roots.len(), asked: number };
    let root = place.and_then(|place| roots.get(place)).ok_or(RootError::Field(no_such))?;
    root.as_rational().cloned().ok_or(RootError::Irrational)
}
