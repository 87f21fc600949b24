//! Masks over the number field of their coefficients.

use crate::evaluation::masks::numbers;
use crate::exact::{
    AlgebraicNumber, FieldElement, Rational, RealCyclotomic, Scalar as _, common_conductor,
    cosine_polynomial,
};
use crate::formula::{CallError, Value};
use crate::scheme::Mask;

/// A mask over one field Q(2cos(2π/n)) as one over the field that this number generates.
pub(crate) fn over_field<V: Value>(mask: &Mask<V>) -> Result<Mask<FieldElement>, CallError> {
    let mask = numbers(mask)?;
    let all: Vec<RealCyclotomic> = mask.rules().rows().iter().flatten().cloned().collect();
    let conductors = all.iter().map(RealCyclotomic::conductor);
    let conductor = conductors.fold(1, |n, m| common_conductor(n, m).unwrap_or(n));
    let minimal: Vec<AlgebraicNumber> = cosine_polynomial(conductor)
        .coefficients()
        .iter()
        .map(|c| AlgebraicNumber::from_rational(&Rational::from(c.clone())))
        .collect();
    let degree = i64::try_from(minimal.len()).unwrap_or(i64::MAX) - 1;
    // All roots are real, and 2cos(2π/n) is the greatest.
    let generator = AlgebraicNumber::root(&minimal, degree).map_err(|error| {
        error.cap().map_or_else(|| CallError::Misuse(error.to_string()), CallError::BeyondCap)
    })?;
    let generator = generator.element();
    let value = |coordinates: &Vec<Rational>| {
        coordinates.iter().rev().fold(FieldElement::zero(), |sum, c| {
            sum.times(generator).plus(&FieldElement::from_rational(c))
        })
    };
    let coordinates = RealCyclotomic::coordinates(&all);
    let mut values = coordinates.iter().map(value);
    Ok(mask.map(|_| values.next().unwrap_or_else(FieldElement::zero)))
}
