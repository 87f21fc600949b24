//! Roots of polynomials: the functions `sqrt` and `root`.

use super::error::FormulaErrorKind;
use super::root_error::RootError;
use super::values::value::Value;
use crate::exact::{FieldError, Rational};

/// The function whose arguments are a list of coefficients and a number. The list stands first, and its members are
/// the first arguments.
pub(super) const ROOT: &str = "root";

/// The function that the sign √ stands for.
pub(super) const SQUARE_ROOT: &str = "sqrt";

/// √x, for x ≥ 0.
pub(super) fn square_root<V: Value>(x: &V) -> Result<V, FormulaErrorKind> {
    if x.vanishes() == Some(true) {
        return Ok(V::zero());
    }
    let one = V::from_rational(&Rational::one());
    let square = [V::zero().minus(x), V::zero(), one];
    let root = V::root(&square, 2).or_else(|error| x.square_root().ok_or(error));
    root.map_err(|error| match error {
        RootError::Field(FieldError::NoSuchRoot { .. }) => {
            FormulaErrorKind::Undefined(format!("the square root of the negative number {x}"))
        }
        RootError::Irrational => FormulaErrorKind::Irrational(format!("sqrt({x})")),
        RootError::NotHere => FormulaErrorKind::OtherReal(format!("sqrt({x})")),
        other => FormulaErrorKind::from(other),
    })
}

/// The real root of this number of the polynomial with these coefficients.
pub(super) fn root<V: Value>(coefficients: &[V], number: i64) -> Result<V, FormulaErrorKind> {
    V::root(coefficients, number).map_err(FormulaErrorKind::from)
}
