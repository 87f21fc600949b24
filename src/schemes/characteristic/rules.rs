//! Which regular part the rules of a ring have, and their wider ring.

use super::family::Family;
use crate::exact::RealCyclotomic;
use crate::scheme::LocalRules;
use crate::spectrum::{SpectrumError, surroundings};

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
    /// The outer curve of a sector is not shown to be in a half-plane, and its winding number is not found.
    HalfPlane,
}

/// Rules with their regular part.
pub(super) struct Rules {
    pub(super) family: Option<Family>,
    /// Why the regular part does not serve.
    pub(super) reason: Option<Reason>,
    pub(super) ring: LocalRules,
    pub(super) wider: Option<LocalRules>,
}

/// The rules of a ring. The names of the orbits declare the regular part: vertex, edge and face, vertex and
/// edge, or face. Only the weights of the vertex, or of the face, may differ from those of the scheme of the
/// catalogue with this part.
pub(super) fn rules(ring: LocalRules) -> Result<Rules, SpectrumError> {
    let names: Vec<&str> = ring.orbits().iter().map(|orbit| orbit.name.as_str()).collect();
    let counts: Vec<usize> = ring.orbits().iter().map(|orbit| orbit.count).collect();
    let n = counts.last().copied().unwrap_or(0);
    let expected: Vec<usize> =
        names.iter().map(|name| if *name == "vertex" { 1 } else { n }).collect();
    let family = Family::of_orbits(&names).filter(|_| counts == expected && n >= 3);
    let Some(family) = family else {
        return Ok(Rules { family: None, reason: Some(Reason::RegularPart), ring, wider: None });
    };
    let model = surroundings(family.scheme(), Some(n))?;
    let reason = difference(&ring, &model.ring);
    let wider = match reason {
        None => model.wider.and_then(|wider| replaced(&ring, &wider)),
        Some(_) => None,
    };
    let reason = reason.or(wider.is_none().then_some(Reason::RegularPart));
    Ok(Rules { family: Some(family), reason, ring, wider })
}

/// What keeps rules from being judged by the regular part of others.
pub(super) fn difference<S: PartialEq>(
    own: &LocalRules<S>,
    model: &LocalRules<S>,
) -> Option<Reason> {
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
