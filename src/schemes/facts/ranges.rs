//! Where in the parameter of a family the limits are C^m.

use super::scheme::VALENCES;
use crate::bound::polynomial_rules;
use crate::characteristic::{VertexRange, vertex_range};
use crate::exact::IntervalSet;
use crate::scheme::{
    find_definition, parse_local_rules, parse_parametric, parse_rules_in_parameter,
};
use crate::smoothness::{SmoothRangeError, SpecialValues, smooth_range};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// The levels of contractions that are tried.
const LEVELS: u32 = 2;

/// The most orders m that are asked for.
const MAX_ORDER: usize = 4;

/// Where in a parameter the limits are C^m.
#[derive(Clone, Debug)]
pub struct ParameterFacts {
    /// m.
    pub m: usize,
    /// Of rules around a vertex or on a face: the valence.
    pub valence: Option<usize>,
    /// There all limits are C^m.
    pub inside: IntervalSet,
    /// There not all limits are C^m, but for finitely many values at most where `but_finitely_many`.
    pub outside: IntervalSet,
    /// Whether finitely many values outside may be exceptions.
    pub but_finitely_many: bool,
}

/// The family of a scheme: where in its only parameter the limits are C^m.
#[derive(Clone, Debug)]
pub struct FamilyFacts {
    /// The parameter.
    pub parameter: String,
    /// The sets for m = 0, 1, …; of rules around a vertex or on a face, those of C^1 at each valence.
    pub ranges: Vec<ParameterFacts>,
    /// Why there are no more.
    pub end: String,
    /// The special values of the parameter of a mask.
    pub special: Option<SpecialValues>,
}

impl FamilyFacts {
    /// The family of SCHEME; `None` where it has not one parameter, or its mask is not polynomial in it, as in a degree. Rules around a vertex or on a face have one weight beside the valence.
    ///
    /// ```
    /// use subcert::facts::FamilyFacts;
    ///
    /// let family = FamilyFacts::of("four-point:w=1/16").expect("a family");
    /// assert_eq!((&family.parameter[..], family.ranges.len()), ("w", 2));
    /// assert!(FamilyFacts::of("b-spline:degree=3").is_none());
    /// ```
    #[must_use]
    pub fn of(scheme: &str) -> Option<FamilyFacts> {
        let entry = find_definition(scheme).ok()?;
        let valence = entry
            .is_ring()
            .then(|| entry.valence_name(&BTreeMap::<String, usize>::new()))
            .flatten();
        let free = |name: &&String| valence.is_none_or(|valence| valence != name.as_str());
        let mut parameters = entry.parameters.keys().filter(free);
        let (Some(parameter), None) = (parameters.next(), parameters.next()) else { return None };
        let (ranges, end) = if valence.is_some() {
            let valences = match parse_local_rules(scheme) {
                Ok(ring) => {
                    let valence = ring.orbits().last()?.count;
                    valence..=valence
                }
                Err(_) => VALENCES,
            };
            weight_facts(&entry.name, parameter, valences)?
        } else {
            parameter_facts(&entry.name, parameter).ok()?
        };
        let special = parse_parametric(&entry.name, parameter).ok();
        let special = special.and_then(|mask| polynomial_rules(mask.rules(), parameter).ok());
        let special = special.as_ref().map(SpecialValues::of);
        Some(FamilyFacts { parameter: parameter.clone(), ranges, end, special })
    }
}

/// Where in a weight surfaces are C^1 at these valences, as far as it is decided.
fn weight_facts(
    scheme: &str,
    weight: &str,
    valences: RangeInclusive<usize>,
) -> Option<(Vec<ParameterFacts>, String)> {
    let at = |valence: usize| {
        let ring = parse_rules_in_parameter(scheme, weight, Some(valence)).ok()?;
        let VertexRange { inside, outside, .. } = vertex_range(&ring, weight).ok()?;
        let valence = Some(valence);
        Some(ParameterFacts { m: 1, valence, inside, outside, but_finitely_many: false })
    };
    let found: Vec<ParameterFacts> = valences.filter_map(at).collect();
    (!found.is_empty())
        .then(|| (found, "C^1 is asked for, at the vertex or on the face".to_owned()))
}

/// The ranges for m = 0, 1, …, up to the order that the sum rules allow for all values of the parameter; with the reason
/// why they end.
///
/// # Errors
/// When the mask is not polynomial in the parameter, or the parameter is not known.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::facts::parameter_facts;
///
/// let (ranges, _) = parameter_facts("four-point", "w")?;
/// assert!(ranges[1].inside.contains(&Rational::new(1, 8)));
/// assert!(ranges[1].outside.contains(&Rational::new(1, 4)));
/// # Ok::<(), String>(())
/// ```
pub fn parameter_facts(
    scheme: &str,
    parameter: &str,
) -> Result<(Vec<ParameterFacts>, String), String> {
    let mask = parse_parametric(scheme, parameter).map_err(|error| error.to_string())?;
    let rules = polynomial_rules(mask.rules(), parameter).map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    for m in 0..=MAX_ORDER {
        match smooth_range(&rules, m, LEVELS) {
            Ok(range) => found.push(ParameterFacts {
                m,
                valence: None,
                inside: range.inside,
                outside: range.outside,
                but_finitely_many: range.but_finitely_many,
            }),
            Err(error @ SmoothRangeError::SumRules { .. }) => {
                return Ok((found, error.to_string()));
            }
            Err(error) => return Ok((found, format!("C^{m}: {error}"))),
        }
    }
    Ok((found, format!("C^m is asked for up to m = {MAX_ORDER}")))
}
