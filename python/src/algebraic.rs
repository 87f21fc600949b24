//! Real algebraic numbers.

use crate::error::plain;
use crate::number::{Fraction, Whole, fraction, integer, quotient, rational, whole};
use crate::run::at_once;
use pyo3::prelude::*;
use std::cmp::Ordering;
use subcert::exact::{Enclosed, Integer, IntegerPolynomial, Rational, RealAlgebraic};
use subcert::float::nearest;

/// The most decimal digits of an interval.
const MAX_DIGITS: u32 = 10_000;

/// A real algebraic number, exactly.
#[pyclass(frozen, module = "subcert", name = "_Algebraic")]
pub struct Algebraic(pub(crate) RealAlgebraic);

#[pymethods]
impl Algebraic {
    /// The coefficients of the minimal polynomial, from the constant one on.
    #[getter]
    fn minpoly(&self) -> PyResult<Vec<Whole>> {
        at_once(|| {
            let polynomial = self.0.minimal_polynomial();
            let polynomial =
                polynomial.ok_or_else(|| plain("the polynomial is too large to factor"))?;
            Ok(polynomial.coefficients().iter().map(whole).collect())
        })
    }

    /// Two fractions that the number is between, at most 10^-digits apart.
    fn interval(&self, digits: u32) -> PyResult<(Fraction, Fraction)> {
        if digits > MAX_DIGITS {
            return Err(plain(format!("{digits} digits are too many; at most {MAX_DIGITS} are")));
        }
        at_once(|| {
            let digits = i32::try_from(digits).unwrap_or(i32::MAX);
            let width = Rational::power_of_ten(-digits);
            // The widths fall as 2^(-64·2^level).
            let mut enclosures = (0..).map(|level| self.0.enclosure(level));
            let narrow = enclosures.find(|enclosure| enclosure.width() <= width);
            let enclosure = narrow.ok_or_else(|| plain("no such interval"))?;
            Ok((fraction(enclosure.lower()), fraction(enclosure.upper())))
        })
    }

    /// A polynomial with this root, and two fractions that no other of its roots is between.
    fn parts(&self) -> (Vec<Whole>, Fraction, Fraction) {
        let (low, high) = self.0.bounds();
        let polynomial = self.0.polynomial();
        let coefficients = polynomial.coefficients().iter().map(whole).collect();
        (coefficients, fraction(&low), fraction(&high))
    }

    /// The number with these parts.
    #[staticmethod]
    fn of_parts(
        coefficients: Vec<Bound<'_, PyAny>>,
        low: (Bound<'_, PyAny>, Bound<'_, PyAny>),
        high: (Bound<'_, PyAny>, Bound<'_, PyAny>),
    ) -> PyResult<Algebraic> {
        let coefficients = coefficients.iter().map(integer).collect::<PyResult<Vec<_>>>()?;
        let (low, high) = (quotient(&low)?, quotient(&high)?);
        if coefficients.iter().all(Integer::is_zero) {
            return Err(plain("every number is a root of 0"));
        }
        at_once(|| {
            let inside = |root: &RealAlgebraic| {
                root.cmp_rational(&low).is_ge() && root.cmp_rational(&high).is_le()
            };
            let roots = RealAlgebraic::roots_of(&IntegerPolynomial::new(coefficients));
            let mut roots = roots.into_iter().filter(inside);
            match (roots.next(), roots.next()) {
                (Some(root), None) => Ok(Algebraic(root)),
                _ => Err(plain("the polynomial has not one root in the interval")),
            }
        })
    }

    fn as_fraction(&self) -> Option<Fraction> {
        self.0.as_rational().map(fraction)
    }

    fn __float__(&self) -> PyResult<f64> {
        at_once(|| Ok(nearest(&self.0)))
    }

    /// -1, 0 or 1 as this is less than, equal to or greater than the other number.
    fn compare(&self, other: &Bound<'_, PyAny>) -> PyResult<i8> {
        let order = match other.cast::<Algebraic>() {
            Ok(other) => self.0.cmp(&other.get().0),
            Err(_) => self.0.cmp_rational(&rational(other)?),
        };
        Ok(match order {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        })
    }
}
