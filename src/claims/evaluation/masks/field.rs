//! Masks over the number field of their coefficients.

use super::common::{converted, numbers};
use crate::exact::{
    AlgebraicNumber, FieldElement, Rational, RealCyclotomic, Scalar as _, common_conductor,
    cosine_polynomial,
};
use crate::formula::{CallError, FormulaErrorKind, Value};
use crate::scheme::Mask;

/// A mask over one real field; of one over Q(2cos(2π/n)) it is the field that this number generates.
pub(crate) fn over_field<V: Value>(mask: &Mask<V>) -> Result<Mask<FieldElement>, CallError> {
    if let Some(mask) = converted(mask, V::element) {
        return Ok(mask);
    }
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
    // Where this field is too large, that of the coefficients may be smaller.
    let generator = AlgebraicNumber::root(&minimal, degree)
        .map_err(|_| CallError::Inner(FormulaErrorKind::OtherReal("a coefficient".to_owned())))?;
    let generator = generator.element();
    let two = FieldElement::from_rational(&Rational::from(2));
    // C_0 = 1 and C_k = 2cos(2πk/n) = C_1·C_{k−1} − C_{k−2}, with 2 for C_0 in the one of k = 2.
    let mut basis = vec![FieldElement::from_rational(&Rational::one()), generator.clone()];
    let coordinates = RealCyclotomic::coordinates(&all);
    for k in 2..coordinates.iter().map(Vec::len).max().unwrap_or(0) {
        let before = if k == 2 { two.clone() } else { basis[k - 2].clone() };
        basis.push(generator.times(&basis[k - 1]).minus(&before));
    }
    let value = |coordinates: &Vec<Rational>| {
        let terms = coordinates.iter().zip(&basis);
        terms.fold(FieldElement::zero(), |sum, (c, element)| {
            sum.plus(&element.times(&FieldElement::from_rational(c)))
        })
    };
    let mut values = coordinates.iter().map(value);
    Ok(mask.map(|_| values.next().unwrap_or_else(FieldElement::zero)))
}
