//! All valences at once.

use super::family::Family;
use super::laurent::Laurent;
use super::net::ratio;
use super::ring::{Ring, examined, in_half_plane, ring_pieces};
use crate::exact::{Rational, Scalar as _};
use crate::scheme::{Entry, catalogue};

/// Whether the characteristic maps of a scheme are regular and injective for all valences n ≥ 3: the
/// Bernstein coefficients of J and of the half-plane are polynomials in one variable t that Sturm's theorem
/// shows to be positive on an interval with all values of t.
///
/// | scheme | t | interval | |
/// |---|---|---|---|
/// | Catmull–Clark | λ | 41/100 to 6546/10000 | c = (16λ² − 10λ + 1)/(2λ), −1/2 ≤ c < 1 |
/// | Loop, both weights | c | −1/2 to 1 | λ = 3/8 + c/4 |
/// | Doo–Sabin | c | −1/2 to 1 | λ = 1/2 |
///
/// ```
/// use subcert::characteristic::{Family, regular_for_all_valences};
///
/// assert!(regular_for_all_valences(Family::Biquadratic));
/// ```
#[must_use]
pub fn regular_for_all_valences(family: Family) -> bool {
    let numbers = |all: [i64; 3]| all.map(Rational::from);
    let t = Laurent::variable;
    let (cosine, value) = match family {
        Family::Bicubic => (Laurent::new(&numbers([1, -10, 16]), 1).times(&ratio(1, 2)), t()),
        Family::BoxSpline => {
            (t(), ratio::<Laurent>(3, 8).plus(&ratio::<Laurent>(1, 4).times(&t())))
        }
        Family::Biquadratic => (t(), ratio(1, 2)),
    };
    let (low, high) = match family {
        Family::Bicubic => (Rational::new(41, 100), Rational::new(6546, 10000)),
        _ => (Rational::new(-1, 2), Rational::one()),
    };
    let sign = |x: &Laurent| x.sign_on(&low, &high);
    let net = family.eigenvector(&cosine, &value);
    let pieces = ring_pieces(&net, &value);
    matches!(examined(&pieces, &sign), Ring::OneSign { sign: 1, .. })
        && in_half_plane(&net, &pieces, &sign)
}

/// The schemes of the catalogue whose eigenvalues are in order at all valences (`proofs/THEOREMS.md`, 135).
pub fn ordered() -> impl Iterator<Item = (&'static str, Family)> {
    let regular = |one: &'static Entry| Family::named(one.facts.ordered.as_deref()?);
    catalogue().iter().filter_map(move |one| Some((&*one.name, regular(one)?)))
}

/// The regular part of a scheme of the catalogue that is proved C¹ at all valences n ≥ 3 at once; `None` of others.
///
/// ```
/// use subcert::characteristic::{Family, smooth_for_all_valences};
///
/// assert_eq!(smooth_for_all_valences("loop"), Some(Family::BoxSpline));
/// assert_eq!(smooth_for_all_valences("sqrt3"), None);
/// ```
#[must_use]
pub fn smooth_for_all_valences(scheme: &str) -> Option<Family> {
    let (_, family) = ordered().find(|(name, _)| *name == scheme)?;
    regular_for_all_valences(family).then_some(family)
}
