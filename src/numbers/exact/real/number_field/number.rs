//! Numbers of any real field, which meet each other.

use super::element::FieldElement;
use super::error::FieldError;
use super::merge::shared;
use crate::exact::{Enclosed, Enclosure, Rational, Real, Scalar};
use std::fmt;

/// A real algebraic number, in a field that grows as numbers meet: an operation on numbers of two fields leads to a
/// field that has both.
///
/// ```
/// use subcert::exact::{AlgebraicNumber, Rational, Scalar};
///
/// let number = |c: i64| AlgebraicNumber::from_rational(&Rational::from(c));
/// let root = |x: i64| AlgebraicNumber::root(&[number(-x), number(0), number(1)], 2);
/// assert_eq!(root(2)?.times(&root(3)?), root(6)?);
/// # Ok::<(), subcert::exact::FieldError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AlgebraicNumber(FieldElement);

impl From<FieldElement> for AlgebraicNumber {
    fn from(value: FieldElement) -> AlgebraicNumber {
        AlgebraicNumber(value)
    }
}

impl AlgebraicNumber {
    /// The number in its field.
    #[must_use]
    pub fn element(&self) -> &FieldElement {
        &self.0
    }

    /// An error unless a field within the caps has both numbers, as one must have if they meet in an operation.
    ///
    /// # Errors
    /// When no such field has them.
    pub fn meets(&self, other: &AlgebraicNumber) -> Result<(), FieldError> {
        shared(&self.0, &other.0).map(|_| ())
    }

    /// These numbers in one field.
    ///
    /// # Errors
    /// When no field within the caps has them.
    pub fn together(numbers: &[AlgebraicNumber]) -> Result<Vec<AlgebraicNumber>, FieldError> {
        let elements: Vec<FieldElement> = numbers.iter().map(|number| number.0.clone()).collect();
        let elements = FieldElement::together(&elements)?;
        Ok(elements.into_iter().map(AlgebraicNumber).collect())
    }

    /// The real root of this number, counted from 1, as [`FieldElement::root`].
    ///
    /// # Errors
    /// As there.
    pub fn root(
        coefficients: &[AlgebraicNumber],
        number: i64,
    ) -> Result<AlgebraicNumber, FieldError> {
        let elements: Vec<FieldElement> = coefficients.iter().map(|c| c.0.clone()).collect();
        FieldElement::root(&FieldElement::together(&elements)?, number).map(AlgebraicNumber)
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        self.0.sign()
    }

    fn with(
        &self,
        other: &AlgebraicNumber,
        operation: fn(&FieldElement, &FieldElement) -> FieldElement,
    ) -> AlgebraicNumber {
        let [a, b] = shared(&self.0, &other.0).expect("a field of a low degree");
        AlgebraicNumber(operation(&a, &b))
    }
}

impl PartialEq for AlgebraicNumber {
    fn eq(&self, other: &AlgebraicNumber) -> bool {
        self.minus(other).sign() == 0
    }
}

impl Eq for AlgebraicNumber {}

/// # Panics
/// An operation panics when no field within the caps has both numbers; see [`AlgebraicNumber::meets`].
impl Scalar for AlgebraicNumber {
    fn from_rational(value: &Rational) -> Self {
        AlgebraicNumber(FieldElement::from_rational(value))
    }
    fn plus(&self, other: &Self) -> Self {
        self.with(other, FieldElement::plus)
    }
    fn minus(&self, other: &Self) -> Self {
        self.with(other, FieldElement::minus)
    }
    fn times(&self, other: &Self) -> Self {
        self.with(other, FieldElement::times)
    }
}

impl Real for AlgebraicNumber {
    fn magnitude(&self) -> Self {
        AlgebraicNumber(self.0.magnitude())
    }
    fn greater(&self, other: &Self) -> Self {
        self.with(other, FieldElement::greater)
    }
    fn over(&self, other: &Self) -> Self {
        self.with(other, FieldElement::over)
    }
}

impl Enclosed for AlgebraicNumber {
    fn enclosure(&self, level: u32) -> Enclosure {
        self.0.enclosure(level)
    }
}

impl fmt::Display for AlgebraicNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
