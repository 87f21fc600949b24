//! Numbers of Python, exactly.

use crate::error::{plain, with_remedy};
use num_bigint::BigInt;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt, PyString};
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

fn integer(value: &Bound<'_, PyAny>) -> PyResult<Integer> {
    if let Ok(word) = value.extract::<i64>() {
        return Ok(Integer::from(word));
    }
    let value: BigInt = value.extract()?;
    if value.bits() > MAX_BITS {
        return Err(plain(format!("a number of more than {MAX_BITS} binary digits")));
    }
    let digits = value.magnitude().to_str_radix(10);
    let size = Integer::from_digits(&digits).ok_or_else(|| plain("no integer"))?;
    Ok(if value.sign() == num_bigint::Sign::Minus { -size } else { size })
}

pub(crate) fn whole(value: &Integer) -> Whole {
    match value.to_i64() {
        Some(word) => Whole::Word(word),
        // An integer is printed as its decimal digits.
        None => Whole::Big(value.to_string().parse().unwrap_or_default()),
    }
}

pub(crate) fn fraction(value: &Rational) -> Fraction {
    (whole(&value.numerator()), whole(&value.denominator()))
}

/// An `int`, a `Fraction`, a `Decimal`, a `str` such as `"3/256"` or `"0.1"`, or a `float`, which is the dyadic number that
/// it is; and what numpy has of these.
pub(crate) fn rational(value: &Bound<'_, PyAny>) -> PyResult<Rational> {
    if let Ok(text) = value.cast::<PyString>() {
        let text = text.to_string();
        return parse_rational(&text).map_err(|error| plain(format!("`{text}`: {error}")));
    }
    if value.is_instance_of::<PyBool>() {
        return Err(with_remedy("a bool is no number here", "write 0 or 1"));
    }
    if let Ok(float) = value.cast::<PyFloat>()
        && !float.value().is_finite()
    {
        return Err(with_remedy(&format!("{value} is no number"), "give a finite number"));
    }
    if value.is_instance_of::<PyInt>() {
        return integer(value).map(Rational::from);
    }
    let parts = if let Ok(numerator) = value.getattr("numerator") {
        (numerator, value.getattr("denominator")?)
    } else if let Ok(parts) = value.call_method0("as_integer_ratio") {
        parts.extract()?
    } else {
        let kind = value.get_type().name()?;
        let message = format!("a {kind} is no number");
        return Err(with_remedy(&message, "give an int, a Fraction or a decimal as text"));
    };
    let read = |part: Bound<'_, PyAny>| integer(&part.call_method0("__index__")?);
    let (p, q) = (read(parts.0)?, read(parts.1)?);
    if q.is_zero() {
        return Err(plain("a fraction with denominator 0"));
    }
    Ok(Rational::new(p, q))
}

pub(crate) fn rationals(values: &[Bound<'_, PyAny>]) -> PyResult<Vec<Rational>> {
    values.iter().map(rational).collect()
}
