//! Where limits are smooth, by the parameters of a scheme that are left open.

use super::ranges::{ParameterFacts, parameter_facts};
use crate::exact::Polynomial;
use crate::lattice::{LatticeRange, lattice_map, lattice_range};
use crate::scheme::{
    find_definition, open_parameters, parse_in_parameters, parse_lattice_in_parameter,
    parse_lattice_in_parameters,
};
use crate::smoothness::{Sides, SmoothMap, smooth_map};
use std::ops::RangeInclusive;
use std::sync::atomic::AtomicUsize;

/// The orders of smoothness of maps of two parameters.
const MAP_ORDERS: RangeInclusive<usize> = 0..=2;

/// The orders of smoothness of masks on Z^d.
const LATTICE_ORDERS: RangeInclusive<usize> = 0..=1;

/// The boxes of a map of a mask on Z^d, each of which may take a second.
const LATTICE_BOXES: usize = 40;

/// Where limits are smooth, by the parameters that are left open.
#[derive(Clone, Debug)]
pub enum FamilyDrawing {
    /// One parameter.
    One {
        /// Its name.
        parameter: String,
        /// The sets for m = 0, 1, …
        ranges: Vec<ParameterFacts>,
        /// Why they end.
        end: String,
    },
    /// Two parameters.
    Two {
        /// Their names.
        parameters: [String; 2],
        /// The region.
        region: Sides,
        /// The maps for m = 0, 1, …
        maps: Vec<SmoothMap>,
        /// Why they end.
        end: String,
    },
}

impl FamilyDrawing {
    /// `None` of a scheme whose open parameters are neither one nor two in which its coefficients are polynomials.
    ///
    /// ```
    /// use subcert::facts::FamilyDrawing;
    ///
    /// let region = [[-1, 1].map(Into::into), [-1, 1].map(Into::into)];
    /// assert!(matches!(FamilyDrawing::of("four-point", &region, 10), Some(FamilyDrawing::One { .. })));
    /// assert!(FamilyDrawing::of("chaikin", &region, 10).is_none());
    /// ```
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn of(scheme: &str, region: &Sides, boxes: usize) -> Option<FamilyDrawing> {
        match &open_parameters(scheme).ok()?[..] {
            [parameter] => {
                if find_definition(scheme).is_ok_and(|found| found.is_lattice()) {
                    return lattice_family(scheme, parameter);
                }
                let (ranges, end) = parameter_facts(scheme, parameter).ok()?;
                let parameter = parameter.clone();
                (!ranges.is_empty()).then_some(FamilyDrawing::One { parameter, ranges, end })
            }
            [first, second] => two(scheme, [first, second], region, boxes),
            _ => None,
        }
    }
}

/// Maps of two parameters, of a mask on Z^d of fewer boxes.
fn two(scheme: &str, parameters: [&str; 2], region: &Sides, boxes: usize) -> Option<FamilyDrawing> {
    let none = AtomicUsize::new(0);
    let (maps, end) = if find_definition(scheme).is_ok_and(|found| found.is_lattice()) {
        let mask = parse_lattice_in_parameters(scheme, parameters).ok()?;
        let most = boxes.min(LATTICE_BOXES);
        let map = |m: usize| {
            lattice_map(&mask, u32::try_from(m).unwrap_or(u32::MAX), region, most, &none)
        };
        maps(LATTICE_ORDERS, map)
    } else {
        let mask = parse_in_parameters(scheme, &parameters).ok()?;
        let polynomial = |entry: &Polynomial| entry.in_variables(parameters);
        let known = mask.rules().rows().iter().flatten().all(|c| polynomial(c).is_some());
        if !known {
            return None;
        }
        let rules = mask.rules().map(|entry| polynomial(entry).expect("a polynomial"));
        maps(MAP_ORDERS, |m| smooth_map(&rules, m, region, boxes, &none))
    };
    let (parameters, region) = (parameters.map(str::to_owned), region.clone());
    Some(FamilyDrawing::Two { parameters, region, maps, end })
}

/// The maps of these orders, up to the first that cannot be made, and why they end.
fn maps<E: ToString>(
    orders: RangeInclusive<usize>,
    of: impl Fn(usize) -> Result<SmoothMap, E>,
) -> (Vec<SmoothMap>, String) {
    let (last, mut maps) = (*orders.end(), Vec::new());
    for m in orders {
        match of(m) {
            Ok(map) => maps.push(map),
            Err(error) => return (maps, error.to_string()),
        }
    }
    (maps, format!("C^m is asked for up to m = {last}"))
}

/// Where in a parameter the limits of a mask on Z^d are smooth.
fn lattice_family(scheme: &str, parameter: &str) -> Option<FamilyDrawing> {
    let mask = parse_lattice_in_parameter(scheme, parameter).ok()?;
    let mut ranges = Vec::new();
    let mut end = format!("C^m is asked for up to m = {}", LATTICE_ORDERS.end());
    for m in LATTICE_ORDERS {
        match lattice_range(&mask, u32::try_from(m).ok()?) {
            Ok(LatticeRange { inside, outside, but_finitely_many, .. }) => {
                ranges.push(ParameterFacts {
                    m,
                    valence: None,
                    inside,
                    outside,
                    but_finitely_many,
                });
            }
            Err(error) => {
                end = error.to_string();
                break;
            }
        }
    }
    let parameter = parameter.to_owned();
    (!ranges.is_empty()).then_some(FamilyDrawing::One { parameter, ranges, end })
}
