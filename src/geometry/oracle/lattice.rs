//! Reference values of masks on Z^d.

use super::control::Control;
use super::header::{COLUMNS, Header, SCHEMA, program};
use super::refine::{MAX_REFINED_LEVEL, MAX_VALUES, OracleError};
use super::values::{CONTRACTION, CONTROL, Group, NORM, OracleValues, group};
use crate::exact::Rational;
use crate::lattice::{Functional, LatticeConstants, LatticeSmoothness, convolved, limit_values};
use crate::scheme::{LatticeMask, Point};
use crate::stop::Stop;
use std::collections::BTreeMap;

/// The input of [`lattice_reference_values`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LatticeRequest {
    /// The name of the scheme for the header.
    pub scheme: String,
    /// The greatest c of T_c and Λ_c.
    pub max_block: u32,
    /// A grid in the plane, whose rows are the first index; `None` for a single 1 at 0.
    pub control: Option<Control>,
    /// The number of refinements.
    pub level: u32,
}

const MASK: &str = "a(alpha): x'[alpha] = sum over beta of a(alpha - M*beta)*x[beta]; the first entry is at the place in mask-first";
const REFINED: &str = "the points of the level in the header, where the data are 0 beyond the control points; the first is at the place in refined-first";
const LIMIT: &str =
    "the limit at M^-k*alpha, k the level in the header; the first alpha is in limit-first";
const FIRST: &str = "the indices of the first entry";

/// The reference values of a mask on Z^d: its coefficients, T_c and Λ_c, the data, the data of the level, and the limit at M^{−k}α, where the scheme
/// converges. The data are 0 beyond those given.
///
/// # Errors
/// When the level is too high, there are too many values, or no control points.
///
/// ```
/// use subcert::oracle::{LatticeRequest, lattice_reference_values};
/// use subcert::scheme::parse_lattice;
///
/// let mask = parse_lattice("(1+x)^2*(1+y)^2*(1+x*y)^2/16")?;
/// let request = LatticeRequest { scheme: "mine".to_owned(), max_block: 1, control: None, level: 1 };
/// let values = lattice_reference_values(&mask, &request)?;
/// assert_eq!(values.group("mask").unwrap().shape, [5, 5]);
/// assert_eq!(values.group("limit-first").unwrap().values[0].exact, "1");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lattice_reference_values(
    mask: &LatticeMask,
    request: &LatticeRequest,
) -> Result<OracleValues, OracleError> {
    if request.level > MAX_REFINED_LEVEL {
        return Err(OracleError::Level(request.level));
    }
    let d = mask.dimension();
    let mut groups = Vec::new();
    let mut dense = |name: &str, about, values: &Functional<Rational>| {
        groups.extend(boxed(name, about, values, d)?);
        Ok::<(), OracleError>(())
    };
    dense("mask", MASK, mask.coefficients())?;
    let data = data(request.control.as_ref())?;
    dense("control", CONTROL, &data)?;
    let mut refined = data;
    for _ in 0..request.level {
        if refined.len().saturating_mul(mask.coefficients().len()) > MAX_VALUES {
            return Err(OracleError::TooMany);
        }
        let image = |place: &Point| mask.dilation().times(*place);
        refined =
            convolved(refined.iter().map(|(place, x)| (image(place), x)), mask.coefficients());
    }
    dense("refined", REFINED, &refined)?;
    let converges = LatticeSmoothness::convergence(mask, &Stop::default()).converges;
    if let (Some(true), Ok(Some(phi))) = (converges, limit_values(mask, 0)) {
        if refined.len().saturating_mul(phi.len()) > MAX_VALUES {
            return Err(OracleError::TooMany);
        }
        dense("limit", LIMIT, &convolved(refined.iter().map(|(place, x)| (*place, x)), &phi))?;
    }
    let (contraction, norm) = constants(mask, request.max_block);
    groups.push(group("contraction-constant", CONTRACTION, &[contraction.len()], 1, &contraction));
    groups.push(group("scheme-norm", NORM, &[norm.len()], 1, &norm));
    let header = Header {
        program: program(),
        scheme: request.scheme.clone(),
        masks: Vec::new(),
        ring: None,
        max_block: request.max_block,
        level: request.level,
        boundary: None,
        seed: request.control.as_ref().and_then(Control::seed).map(|seed| seed.to_string()),
        first_index: Vec::new(),
        notes: Vec::new(),
        columns: COLUMNS,
    };
    Ok(OracleValues { schema: SCHEMA, header, groups })
}

/// The data at their places.
fn data(control: Option<&Control>) -> Result<Functional<Rational>, OracleError> {
    let Some(control) = control else {
        return Ok(BTreeMap::from([([0; 3], Rational::one())]));
    };
    if control.values().is_empty() {
        return Err(OracleError::Empty);
    }
    if !control.is_grid() {
        let (found, expected) = ("polygon", "grid");
        return Err(OracleError::Shape { found, scheme: "mask on Z^2", expected });
    }
    let rows = control.values().chunks(control.columns());
    let entries = (0..)
        .zip(rows)
        .flat_map(|(i, row)| (0..).zip(row).map(move |(j, value)| ([i, j, 0], value.clone())));
    Ok(entries.collect())
}

/// T_c and Λ_c, as far as the caps allow.
fn constants(mask: &LatticeMask, most: u32) -> (Vec<Rational>, Vec<Rational>) {
    let (mut contraction, mut norm) = (Vec::new(), Vec::new());
    let mut all = LatticeConstants::new(mask);
    for _ in 0..most {
        if all.advance().is_err() {
            break;
        }
        let Ok(found) = all.contraction() else { break };
        contraction.push(found.value);
        norm.push(all.norm());
    }
    (contraction, norm)
}

/// The values in the least box that contains their places, and the place of the first.
fn boxed(
    name: &str,
    about: &'static str,
    values: &Functional<Rational>,
    d: usize,
) -> Result<[Group; 2], OracleError> {
    let ends = |axis: usize| {
        let at = values.keys().map(move |place| place[axis]);
        let (low, high) = (at.clone().min().unwrap_or(0), at.max().unwrap_or(0));
        (low, usize::try_from(high - low).unwrap_or(usize::MAX).saturating_add(1))
    };
    let sides: Vec<(i64, usize)> = (0..d).map(ends).collect();
    let shape: Vec<usize> = sides.iter().map(|(_, count)| *count).collect();
    let count = shape.iter().fold(1_usize, |product, side| product.saturating_mul(*side));
    if count > MAX_VALUES {
        return Err(OracleError::TooMany);
    }
    let first: Vec<Rational> = sides.iter().map(|(low, _)| Rational::from(*low)).collect();
    let mut all = vec![Rational::zero(); count];
    for (place, value) in values {
        let at = sides
            .iter()
            .zip(place)
            .fold(0, |at, ((low, side), x)| at * side + usize::try_from(x - low).unwrap_or(0));
        all[at] = value.clone();
    }
    Ok([
        group(name, about, &shape, 0, &all),
        group(&format!("{name}-first"), FIRST, &[d], 0, &first),
    ])
}
