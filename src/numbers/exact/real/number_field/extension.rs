//! Roots of polynomials over Q(α).

use super::element::{Field, FieldElement};
use super::error::{FieldError, MAX_FIELD_DEGREE, MAX_NORM_DEGREE};
use crate::exact::polynomials::dense::{
    composed, greatest_divisor, product, square_free, trimmed, value_at,
};
use crate::exact::{
    Enclosed as _, Enclosure, IntegerPolynomial, Rational, RationalPolynomial, RealAlgebraic,
    Scalar as _, determinant, interpolated, solve,
};
use std::sync::Arc;

/// The factors k of λ + kα that are tried in turn.
const FACTORS: [i64; 9] = [0, 1, -1, 2, -2, 3, -3, 4, -4];

/// α and λ as numbers of one field.
pub(super) struct Extension {
    pub(super) generator: FieldElement,
    pub(super) root: FieldElement,
}

/// The number p(α), with this number in place of α.
pub(super) fn image(number: &FieldElement, generator: &FieldElement) -> FieldElement {
    value_at(&constants(&number.value.coefficients()), generator)
}

fn constants(coefficients: &[Rational]) -> Vec<FieldElement> {
    coefficients.iter().map(FieldElement::from_rational).collect()
}

/// The field that has these numbers, which are in one.
fn field_of(numbers: &[FieldElement]) -> Option<&Arc<Field>> {
    numbers.iter().find_map(|number| number.field.as_ref())
}

impl FieldElement {
    /// The distinct real roots of the polynomial with these coefficients, from the constant term upwards, in
    /// increasing order. The coefficients are of one field.
    ///
    /// The norm of p over the rationals is the product of all its conjugates, and has its roots. In an interval that
    /// isolates a root of the norm, a square-free p changes its sign if and only if this is its root.
    ///
    /// # Errors
    /// For the polynomial 0, and beyond the cap on the degree of the norm.
    ///
    /// ```
    /// use subcert::exact::{FieldElement, Rational, Scalar, format::fixed};
    ///
    /// // x² − √2.
    /// let number = |c: i64| FieldElement::from_rational(&Rational::from(c));
    /// let root = FieldElement::root(&[number(-2), number(0), number(1)], 2)?;
    /// let roots = FieldElement::real_roots(&[number(0).minus(&root), number(0), number(1)])?;
    /// let decimals: Vec<String> = roots.iter().map(|root| fixed(root, 6)).collect();
    /// assert_eq!(decimals, ["-1.189207", "1.189207"]);
    /// # Ok::<(), subcert::exact::FieldError>(())
    /// ```
    pub fn real_roots(coefficients: &[FieldElement]) -> Result<Vec<RealAlgebraic>, FieldError> {
        let p = trimmed(coefficients.to_vec());
        if p.is_empty() {
            return Err(FieldError::Zero);
        }
        let Some(field) = field_of(&p) else {
            let rational: Vec<Rational> = p.iter().filter_map(FieldElement::as_rational).collect();
            let norm = IntegerPolynomial::over_common_denominator(&rational);
            check_norm(p.len() - 1)?;
            return Ok(RealAlgebraic::roots_of(&norm));
        };
        check_norm(field.degree() * (p.len() - 1))?;
        let p = square_free(&p);
        let roots = RealAlgebraic::roots_of(&norm(&p, field)?);
        let sign = |x: &Rational| value_at(&p, &FieldElement::from_rational(x)).sign();
        let is_root = |root: &RealAlgebraic| {
            let (low, high) = root.bounds();
            // The ends of the interval of an irrational root are no roots of the norm.
            if low == high { sign(&low) == 0 } else { sign(&low) != sign(&high) }
        };
        Ok(roots.into_iter().filter(is_root).collect())
    }

