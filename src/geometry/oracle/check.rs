//! Checks of f64 values against exact ones.

use super::mismatch::{Deviation, Mismatch, Tolerance};
use crate::exact::{Rational, RealCyclotomic};
use crate::float::{exact as exact_of, ulps_between};
use std::cmp::Ordering;

/// Checks that `value` is at most `ulps` units in the last place from `exact`, in the
/// sense of [`ulps_between`]. The comparison is exact. 0.5 requires a correctly rounded
/// value, and 0 an exact one. NaN and the infinities always fail. The exact value is a
/// [`Rational`], a [`RealCyclotomic`], or a number of num-rational, num-bigint or rug.
///
/// # Errors
/// When the distance is greater.
///
/// # Panics
/// When `ulps` is negative or NaN.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::oracle::check_within_ulps;
///
/// let exact = Rational::new(3, 10);
/// assert!(check_within_ulps(0.3, &exact, 0.5).is_ok());
/// let error = check_within_ulps(0.1 + 0.2, &exact, 0.5).unwrap_err();
/// assert!(error.to_string().contains("0x1.3333333333334p-2"));
/// ```
pub fn check_within_ulps<E: Clone + Into<RealCyclotomic>>(
    value: f64,
    exact: &E,
    ulps: f64,
) -> Result<(), Mismatch> {
    let exact = exact.clone().into();
    if ulps_are_within(value, &exact, ulps) {
        return Ok(());
    }
    let deviation = Box::new(Deviation { index: None, value, exact });
    Err(Mismatch::Value { tolerance: Tolerance::Ulps(ulps), deviation })
}

/// [`check_within_ulps`] for every pair of two slices.
///
/// # Errors
/// When some value fails; the error names the first and the worst one. Also when the
/// slices differ in length.
///
/// # Panics
/// When `ulps` is negative or NaN.
pub fn check_slice_within_ulps<E: Clone + Into<RealCyclotomic>>(
    values: &[f64],
    exact: &[E],
    ulps: f64,
) -> Result<(), Mismatch> {
    check_ulps(ulps);
    if values.len() != exact.len() {
        return Err(Mismatch::Length { values: values.len(), exact: exact.len() });
    }
    let pairs = values.iter().zip(exact).enumerate().map(|(at, (value, exact))| Deviation {
        index: Some(at),
        value: *value,
        exact: exact.clone().into(),
    });
    let wrong: Vec<Deviation> =
        pairs.filter(|pair| !ulps_are_within(pair.value, &pair.exact, ulps)).collect();
    let Some(first) = wrong.first().cloned() else { return Ok(()) };
    let worse = |left: Deviation, right: &Deviation| match (left.ulps(), right.ulps()) {
        (Some(_), None) => right.clone(),
        (Some(x), Some(y)) if x.cmp(&y) == Ordering::Less => right.clone(),
        _ => left,
    };
    let worst = Box::new(wrong.iter().fold(first.clone(), worse));
    Err(Mismatch::Slice {
        tolerance: Tolerance::Ulps(ulps),
        wrong: wrong.len(),
        total: values.len(),
        first: Box::new(first),
        worst,
    })
}

/// Checks that |`value` − `exact`| ≤ `tolerance`. The comparison is exact. NaN and the
/// infinities always fail.
///
/// # Errors
/// When the distance is greater.
///
/// # Panics
/// When `tolerance` is negative.
pub fn check_within<E: Clone + Into<RealCyclotomic>>(
    value: f64,
    exact: &E,
    tolerance: &(impl Clone + Into<Rational>),
) -> Result<(), Mismatch> {
    let tolerance: Rational = tolerance.clone().into();
    assert!(tolerance.sign() >= 0, "a tolerance must not be negative, and is {tolerance}");
    let exact: RealCyclotomic = exact.clone().into();
    let distance = |found| (&RealCyclotomic::from(found) - &exact).abs();
    let allowed = RealCyclotomic::from(tolerance.clone());
    if exact_of(value).is_some_and(|found| distance(found) <= allowed) {
        return Ok(());
    }
    let deviation = Box::new(Deviation { index: None, value, exact });
    Err(Mismatch::Value { tolerance: Tolerance::Absolute(tolerance), deviation })
}

fn check_ulps(ulps: f64) {
    assert!(ulps >= 0.0, "a tolerance in ulps must be 0 or more, and is {ulps}");
}

fn ulps_are_within(value: f64, exact: &RealCyclotomic, ulps: f64) -> bool {
    check_ulps(ulps);
    match (ulps_between(value, exact), exact_of(ulps)) {
        (None, _) => false,
        // An infinite tolerance still requires a finite value.
        (Some(_), None) => true,
        (Some(distance), Some(allowed)) => distance <= RealCyclotomic::from(allowed),
    }
}
