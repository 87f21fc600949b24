//! Real numbers as formulas.

use crate::algebraic::Algebraic;
use crate::error::plain;
use crate::number::{Fraction, fraction};
use crate::run::aside;
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Display;
use subcert::exact::{Enclosed, Rational, RealCyclotomic, RealExpression};
use subcert::float::nearest;
use subcert::formula::{Scope, evaluate, parse};

/// The most binary digits that tell an expression from 0 where it is asked whether it is a fraction.
const MOST_DIGITS: u64 = 1 << 12;

/// A real number: exactly as text, as a fraction if it is known to be one, and the nearest float.
pub(crate) type Real = (String, Option<Fraction>, f64);

fn of(value: &(impl Enclosed + Display), rational: Option<&Rational>) -> Real {
    (value.to_string(), rational.map(fraction), nearest(value))
}

/// Nested roots of high degrees have so many digits that the question would take minutes.
pub(crate) fn of_expression(value: &RealExpression) -> Real {
    let asked = value.separation() <= MOST_DIGITS;
    of(value, if asked { value.as_rational() } else { None })
}

pub(crate) fn of_cyclotomic(value: &RealCyclotomic) -> Real {
    of(value, value.as_rational())
}

/// The value of a formula.
fn read(text: &str) -> PyResult<RealExpression> {
    let formula = parse(text).map_err(plain)?;
    evaluate(&formula, &Scope::new(&BTreeMap::new(), &())).map_err(plain)
}

/// The number that a formula is.
#[pyfunction]
pub fn real(py: Python<'_>, text: String) -> PyResult<Real> {
    aside(py, move || Ok(of_expression(&read(&text)?)))
}

/// -1, 0 or 1 as the first formula is less than, equal to or greater than the second one.
#[pyfunction]
pub fn compare_reals(py: Python<'_>, left: String, right: String) -> PyResult<i8> {
    aside(py, move || Ok(read(&left)?.cmp(&read(&right)?) as i8))
}

/// The number that a formula is, as a root of a polynomial.
#[pyfunction]
pub fn real_as_algebraic(py: Python<'_>, text: String) -> PyResult<Algebraic> {
    aside(py, move || {
        let found = read(&text)?.to_algebraic();
        found.map(Algebraic).ok_or_else(|| plain("the field of the number is too large"))
    })
}
