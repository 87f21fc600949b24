//! Numbers of real fields Q(α) as values of formulas.

use super::error::FormulaErrorKind;
use super::root::RootError;
use super::value::Value;
use crate::exact::{Enclosed as _, FieldElement, Integer, Rational, Real as _};

impl Value for FieldElement {
    fn as_rational(&self) -> Option<Rational> {
        FieldElement::as_rational(self)
    }
    fn size(&self) -> u64 {
        // A product takes the square of the degree many products of coefficients.
        let degree = self.field().map_or(1, |(_, minimal)| minimal.coefficients().len() as u64);
        self.coordinates().bits().saturating_mul(degree)
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
        Some(self.coordinates().is_zero())
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let coefficients = FieldElement::together(coefficients).map_err(RootError::Field)?;
        FieldElement::root(&coefficients, number).map_err(RootError::Field)
    }
    fn meets(&self, other: &Self) -> Result<(), FormulaErrorKind> {
        FieldElement::together(&[self.clone(), other.clone()])?;
        Ok(())
    }
    fn together(values: Vec<Self>) -> Result<Vec<Self>, FormulaErrorKind> {
        Ok(FieldElement::together(&values)?)
    }
}
