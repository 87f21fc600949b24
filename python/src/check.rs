//! Values of programs against exact ones.

use crate::error::plain;
use crate::number::{rational, rationals};
use crate::run::at_once;
use pyo3::prelude::*;
use subcert::oracle::check_slice_within_ulps;

/// `None` if every value is within so many units in the last place of the exact one; otherwise what is
/// wrong, with the first value that is not and the worst one.
#[pyfunction]
pub fn check_within_ulps(
    values: Vec<f64>,
    exact: Vec<Bound<'_, PyAny>>,
    ulps: f64,
) -> PyResult<Option<String>> {
    if ulps.is_nan() || ulps < 0.0 {
        return Err(plain(format!("{ulps} units in the last place: it must be 0 or more")));
    }
    let exact = rationals(&exact)?;
    at_once(|| Ok(check_slice_within_ulps(&values, &exact, ulps).err().map(|x| x.to_string())))
}

/// The f64 nearest to an exact number.
#[pyfunction]
pub fn nearest(value: &Bound<'_, PyAny>) -> PyResult<f64> {
    let value = rational(value)?;
    at_once(|| Ok(subcert::float::nearest(&value)))
}
