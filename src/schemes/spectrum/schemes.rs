//! Schemes by name, and the wider rings whose eigenvalues are taken.

use super::error::SpectrumError;
use super::ring_spectrum::Spectrum;
use crate::diagnostic::SourceText;
use crate::exact::{Rational, RealCyclotomic};
use crate::scheme::{LocalRules, Reference, parse_rules_of_valence, read_scheme};
use std::collections::BTreeMap;

/// The rules on two rings around a vertex or face, for the schemes of the catalogue whose ring alone does
/// not determine the surface near the vertex or face: the files of the folder `surroundings`, by the names of the schemes.
const WIDER: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/surroundings.rs"));

/// A ring, and the wider ring of the same scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Surroundings {
    /// The ring that SCHEME names.
    pub ring: LocalRules,
    /// The ring with the next points around it. `None` for the rings of files, for schemes of which no
    /// wider ring is known here, and where it has more than
    /// [`MAX_LOCAL_POINTS`](crate::scheme::MAX_LOCAL_POINTS) points.
    pub wider: Option<LocalRules>,
}

/// The rings of a scheme. A valence is the value of the parameter `N` or `n` of the rules.
///
/// The wider rings are those whose points determine the limit surface on the faces at the vertex or face:
///
/// | scheme | points |
/// |---|---|
/// | Catmull–Clark | 6n + 1 |
/// | Doo–Sabin | 4n |
/// | Loop | 3n + 1 |
/// | √3 | 3n + 1; the two rings next to the vertex |
///
/// # Errors
/// When SCHEME names no ring, or its parameters give none.
///
/// # Panics
/// Never.
///
/// ```
/// use subcert::spectrum::surroundings;
///
/// let found = surroundings("loop", Some(5))?;
/// assert_eq!((found.ring.point_count(), found.wider.unwrap().point_count()), (6, 16));
/// # Ok::<(), subcert::spectrum::SpectrumError>(())
/// ```
pub fn surroundings(scheme: &str, valence: Option<usize>) -> Result<Surroundings, SpectrumError> {
    let ring = parse_rules_of_valence(scheme, valence)?;
    let reference = Reference::parse(scheme).map_err(crate::scheme::SchemeError::from)?;
    let name = reference.names().next().unwrap_or_default();
    let counts = ring.orbits().iter().map(|orbit| orbit.count);
    let order = counts.max().unwrap_or(0);
    let wider = WIDER.iter().find(|(known, _)| *known == name);
    let wider = wider.and_then(|(name, text)| wider_ring(name, text, order));
    Ok(Surroundings { ring, wider })
}

/// The wider ring of this valence, if it is within the cap.
fn wider_ring(name: &str, text: &str, valence: usize) -> Option<LocalRules> {
    let source = SourceText::new(format!("surroundings/{name}.toml"), text);
    let definition = read_scheme(&source).unwrap_or_else(|error| panic!("{error}"));
    let value = RealCyclotomic::from(Rational::from(valence));
    let parameter = definition.parameters.keys().next()?.clone();
    // The only error of these files is that there are too many points.
    definition.ring(&BTreeMap::from([(parameter, value)])).ok()
}

impl Surroundings {
    /// The stencils of the ring, and the eigenvalues of the wider ring, if there is one.
    ///
    /// # Errors
    /// As [`Spectrum::of`].
    ///
    /// # Panics
    /// Never.
    pub fn spectrum(&self) -> Result<Spectrum, SpectrumError> {
        Spectrum::within(&self.ring, self.wider.as_ref())
    }

    /// The same, also where small complex eigenvalues are not computed; see [`Spectrum::known`].
    ///
    /// # Errors
    /// As [`Spectrum::of`].
    ///
    /// # Panics
    /// Never.
    pub fn known_spectrum(&self) -> Result<Spectrum, SpectrumError> {
        Spectrum::known(&self.ring, self.wider.as_ref())
    }
}
