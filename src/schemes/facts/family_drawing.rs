//! Where limits are smooth, by the parameters of a scheme that are left open.

use super::ranges::{ParameterFacts, parameter_facts};
use crate::exact::Polynomial;
use crate::lattice::{LatticeRange, lattice_range};
use crate::scheme::{
    find_definition, open_parameters, parse_in_parameters, parse_lattice_in_parameter,
};
use crate::smoothness::{Sides, SmoothMap, smooth_map};
use std::sync::atomic::AtomicUsize;

/// The orders of smoothness of maps of two parameters.
const MAP_ORDERS: std::ops::RangeInclusive<usize> = 0..=2;

/// The orders of smoothness of masks on Z^d, in one parameter.
const LATTICE_ORDERS: std::ops::RangeInclusive<u32> = 0..=1;

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
            [first, second] => {
                let mask = parse_in_parameters(scheme, &[first, second]).ok()?;
                let polynomial = |entry: &Polynomial| entry.in_variables([first, second]);
                let known = mask.rules().rows().iter().flatten().all(|c| polynomial(c).is_some());
                if !known {
                    return None;
                }
                let rules = mask.rules().map(|entry| polynomial(entry).expect("a polynomial"));
                let mut maps = Vec::new();
                let mut end = format!("C^m is asked for up to m = {}", MAP_ORDERS.end());
                for m in MAP_ORDERS {
                    match smooth_map(&rules, m, region, boxes, &AtomicUsize::new(0)) {
                        Ok(map) => maps.push(map),
                        Err(error) => {
                            end = error.to_string();
                            break;
                        }
                    }
                }
                let parameters = [first.clone(), second.clone()];
                let region = region.clone();
                Some(FamilyDrawing::Two { parameters, region, maps, end })
            }
            _ => None,
        }
    }
}

/// Where in a parameter the limits of a mask on Z^d are smooth.
fn lattice_family(scheme: &str, parameter: &str) -> Option<FamilyDrawing> {
    let mask = parse_lattice_in_parameter(scheme, parameter).ok()?;
    let mut ranges = Vec::new();
    let mut end = format!("C^m is asked for up to m = {}", LATTICE_ORDERS.end());
    for m in LATTICE_ORDERS {
        match lattice_range(&mask, m) {
            Ok(LatticeRange { inside, outside, but_finitely_many, .. }) => {
                let m = usize::try_from(m).ok()?;
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
