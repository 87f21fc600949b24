//! Rational numbers with denominators that are powers of two.

use crate::exact::{Enclosure, Integer, Rational};

/// 2^−`bits`.
pub(super) fn power_of_half(bits: u64) -> Rational {
    let bits = u32::try_from(bits).expect("a bound that fits in memory");
    Rational::new(1, Integer::one().shifted_left(bits))
}

/// The enclosure with ends that are multiples of 2^−`places`.
pub(super) fn outward(value: &Enclosure, places: u32) -> Enclosure {
    let unit = Integer::one().shifted_left(places);
    let scale = Rational::from(unit.clone());
    Enclosure::new(
        Rational::new((value.lower() * &scale).floor(), unit.clone()),
        Rational::new((value.upper() * &scale).ceil(), unit),
    )
}
