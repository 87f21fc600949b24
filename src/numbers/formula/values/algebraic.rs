//! Real algebraic numbers as values of formulas.

use super::value::Value;
use crate::exact::{AlgebraicNumber, Enclosed as _, FieldElement, Integer, Rational, Real as _};
use crate::formula::error::FormulaErrorKind;
use crate::formula::root_error::RootError;

impl Value for AlgebraicNumber {
    fn as_rational(&self) -> Option<Rational> {
        AlgebraicNumber::element(self).as_rational()
    }
    fn element(&self) -> Option<FieldElement> {
        Some(AlgebraicNumber::element(self).clone())
    }
    fn of_element(element: &FieldElement) -> Option<Self> {
        Some(element.clone().into())
    }
    fn size(&self) -> u64 {
        // A product takes the square of the degree many products of coefficients.
        let degree = AlgebraicNumber::element(self)
            .field()
            .map_or(1, |(_, minimal)| minimal.coefficients().len() as u64);
        AlgebraicNumber::element(self).coordinates().bits().saturating_mul(degree)
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self.over(divisor))
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.magnitude())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.greater(other))
    }
    fn floor(&self) -> Option<Integer> {
        Some(self.step(Rational::floor))
    }
    fn vanishes(&self) -> Option<bool> {
        Some(self.sign() == 0)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        AlgebraicNumber::root(coefficients, number).map_err(RootError::Field)
    }
    fn meets(&self, other: &Self) -> Result<(), FormulaErrorKind> {
        Ok(AlgebraicNumber::meets(self, other)?)
    }
    fn together(values: Vec<Self>) -> Result<Vec<Self>, FormulaErrorKind> {
        Ok(AlgebraicNumber::together(&values)?)
    }
}
