//! Numbers of Python, exactly.

use crate::error::{SubcertError, plain, with_remedy};
use num_bigint::BigInt;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyInt, PyString};
use subcert::exact::{Integer, Rational, parse_rational};

/// A fraction in lowest terms as Python's integers.
pub(crate) type Fraction = (Whole, Whole);

/// An integer on its way to Python: most fit into a word, which is faster.
#[derive(IntoPyObject)]
pub(crate) enum Whole {
    Word(i64),
    Big(BigInt),
}

/// The most binary digits of a number that is read.
const MAX_BITS: u64 = 1 << 20;

pub(crate) fn integer(value: &Bound<'_, PyAny>) -> PyResult<Integer> {
    if let Ok(word) = value.extract::<i64>() {
        return Ok(Integer::from(word));
    }
    let value: BigInt = value.extract()?;
    if value.bits() > MAX_BITS {
        return Err(plain(format!("a number of more than {MAX_BITS} binary digits")));
    }
    Ok(Integer::from(value))
}

pub(crate) fn whole(value: &Integer) -> Whole {
    match value.to_i64() {
        Some(word) => Whole::Word(word),
        None => Whole::Big(BigInt::from(value)),
    }
}

pub(crate) fn fraction(value: &Rational) -> Fraction {
    (whole(&value.numerator()), whole(&value.denominator()))
}

/// An `int`, a `Fraction`, a `Decimal`, a `str` such as `"3/256"` or `"0.1"`, or a `float`, which is the dyadic number that
/// it is; what numpy has of these, also as an array without axes; and what has an `as_integer_ratio`.
pub(crate) fn rational(value: &Bound<'_, PyAny>) -> PyResult<Rational> {
    if let Ok(text) = value.cast::<PyString>() {
        let text = text.to_string();
        return parse_rational(&text).map_err(|error| plain(format!("`{text}`: {error}")));
    }
    if value.is_instance_of::<PyBool>() {
        return Err(with_remedy("a bool is no number here", "write 0 or 1"));
    }
    if value.is_instance_of::<PyInt>() {
        return integer(value).map(Rational::from);
    }
    let parts = if let Ok(numerator) = value.getattr("numerator") {
        (numerator, value.getattr("denominator")?)
    } else if let Ok(ratio) = value.getattr("as_integer_ratio") {
        match ratio.call0() {
            Ok(parts) => parts.extract()?,
            Err(error) if error.is_instance_of::<SubcertError>(value.py()) => return Err(error),
            // It is infinite, or no number.
            Err(_) => {
                return Err(with_remedy(&format!("{value} is no number"), "give a finite number"));
            }
        }
    } else {
        // An array without axes, or a number of numpy that Python has as well.
        let single = value.getattr("shape").is_ok_and(|shape| shape.is_empty().unwrap_or(false));
        let item = single.then(|| value.call_method0("item")).transpose()?;
        let kind = value.get_type();
        return match item {
            Some(item) if !item.get_type().is(&kind) => rational(&item),
            _ => {
                let message = format!("a {} is no number", kind.name()?);
                Err(with_remedy(&message, "give an int, a Fraction or a decimal as text"))
            }
        };
    };
    quotient(&parts)
}

/// What is read as an exact number, as a fraction.
#[pyfunction]
pub fn exact(value: &Bound<'_, PyAny>) -> PyResult<Fraction> {
    rational(value).map(|value| fraction(&value))
}

/// The quotient of two integers.
pub(crate) fn quotient((p, q): &(Bound<'_, PyAny>, Bound<'_, PyAny>)) -> PyResult<Rational> {
    let read = |part: &Bound<'_, PyAny>| integer(&part.call_method0("__index__")?);
    let (p, q) = (read(p)?, read(q)?);
    if q.is_zero() {
        return Err(plain("a fraction with denominator 0"));
    }
    Ok(Rational::new(p, q))
}

pub(crate) fn rationals(values: &[Bound<'_, PyAny>]) -> PyResult<Vec<Rational>> {
    values.iter().map(rational).collect()
}
