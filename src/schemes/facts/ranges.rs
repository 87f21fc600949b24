//! Where in the parameter of a family the limits are C^m.

use crate::bound::polynomial_rules;
use crate::exact::IntervalSet;
use crate::scheme::parse_parametric;
use crate::smoothness::{SmoothRangeError, smooth_range};

/// The levels of contractions that are tried.
const LEVELS: u32 = 2;

/// The most orders m that are asked for.
const MAX_ORDER: usize = 4;

/// Where in a parameter the limits are C^m.
#[derive(Clone, Debug)]
pub struct ParameterFacts {
    /// m.
    pub m: usize,
    /// There all limits are C^m.
    pub inside: IntervalSet,
    /// There not all limits are C^m, but for finitely many values at most where `but_finitely_many`.
    pub outside: IntervalSet,
    /// Whether finitely many values outside may be exceptions.
    pub but_finitely_many: bool,
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
