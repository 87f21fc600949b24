//! Which regular part the rules of a scheme have, and their wider ring.

use super::family::Family;
use crate::exact::RealCyclotomic;
use crate::scheme::{LocalRules, Reference};
use crate::spectrum::{SpectrumError, Surroundings, surroundings};

/// Why nothing is decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The orbits declare no regular part that is known here.
    RegularPart,
    /// The rules next to the vertex are not those of the regular part.
    InnerRules,
    /// The rules differ from their mirror image.
    Mirror,
    /// The sign of J is not decided within the cap.
    Sign,
    /// The outer curve of a sector is not shown to be in a half-plane.
    HalfPlane,
}

/// Rules with their regular part.
pub(super) struct Rules {
    pub(super) family: Option<Family>,
    /// Why the regular part does not serve.
    pub(super) reason: Option<Reason>,
    pub(super) rings: Surroundings,
}

/// The rules of a scheme. The names of the orbits declare the regular part: vertex, edge and face, vertex and
/// edge, or face. Only the weights of the vertex, or of the face, may differ from those of the scheme of the
/// catalogue with this part.
pub(super) fn rules(scheme: &str, valence: Option<usize>) -> Result<Rules, SpectrumError> {
    let mut rings = surroundings(scheme, valence)?;
    let reference = Reference::parse(scheme).map_err(crate::scheme::SchemeError::from)?;
    let known = ["catmull-clark", "loop", "loop-warren", "doo-sabin"];
    let catalogued = reference.names().next().is_some_and(|name| known.contains(&name));
    let orbits = rings.ring.orbits();
    let names: Vec<&str> = orbits.iter().map(|orbit| orbit.name.as_str()).collect();
    let counts: Vec<usize> = orbits.iter().map(|orbit| orbit.count).collect();
    let n = counts.last().copied().unwrap_or(0);
    let expected: Vec<usize> =
        names.iter().map(|name| if *name == "vertex" { 1 } else { n }).collect();
    let family = Family::of_orbits(&names).filter(|_| counts == expected);
    let Some(family) = family else {
        return Ok(Rules { family: None, reason: Some(Reason::RegularPart), rings });
    };
    if catalogued {
        let reason = rings.wider.is_none().then_some(Reason::RegularPart);
        return Ok(Rules { family: Some(family), reason, rings });
    }
    let model = surroundings(family.scheme(), Some(n))?;
    let reason = difference(&rings.ring, &model.ring);
    rings.wider = model.wider.and_then(|wider| replaced(&rings.ring, &wider));
    let reason = reason.or(rings.wider.is_none().then_some(Reason::RegularPart));
    Ok(Rules { family: Some(family), reason, rings })
}

/// What keeps rules from being judged by the regular part of others.
fn difference(own: &LocalRules, model: &LocalRules) -> Option<Reason> {
    let n = own.point_count();
    if own.orbits().len() > 1 {
        // All but the vertex.
        let same = |a: usize| own.weights().row(a).eq(model.weights().row(a));
        return (!(1..n).all(same)).then_some(Reason::InnerRules);
    }
    let mirrored = |d: usize| own.weights().entry(0, d) == own.weights().entry(0, (n - d) % n);
    (!(0..n).all(mirrored)).then_some(Reason::Mirror)
}

/// The wider ring with other rules in its inner part.
fn replaced(own: &LocalRules, wider: &LocalRules) -> Option<LocalRules> {
    let (inner, all) = (own.point_count(), wider.point_count());
    let row = |a: usize| -> Vec<RealCyclotomic> {
        let zeros = || vec![RealCyclotomic::from(0); all - inner];
        if a < inner {
            own.weights().row(a).cloned().chain(zeros()).collect()
        } else {
            wider.weights().row(a).cloned().collect()
        }
    };
    let rows = (0..all).map(row).collect();
    LocalRules::new(wider.orbits().to_vec(), rows, wider.edges().to_vec()).ok()
}