    /// The real root of this number, counted from 1 in increasing order, of the polynomial with these coefficients,
    /// which are of one field.
    ///
    /// # Errors
    /// As [`real_roots`](Self::real_roots), when there is no such root, and when it is in no field within the caps.
    ///
    /// ```
    /// use subcert::exact::{FieldElement, Rational, Scalar};
    ///
    /// let number = |c: i64| FieldElement::from_rational(&Rational::from(c));
    /// let root = FieldElement::root(&[number(-3), number(0), number(1)], 2)?;
    /// assert_eq!(root.times(&root), number(3));
    /// assert_eq!(root.plus(&number(1)).to_string(), "1 + t");
    /// # Ok::<(), subcert::exact::FieldError>(())
    /// ```
    pub fn root(coefficients: &[FieldElement], number: i64) -> Result<FieldElement, FieldError> {
        let roots = FieldElement::real_roots(coefficients)?;
        let place = usize::try_from(number).ok().and_then(|number| number.checked_sub(1));
        let no_such = FieldError::NoSuchRoot { found: roots.len(), asked: number };
        let root = place.and_then(|place| roots.get(place)).ok_or(no_such)?;
        FieldElement::adjoined(coefficients, root).map(|(_, root)| root)
    }

    /// The coefficients of a polynomial, which are of one field, and one of its real roots, in one field.
    ///
    /// # Errors
    /// When no field within the caps has them.
    pub fn adjoined(
        coefficients: &[FieldElement],
        root: &RealAlgebraic,
    ) -> Result<(Vec<FieldElement>, FieldElement), FieldError> {
        let extension = adjoin(field_of(coefficients), coefficients, root)?;
        let inside = coefficients.iter().map(|c| image(c, &extension.generator)).collect();
        Ok((inside, extension.root))
    }
}

fn check_norm(degree: usize) -> Result<(), FieldError> {
    if degree > MAX_NORM_DEGREE { Err(FieldError::Norm(degree)) } else { Ok(()) }
}

/// Q(α, λ) for a real root λ of a polynomial P over Q(α), which is generated by γ = λ + kα for some k.
///
/// γ is a root of the norm of P(z − kα). The minimal polynomial of α and P(y; γ − ky), where y stands for α in the
/// coefficients of P, have the common root α. Where it is the only one, their greatest common divisor is linear, and
/// gives α as a number of Q(γ). `proofs/THEOREMS.md`, 120.
pub(super) fn adjoin(
    field: Option<&Arc<Field>>,
    polynomial: &[FieldElement],
    root: &RealAlgebraic,
) -> Result<Extension, FieldError> {
    let one = FieldElement::from_rational(&Rational::one());
    let Some(field) = field else {
        return Ok(Extension { generator: one, root: generated(root)? });
    };
    let alpha = FieldElement::of(RationalPolynomial::variable(), Some(field));
    if let Some(value) = root.as_rational() {
        return Ok(Extension { generator: alpha, root: FieldElement::from_rational(value) });
    }
    for k in FACTORS.map(Rational::from) {
        let step = FieldElement::from_rational(&-&k).times(&alpha);
        let norm = norm(&composed(polynomial, &[step, one.clone()]), field)?;
        let Some(gamma) = nearest_root(&norm, root, &alpha, &k) else { continue };
        let gamma = generated(&gamma)?;
        let Some(generator) = common_root(field, polynomial, &gamma, &k) else { continue };
        let root = gamma.minus(&FieldElement::from_rational(&k).times(&generator));
        return Ok(in_smaller_field(field, alpha, &generator, &root)
            .unwrap_or(Extension { generator, root }));
    }
    Err(FieldError::Degree)
}

fn generated(root: &RealAlgebraic) -> Result<FieldElement, FieldError> {
    let generator = FieldElement::generator(root).ok_or(FieldError::Degree)?;
    let degree = generator.field.as_ref().map_or(1, |field| field.degree());
    if degree > MAX_FIELD_DEGREE { Err(FieldError::Degree) } else { Ok(generator) }
}

