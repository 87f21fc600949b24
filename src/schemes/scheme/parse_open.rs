//! Reads SCHEME as a mask with parameters left open.

use super::error::SchemeError;
use super::lattice::mask::LatticeMask;
use super::local::rules::LocalRules;
use super::mask::Mask;
use super::parse::{Factor, Named};
use crate::exact::{BivariatePolynomial, Polynomial, RationalPolynomial, Scalar};

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

/// The parameters of the mask that SCHEME names to which it gives no value, in the order of their names.
///
/// # Errors
/// As [`parse_parametric`], but for that the mask may depend on none.
///
/// ```
/// use subcert::scheme::open_parameters;
///
/// assert_eq!(open_parameters("six-point")?, ["w"]);
/// assert!(open_parameters("six-point:w=1/256")?.is_empty());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn open_parameters(text: &str) -> Result<Vec<String>, SchemeError> {
    let named = Named::read(text)?;
    let [part] = named.reference.parts() else {
        return Err(SchemeError::TensorProduct { scheme: text.trim().to_owned() });
    };
    let known = named.definition(&part.name)?.parameters.keys();
    Ok(known.filter(|name| !part.parameters.contains_key(*name)).cloned().collect())
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
    let named = named(text, parameters)?;
    let factor = opened(&named, parameters, None)?;
    let mask = factor.mask()?;
    let occurs = |name: &str| mask.rules().rows().iter().flatten().any(|entry| entry.has(name));
    depends(text, &factor, parameters, occurs)?;
    Ok(mask)
}

/// SCHEME, if parameters can have these names.
fn named<'t>(text: &'t str, parameters: &[&str]) -> Result<Named<'t>, SchemeError> {
    match parameters.iter().find(|parameter| !is_identifier(parameter)) {
        Some(parameter) => Err(independent(text, parameter, open_parameters(text)?)),
        None => Named::read(text),
    }
}

/// The factor of SCHEME with these parameters left open: the values of others may depend on them.
fn opened<'n>(
    named: &'n Named<'_>,
    parameters: &[&str],
    valence: Option<usize>,
) -> Result<Factor<'n, Polynomial>, SchemeError> {
    let variables = parameters.iter().map(|name| ((*name).to_owned(), Polynomial::variable(name)));
    let variables: BTreeMap<String, Polynomial> = variables.collect();
    let mut factor = named.factor(&Parameters(variables.clone()), valence)?;
    for (name, variable) in variables {
        if factor.definition.parameters.contains_key(&name) {
            factor.parameters.entry(name).or_insert(variable);
        }
    }
    Ok(factor)
}

/// An error unless each of the parameters occurs.
fn depends(
    text: &str,
    factor: &Factor<'_, Polynomial>,
    parameters: &[&str],
    occurs: impl Fn(&str) -> bool,
) -> Result<(), SchemeError> {
    let known = || factor.definition.parameters.keys().cloned().collect();
    let missing = parameters.iter().find(|name| !occurs(name));
    missing.map_or(Ok(()), |name| Err(independent(text, name, known())))
}

fn independent(text: &str, parameter: &str, known: Vec<String>) -> SchemeError {
    let (scheme, parameter) = (text.trim().to_owned(), parameter.to_owned());
    SchemeError::Independent { scheme, parameter, known }
}

/// The mask on Z^d that SCHEME names, with one parameter left open. The coefficients are polynomials in this parameter.
///
/// # Errors
/// When SCHEME names none, its coefficients are no polynomials in the parameter, or they do not depend on it.
///
/// ```
/// use subcert::scheme::parse_lattice_in_parameter;
///
/// let mask = parse_lattice_in_parameter("1+(1/2-w)*(x+1/x)+w*(y+1/y):dilation=[[1,1],[1,-1]]", "w")?;
/// assert_eq!(mask.coefficients()[&[0, 1, 0]].degree(), Some(1));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_lattice_in_parameter(
    text: &str,
    parameter: &str,
) -> Result<LatticeMask<RationalPolynomial>, SchemeError> {
    in_parameters(text, &[parameter], |c| c.in_variable(parameter))
}

/// The same with two parameters left open.
///
/// # Errors
/// As of [`parse_lattice_in_parameter`].
///
/// ```
/// use subcert::scheme::parse_lattice_in_parameters;
///
/// let mask = parse_lattice_in_parameters("1+v*(x+1/x)+w*(y+1/y):dilation=[[1,1],[1,-1]]", ["v", "w"]);
/// assert!(mask.is_err(), "the rules do not sum to 1");
/// let mask = parse_lattice_in_parameters("1+(1/2-v*w)*(x+1/x)+v*w*(y+1/y):dilation=[[1,1],[1,-1]]", ["v", "w"])?;
/// assert_eq!(mask.coefficients()[&[0, 1, 0]].degrees(), [1, 1]);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_lattice_in_parameters(
    text: &str,
    parameters: [&str; 2],
) -> Result<LatticeMask<BivariatePolynomial>, SchemeError> {
    in_parameters(text, &parameters, |c| c.in_variables(parameters))
}

/// The mask on Z^d that SCHEME names, with polynomials of another kind as coefficients.
fn in_parameters<P: Scalar + PartialEq>(
    text: &str,
    parameters: &[&str],
    polynomial: impl Fn(&Polynomial) -> Option<P>,
) -> Result<LatticeMask<P>, SchemeError> {
    let named = named(text, parameters)?;
    let factor = opened(&named, parameters, None)?;
    let mask = factor.lattice()?;
    depends(text, &factor, parameters, |name| mask.coefficients().values().any(|c| c.has(name)))?;
    if let Some(c) = mask.coefficients().values().find(|c| polynomial(c).is_none()) {
        let (coefficient, parameter) = (c.to_string(), parameters.join("`, `"));
        return Err(SchemeError::NotPolynomial { coefficient, parameter });
    }
    Ok(mask.map(|c| polynomial(c).unwrap_or_else(P::zero)))
}

/// The ring that SCHEME names, with one parameter left open. The weights are polynomials in this parameter. A valence is the
/// value of the parameter `N` or `n`.
///
/// # Errors
/// When SCHEME names no ring, its weights are no polynomials in the parameter, or they do not depend on it.
///
/// ```
/// use subcert::scheme::parse_rules_in_parameter;
///
/// let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/loop-beta.toml");
/// let ring = parse_rules_in_parameter(file, "beta", Some(6))?;
/// assert_eq!(ring.weights().entry(0, 1).to_string(), "beta");
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_rules_in_parameter(
    text: &str,
    parameter: &str,
    valence: Option<usize>,
) -> Result<LocalRules<Polynomial>, SchemeError> {
    let named = named(text, &[parameter])?;
    let factor = opened(&named, &[parameter], valence)?;
    let ring = factor.ring()?;
    let occurs = |name: &str| ring.weights().values().iter().any(|weight| weight.has(name));
    depends(text, &factor, &[parameter], occurs)?;
    Ok(ring)
}
