//! Reads SCHEME as a scheme or a ring, whichever it is, and masks with irrational coefficients.

use super::Scheme;
use super::error::SchemeError;
use super::lattice::mask::LatticeMask;
use super::local::rules::LocalRules;
use super::mask::Mask;
use super::parse::Named;
use crate::exact::{AlgebraicNumber, FieldElement, Rational, RealCyclotomic};
use crate::formula::Parameters;

/// The kinds of schemes that SCHEME can name.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyScheme {
    /// A scheme with the same rules everywhere: one mask, or two for a tensor product.
    Uniform(Scheme<Rational>),
    /// A mask on Z^d, or a tensor product of three.
    Lattice(LatticeMask),
    /// Rules around one extraordinary vertex or face.
    LocalRules(LocalRules<RealCyclotomic>),
}

impl From<Scheme> for AnyScheme {
    fn from(scheme: Scheme) -> AnyScheme {
        AnyScheme::Uniform(scheme)
    }
}

impl From<LocalRules> for AnyScheme {
    fn from(rules: LocalRules) -> AnyScheme {
        AnyScheme::LocalRules(rules)
    }
}

/// The scheme or the ring that SCHEME names.
///
/// # Errors
/// As [`parse_scheme`](crate::scheme::parse_scheme) and [`parse_local_rules`](crate::scheme::parse_local_rules).
///
/// ```
/// use subcert::scheme::{AnyScheme, parse_any_scheme};
///
/// assert!(matches!(parse_any_scheme("chaikin")?, AnyScheme::Uniform(_)));
/// assert!(matches!(parse_any_scheme("doo-sabin:n=5")?, AnyScheme::LocalRules(_)));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_any_scheme(text: &str) -> Result<AnyScheme, SchemeError> {
    let named = Named::read(text)?;
    let names: Vec<&str> = named.reference.names().collect();
    match names[..] {
        [name] if named.definition(name)?.is_ring() => named.ring(None).map(AnyScheme::LocalRules),
        [name] if named.definition(name)?.is_lattice() => named.lattice().map(AnyScheme::Lattice),
        [_, _, _] => named.lattice().map(AnyScheme::Lattice),
        _ => named.scheme().map(AnyScheme::Uniform),
    }
}

/// The mask on Z^d that SCHEME names, or that of the tensor product of two or three masks of curves.
///
/// # Errors
/// When there is no such scheme, or it is a mask of curves or a ring.
///
/// ```
/// use subcert::scheme::parse_lattice;
///
/// let courant = parse_lattice("(1+x)*(1+y)*(1+x*y)/2")?;
/// assert_eq!((courant.dimension(), courant.coefficients().len()), (2, 7));
/// let quincunx = parse_lattice("(1+x)*(1+y)/2:dilation=[[1,1],[1,-1]]")?;
/// assert_eq!(quincunx.dilation().class_count(), 2);
/// assert_eq!(parse_lattice("box[[1,0],[0,1],[1,1]]")?, courant);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_lattice(text: &str) -> Result<LatticeMask, SchemeError> {
    Named::read(text)?.lattice()
}

/// The mask that SCHEME names, with coefficients of one real field Q(α): in its formulas and in the values of its
/// parameters, `sqrt` and `root` are numbers.
///
/// # Errors
/// As [`parse_scheme`](crate::scheme::parse_scheme), when this is a tensor product, and when the coefficients are in no field within the caps.
///
/// ```
/// use subcert::exact::format::fixed;
/// use subcert::scheme::parse_algebraic;
///
/// let mask = parse_algebraic("four-point:w=sqrt(2)/32")?;
/// assert_eq!(fixed(&mask.rules().rows()[1][0], 8), "-0.04419417");
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_algebraic(text: &str) -> Result<Mask<FieldElement>, SchemeError> {
    let named = Named::read(text)?;
    let factor = named.factor(&Parameters::<AlgebraicNumber>::default(), None)?;
    // The coefficients of a mask are in one field.
    let mask = factor.mask()?;
    Ok(mask.map(|c| c.element().clone()))
}
