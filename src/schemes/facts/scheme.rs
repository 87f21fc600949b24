//! The facts of whatever SCHEME names.

use super::curve::CurveFacts;
use super::lattice::LatticeFacts;
use crate::characteristic::Vertex;
use crate::exact::FieldElement;
use crate::scheme::{
    AnyScheme, LatticeMask, Mask, Reference, SchemeDefinition, SchemeError, catalogue,
    find_definition, names_ring, parse_algebraic, parse_any_scheme, parse_lattice,
    parse_rules_of_valence,
};
use crate::spectrum::SpectrumError;

/// The valences of which rules around a vertex or on a face are looked at, where SCHEME states none.
pub const VALENCES: std::ops::RangeInclusive<usize> = 3..=12;

/// What is known at one valence, or why it is open.
pub type ValenceFacts = (usize, Result<Vertex, SpectrumError>);

/// The facts of a scheme.
#[derive(Clone, Debug)]
pub enum SchemeFacts {
    /// A mask with rational coefficients.
    Rational(Box<CurveFacts>),
    /// A mask with irrational coefficients.
    Algebraic(Box<CurveFacts<FieldElement>>),
    /// A mask on Z^d, or a tensor product.
    Lattice(Box<LatticeFacts>),
    /// Rules around a vertex or on a face.
    Surface(Vec<ValenceFacts>),
}

impl SchemeFacts {
    /// The facts of a scheme of the catalogue, a file, or a mask. Rules around a vertex or on a face are looked at for
    /// the valence that SCHEME states, or for all of [`VALENCES`].
    ///
    /// # Errors
    /// When there is no such scheme.
    ///
    /// ```
    /// use subcert::facts::SchemeFacts;
    ///
    /// assert!(matches!(SchemeFacts::of("daubechies-4")?, SchemeFacts::Algebraic(_)));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    pub fn of(scheme: &str) -> Result<SchemeFacts, SchemeError> {
        match parse_any_scheme(scheme) {
            Ok(AnyScheme::Uniform(found)) => match Mask::try_from(found) {
                Ok(mask) => Ok(SchemeFacts::Rational(Box::new(CurveFacts::of_rational(&mask)))),
                Err(_) => Ok(lattice(&parse_lattice(scheme)?)),
            },
            Ok(AnyScheme::Lattice(mask)) => Ok(lattice(&mask)),
            Ok(AnyScheme::LocalRules(ring)) => {
                let valence = ring.orbits().iter().map(|orbit| orbit.count).max().unwrap_or(0);
                Ok(SchemeFacts::Surface(vec![(valence, Vertex::of(scheme, None))]))
            }
            Err(error) => {
                if names_ring(scheme)? {
                    let valences = valences(scheme, error)?.into_iter();
                    let facts = valences.map(|n| (n, Vertex::of(scheme, Some(n))));
                    return Ok(SchemeFacts::Surface(facts.collect()));
                }
                // What is wrong with the scheme is wrong in any field, but for roots.
                let mask = parse_algebraic(scheme).map_err(|_| error)?;
                Ok(SchemeFacts::Algebraic(Box::new(CurveFacts::of_algebraic(&mask))))
            }
        }
    }
}

fn lattice(mask: &LatticeMask) -> SchemeFacts {
    SchemeFacts::Lattice(Box::new(LatticeFacts::of(mask)))
}

/// Those of [`VALENCES`] that are not below the least one of rules without a valence; the error of SCHEME, or a better one, where there are
/// rules at none.
pub(super) fn valences(scheme: &str, error: SchemeError) -> Result<Vec<usize>, SchemeError> {
    let (mut found, mut any, mut better) = (Vec::new(), false, error);
    for n in VALENCES {
        match parse_rules_of_valence(scheme, Some(n)) {
            Ok(_) => any = true,
            Err(SchemeError::NoValence { .. }) => continue,
            Err(error @ SchemeError::TooSmall { .. }) => {
                better = error;
                continue;
            }
            Err(error) => better = error,
        }
        found.push(n);
    }
    if any { Ok(found) } else { Err(better) }
}

/// A definition with the schemes that stand for it.
pub type AtlasEntry = (SchemeDefinition, Vec<String>);

/// All schemes of the catalogue, each with the references that stand for it: families at their samples, rules around a
/// vertex or on a face without a valence.
#[must_use]
pub fn atlas_references() -> Vec<AtlasEntry> {
    catalogue().iter().map(|entry| standing_for(entry.clone(), &entry.name)).collect()
}

/// The same of the definition that SCHEME names, which may be one's own. Where SCHEME gives values to parameters, it stands for itself.
///
/// # Errors
/// When there is no such scheme, or it is a tensor product.
///
/// ```
/// use subcert::facts::atlas_entry;
///
/// assert_eq!(atlas_entry("four-point:w=1/8")?.1, ["four-point:w=1/8"]);
/// assert_eq!(atlas_entry("b-spline")?.1.len(), 6);
/// assert_eq!(atlas_entry("[1, 3, 3, 1]/4")?.1, ["[1, 3, 3, 1]/4"]);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn atlas_entry(scheme: &str) -> Result<AtlasEntry, SchemeError> {
    let definition = find_definition(scheme)?;
    if Reference::parse(scheme)?.formulas().next().is_some() {
        return Ok((definition, vec![scheme.trim().to_owned()]));
    }
    Ok(standing_for(definition, scheme.trim()))
}

fn standing_for(definition: SchemeDefinition, scheme: &str) -> AtlasEntry {
    let mut references = definition.references();
    if references.is_empty() {
        references.push(scheme.to_owned());
    }
    (definition, references)
}
