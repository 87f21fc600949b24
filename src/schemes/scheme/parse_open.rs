//! Reads SCHEME as a mask with parameters left open.

use super::error::SchemeError;
use super::mask::Mask;
use super::parse::Named;
use crate::exact::Polynomial;
use crate::formula::{Parameters, is_identifier};
use std::collections::BTreeMap;

/// The mask that SCHEME names, with one parameter left open. The coefficients are
/// polynomials in this parameter. The values given for other parameters may depend on it.
///
/// # Errors
/// As [`parse_scheme`](super::parse_scheme), and when this is a tensor product, or its mask does not depend on
/// the parameter.
///
/// ```
/// use subcert::scheme::parse_parametric;
///
/// let mask = parse_parametric("four-point", "w")?;
/// assert_eq!(mask.rules().rows()[1][0].to_string(), "-w");
/// assert!(parse_parametric("four-point:w=1/16", "w").is_err());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_parametric(text: &str, parameter: &str) -> Result<Mask<Polynomial>, SchemeError> {
    parse_in_parameters(text, &[parameter])
}

/// The mask that SCHEME names, with some parameters left open, as [`parse_parametric`].
///
/// # Errors
/// As [`parse_parametric`].
///
/// ```
/// use subcert::scheme::parse_in_parameters;
///
/// let mask = parse_in_parameters("four-point:w=u*v", &["u", "v"])?;
/// assert_eq!(mask.rules().rows()[1][0].to_string(), "-u*v");
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_in_parameters(
    text: &str,
    parameters: &[&str],
) -> Result<Mask<Polynomial>, SchemeError> {
    let independent = |parameter: &str, known: Vec<String>| SchemeError::Independent {
        scheme: text.trim().to_owned(),
        parameter: parameter.to_owned(),
        known,
    };
    if let Some(parameter) = parameters.iter().find(|parameter| !is_identifier(parameter)) {
        return Err(independent(parameter, Vec::new()));
    }
    let named = Named::read(text)?;
    let variables = parameters.iter().map(|name| ((*name).to_owned(), Polynomial::variable(name)));
    let variables: BTreeMap<String, Polynomial> = variables.collect();
    let mut instances = named.instances_in(&Parameters(variables.clone()))?;
    let (Some(mut instance), true) = (instances.pop(), instances.is_empty()) else {
        return Err(SchemeError::TensorProduct { scheme: text.trim().to_owned() });
    };
    let definition = named.definition(&instance.name)?;
    for (name, variable) in variables {
        if definition.parameters.contains_key(&name) {
            instance.parameters.entry(name).or_insert(variable);
        }
    }
    let mask = definition.mask(&instance.parameters)?;
    let occurs = |name: &str| mask.rules().rows().iter().flatten().any(|entry| entry.has(name));
    match parameters.iter().find(|name| !occurs(name)) {
        Some(name) => Err(independent(name, definition.parameters.keys().cloned().collect())),
        None => Ok(mask),
    }
}