/// The product of all conjugates of a polynomial over Q(α), by its values at integers: determinants of the
/// multiplication by p(z) in the basis 1, α, α², ….
fn norm(p: &[FieldElement], field: &Arc<Field>) -> Result<IntegerPolynomial, FieldError> {
    let degree = field.degree() * (p.len() - 1);
    check_norm(degree)?;
    let alpha = FieldElement::of(RationalPolynomial::variable(), Some(field));
    let value = |z: i64| {
        let mut row = value_at(p, &FieldElement::from_rational(&Rational::from(z)));
        let rows = (0..field.degree()).map(|_| {
            let next = row.times(&alpha);
            coordinates(&std::mem::replace(&mut row, next), field.degree())
        });
        determinant(&rows.collect::<Vec<_>>())
    };
    let places = (0..).take(degree + 1);
    let values: Vec<Rational> = places.map(value).collect();
    Ok(IntegerPolynomial::over_common_denominator(&interpolated(&values)))
}

fn coordinates(number: &FieldElement, degree: usize) -> Vec<Rational> {
    let mut coordinates = number.value.coefficients();
    coordinates.resize(degree, Rational::zero());
    coordinates
}

/// λ + kα as a root of the norm: the only one that enclosures do not tell from it.
fn nearest_root(
    norm: &IntegerPolynomial,
    lambda: &RealAlgebraic,
    alpha: &FieldElement,
    k: &Rational,
) -> Option<RealAlgebraic> {
    if norm.is_zero() {
        return None;
    }
    let mut roots = RealAlgebraic::roots_of(norm);
    for level in 0.. {
        let multiple = &Enclosure::exact(k.clone()) * &alpha.enclosure(level);
        let here = &lambda.enclosure(level) + &multiple;
        roots.retain(|root| {
            let other = root.enclosure(level);
            other.lower() <= here.upper() && here.lower() <= other.upper()
        });
        if roots.len() <= 1 {
            break;
        }
    }
    roots.pop()
}

/// The common root of the minimal polynomial of α and P(y; γ − ky), if it is the only one.
fn common_root(
    field: &Arc<Field>,
    polynomial: &[FieldElement],
    gamma: &FieldElement,
    k: &Rational,
) -> Option<FieldElement> {
    let line = [gamma.clone(), FieldElement::from_rational(&-k)];
    let mut power = vec![FieldElement::from_rational(&Rational::one())];
    let mut sum: Vec<FieldElement> = Vec::new();
    for c in polynomial {
        let term = product(&constants(&c.value.coefficients()), &power);
        sum.resize(sum.len().max(term.len()), FieldElement::zero());
        sum.iter_mut().zip(&term).for_each(|(x, t)| x.accumulate(t));
        power = product(&power, &line);
    }
    let minimal: Vec<Rational> =
        field.minimal.coefficients().iter().cloned().map(Rational::from).collect();
    match &greatest_divisor(&constants(&minimal), &sum)[..] {
        [constant, _] => Some(FieldElement::zero().minus(constant)),
        _ => None,
    }
}

/// α and λ in Q(α), if λ is in it: the field is then no larger.
fn in_smaller_field(
    field: &Arc<Field>,
    alpha: FieldElement,
    generator: &FieldElement,
    root: &FieldElement,
) -> Option<Extension> {
    let degree = field.degree();
    if generator.field.as_ref()?.degree() != degree {
        return None;
    }
    let mut columns = Vec::with_capacity(degree + 1);
    let mut power = FieldElement::from_rational(&Rational::one());
    for _ in 0..degree {
        columns.push(coordinates(&power, degree));
        power = power.times(generator);
    }
    columns.push(coordinates(root, degree));
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    let solution = solve(&(0..degree).map(row).collect::<Vec<Vec<Rational>>>())?;
    let root = FieldElement::of(RationalPolynomial::new(&solution), Some(field));
    Some(Extension { generator: alpha, root })
}
