//! Control data that attain a distance on a ring, and whether certificates can express control
//! data.

use crate::exact::Rational;
use crate::finding::{Attained, Control, Place};
use crate::limit::{LocalWitness, is_fraction, natural_shift};
use crate::scheme::{LocalRules, Mask};

/// The control data of a ring, and the point that they leave far from its limit.
pub(crate) fn at_point(ring: &LocalRules, witness: LocalWitness) -> Attained {
    Attained {
        control: points(ring, &witness.ring),
        place: Place::Named(ring.name(witness.point)),
        value: witness.distance,
    }
}

/// Points of a ring with their names.
pub(crate) fn points(ring: &LocalRules, heights: &[i64]) -> Control {
    Control::Points((0..).zip(heights).map(|(a, x)| (ring.name(a), *x)).collect())
}

/// Whether certificates can express what data attain with the points at their natural parameters:
/// the masks map lines to lines, and the place is i/n^m.
pub(crate) fn has_words(masks: &[&Mask], attained: &Attained) -> bool {
    let places = match &attained.place {
        Place::Parameter(t) => std::slice::from_ref(t),
        Place::Parameters(both) => &both[..],
        _ => return masks.iter().all(|mask| natural_shift(mask).keeps_lines),
    };
    let good = |(mask, t): (&&Mask, &Rational)| {
        natural_shift(mask).keeps_lines && is_fraction(t, mask.arity())
    };
    masks.len() == places.len() && masks.iter().zip(places).all(good)
}
