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
    /// The rules next to the vertex are not those of the regular part, and the points around them are not declared.
    InnerRules,
    /// The rules of the declared points around those next to the vertex are not those of the regular part.
    OuterRules,
    /// The rules differ from their mirror image.
    Mirror,
    /// The eigenvector of the points next to the vertex is not decided by enclosures.
    Eigenvector,
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
    /// Whether the points next to the vertex have rules of their own, as the vertex has.
    pub(super) own: bool,
    /// Whether the rules are those of the regular part at its regular valence, and its surfaces are C².
    pub(super) regular: bool,
    pub(super) ring: LocalRules,
    pub(super) wider: Option<LocalRules>,
}

/// The orbits that declare a regular part with the points around those next to the vertex: in sector i, of triangles, `corner` (1, 1)
/// and `outer` (2, 0); of quadrilaterals `outer` (2, 0), `left` (2, 1), `right` (1, 2) and `corner` (2, 2).
const DECLARED: [(Family, &[&str]); 2] = [
    (Family::Bicubic, &["vertex", "edge", "face", "outer", "left", "right", "corner"]),
    (Family::BoxSpline, &["vertex", "edge", "corner", "outer"]),
];

/// The rules of a ring. The names of the orbits declare the regular part: vertex, edge and face, vertex and
/// edge, or face. Only the weights of the vertex, or of the face, may differ from those of the scheme of the
/// catalogue with this part. With the orbits of [`DECLARED`] all points next to the vertex may have rules of their own that
/// are their own mirror image.
pub(super) fn rules(ring: LocalRules) -> Result<Rules, SpectrumError> {
    let names: Vec<&str> = ring.orbits().iter().map(|orbit| orbit.name.as_str()).collect();
    let counts: Vec<usize> = ring.orbits().iter().map(|orbit| orbit.count).collect();
    let n = counts.last().copied().unwrap_or(0);
    let expected: Vec<usize> =
        names.iter().map(|name| if *name == "vertex" { 1 } else { n }).collect();
    let fits = counts == expected && n >= 3;
    let declared = DECLARED.iter().find(|(_, orbits)| fits && *orbits == names.as_slice());
    if let Some((family, _)) = declared {
        return with_surroundings(*family, ring, n);
    }
    let Some(family) = Family::of_orbits(&names).filter(|_| fits) else {
        let reason = Some(Reason::RegularPart);
        return Ok(Rules { family: None, reason, own: false, regular: false, ring, wider: None });
    };
    let model = surroundings(family.scheme(), Some(n))?;
    let reason = difference(&ring, &model.ring);
    let regular = is_regular(family, &ring, &model.ring);
    let wider = match reason {
        None => model.wider.and_then(|wider| replaced(&ring, &wider)),
        Some(_) => None,
    };
    let reason = reason.or(wider.is_none().then_some(Reason::RegularPart));
    Ok(Rules { family: Some(family), reason, own: false, regular, ring, wider })
}

/// Whether the rules are those of the regular part: at its regular valence the model of the catalogue has these.
fn is_regular(family: Family, own: &LocalRules, model: &LocalRules) -> bool {
    let n = own.orbits().last().map_or(0, |orbit| orbit.count);
    family.smooth_valence() == Some(n) && own.weights() == model.weights()
}

/// Rules with those of the points around: these have to be those of the regular part.
fn with_surroundings(family: Family, wider: LocalRules, n: usize) -> Result<Rules, SpectrumError> {
    let model = surroundings(family.scheme(), Some(n))?;
    let count = model.ring.point_count();
    let all = 0..wider.point_count();
    let own = |a: usize| wider.weights().row(a).take(count).cloned().collect();
    let edges = wider.edges().iter().copied().filter(|(a, b)| *a < count && *b < count);
    let orbits = model.ring.orbits().to_vec();
    let inner = LocalRules::new(orbits, (0..count).map(own).collect(), edges.collect()).ok();
    let regular = model.wider.is_some_and(|model| {
        all.clone().skip(count).all(|a| wider.weights().row(a).eq(model.weights().row(a)))
    });
    let closed = (0..count)
        .all(|a| all.clone().skip(count).all(|b| wider.weights().entry(a, b).sign() == 0));
    let Some(inner) = inner.filter(|_| regular && closed) else {
        let reason = Some(Reason::OuterRules);
        return Ok(Rules {
            family: None,
            reason,
            own: false,
            regular: false,
            ring: wider,
            wider: None,
        });
    };
    let reason = (!is_mirrored(&inner, family)).then_some(Reason::Mirror);
    let own = difference(&inner, &model.ring) == Some(Reason::InnerRules);
    let regular = is_regular(family, &inner, &model.ring);
    Ok(Rules { family: Some(family), reason, own, regular, ring: inner, wider: Some(wider) })
}

/// Whether rules are their own mirror image: edge points i go to −i, and face points at a vertex to −1 − i, on a face to −i.
fn is_mirrored(ring: &LocalRules, family: Family) -> bool {
    let mut image = Vec::with_capacity(ring.point_count());
    for orbit in ring.orbits() {
        let (first, n) = (image.len(), orbit.count);
        let shift = if family == Family::Bicubic && orbit.name == "face" { n - 1 } else { n };
        image.extend((0..n).map(|i| first + (shift + n - i) % n));
    }
    let weights = ring.weights();
    let same = |a: usize, b: usize| weights.entry(a, b) == weights.entry(image[a], image[b]);
    (0..image.len()).all(|a| (0..image.len()).all(|b| same(a, b)))
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
