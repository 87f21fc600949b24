//! The facts of whatever SCHEME names.

use super::curve::CurveFacts;
use crate::characteristic::Vertex;
use crate::exact::FieldElement;
use crate::scheme::{
    AnyScheme, Mask, SchemeDefinition, SchemeError, catalogue, parse_algebraic, parse_any_scheme,
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
    /// Rules around a vertex or on a face.
    Surface(Vec<ValenceFacts>),
}

impl SchemeFacts {
    /// The facts of a scheme of the catalogue, a file, or a mask. Rules around a vertex or on a face are looked at for
    /// the valence that SCHEME states, or for all of [`VALENCES`].
    ///
    /// # Errors
    /// When there is no such scheme, or it is a tensor product: its facts are those of its factors.
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
                Err(_) => Err(SchemeError::TensorProduct { scheme: scheme.trim().to_owned() }),
            },
            Ok(AnyScheme::LocalRules(ring)) => {
                let valence = ring.orbits().iter().map(|orbit| orbit.count).max().unwrap_or(0);
                Ok(SchemeFacts::Surface(vec![(valence, Vertex::of(scheme, None))]))
            }
            Err(error) => {
                if parse_rules_of_valence(scheme, Some(*VALENCES.start())).is_ok() {
                    let facts = VALENCES.map(|n| (n, Vertex::of(scheme, Some(n))));
                    return Ok(SchemeFacts::Surface(facts.collect()));
                }
                // What is wrong with the scheme is wrong in any field, but for roots.
                let mask = parse_algebraic(scheme).map_err(|_| error)?;
                Ok(SchemeFacts::Algebraic(Box::new(CurveFacts::of_algebraic(&mask))))
            }
        }
    }
}

/// All schemes of the catalogue, each with the references that stand for it: families at their samples, rules around a
/// vertex or on a face without a valence.
#[must_use]
pub fn atlas_references() -> Vec<(&'static SchemeDefinition, Vec<String>)> {
    let of = |entry: &'static SchemeDefinition| {
        let mut references = entry.references();
        if references.is_empty() {
            references.push(entry.name.clone());
        }
        (entry, references)
    };
    catalogue().iter().map(of).collect()
}
