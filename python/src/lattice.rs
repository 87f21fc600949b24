//! Masks on Z^d.

use crate::analysis::{Exponent, exponent};
use crate::error::{of_scheme, plain};
use crate::number::{Fraction, fraction, rational};
use crate::run::aside;
use pyo3::prelude::*;
use subcert::exact::Rational;
use subcert::lattice::{
    LatticeConstants, LatticeDistance, LatticeSmoothness, displacement, limit_values, natural_shift,
};
use subcert::scheme::{LatticeMask, Point, parse_lattice};
use subcert::stop::Stop;

/// The most levels of a depth.
const MAX_DEPTH: u32 = 400;

/// Places with numbers.
type Places = Vec<(Vec<i64>, Fraction)>;

/// The dilation matrix, the coefficients, the edges, the natural shift.
type Parts = (Vec<Vec<i64>>, Places, Vec<Vec<i64>>, Vec<Fraction>);

/// The order of the sum rules, the accuracy, whether the scheme converges, the proven order, the least that fails, the exponent, what is open.
type Known =
    (u32, Option<u32>, Option<bool>, Option<u32>, Option<u32>, Option<Exponent>, Option<String>);

fn mask(text: &str) -> PyResult<LatticeMask> {
    parse_lattice(text).map_err(|error| of_scheme(&error))
}

fn placed<'a>(
    values: impl IntoIterator<Item = (&'a Point, &'a Rational)>,
    dimension: usize,
) -> Places {
    let one = |(at, value): (&Point, &Rational)| (at[..dimension].to_vec(), fraction(value));
    values.into_iter().map(one).collect()
}

/// The parts of a mask on Z^d.
#[pyfunction]
pub fn lattice_parts(text: &str) -> PyResult<Parts> {
    let mask = mask(text)?;
    let d = mask.dimension();
    let rows = mask.dilation().rows().map(<[i64]>::to_vec).collect();
    let edges = mask.edges().iter().map(|edge| edge[..d].to_vec()).collect();
    let shift = natural_shift(&mask).iter().map(fraction).collect();
    Ok((rows, placed(mask.coefficients(), d), edges, shift))
}

/// T_c and Λ_c.
#[pyfunction]
pub fn lattice_constants(py: Python<'_>, text: &str, c: u32) -> PyResult<(Fraction, Fraction)> {
    if c == 0 {
        return Err(plain("c counts levels from 1 on"));
    }
    let mask = mask(text)?;
    aside(py, move || {
        let mut all = LatticeConstants::new(&mask);
        for _ in 0..c {
            all.advance().map_err(plain)?;
        }
        let found = all.contraction().map_err(plain)?;
        Ok((fraction(&found.value), fraction(&all.norm())))
    })
}

/// Where points stand: at their natural places, or at M^{−k}α.
fn shift(mask: &LatticeMask, natural: bool) -> Vec<Rational> {
    if natural { natural_shift(mask) } else { vec![Rational::zero(); mask.dimension()] }
}

/// σ; `None` where it is not defined.
#[pyfunction]
pub fn lattice_displacement(
    py: Python<'_>,
    text: &str,
    natural: bool,
) -> PyResult<Option<Fraction>> {
    let mask = mask(text)?;
    aside(py, move || {
        let found = displacement(&mask, &shift(&mask, natural)).map_err(plain)?;
        Ok(found.as_ref().map(fraction))
    })
}

/// The fewest levels that may be enough for all nets of a spread, and a number that is.
#[pyfunction]
pub fn lattice_depth(
    py: Python<'_>,
    text: &str,
    tolerance: &Bound<'_, PyAny>,
    spread: &Bound<'_, PyAny>,
    natural: bool,
) -> PyResult<(u32, Option<u32>)> {
    let (tolerance, spread) = (rational(tolerance)?, rational(spread)?);
    if tolerance.sign() <= 0 || spread.sign() <= 0 {
        return Err(plain("the tolerance and the spread are positive"));
    }
    let mask = mask(text)?;
    aside(py, move || {
        let all = LatticeConstants::up_to_cap(&mask).map_err(plain)?;
        let found = LatticeDistance::of(&mask, &shift(&mask, natural), all).map_err(plain)?;
        let found = found.ok_or_else(|| {
            plain("no T_c is below 1, or nets of this mask have no distances: the depth is open")
        })?;
        Ok(found.depth(&spread, &tolerance, MAX_DEPTH))
    })
}

/// The values of the basic limit function at M^{−k}Z^d.
#[pyfunction]
pub fn lattice_values(py: Python<'_>, text: &str, level: u32) -> PyResult<Places> {
    let mask = mask(text)?;
    aside(py, move || {
        let converges = LatticeSmoothness::convergence(&mask, &Stop::default()).converges;
        let values = limit_values(&mask, level).map_err(plain)?;
        let values = values.filter(|_| converges == Some(true));
        let values = values.ok_or_else(|| plain("the scheme is not shown to converge"))?;
        Ok(placed(&values, mask.dimension()))
    })
}

/// How smooth the limits are.
#[pyfunction]
pub fn lattice_smoothness(py: Python<'_>, text: &str) -> PyResult<Known> {
    let mask = mask(text)?;
    aside(py, move || {
        let found = LatticeSmoothness::until(&mask, &Stop::default());
        Ok((
            found.sum_rules,
            found.accuracy,
            found.converges,
            found.continuity,
            found.continuity_fails,
            found.hoelder.as_ref().map(exponent),
            found.open,
        ))
    })
}
