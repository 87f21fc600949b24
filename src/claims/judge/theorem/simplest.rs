//! Numbers of small denominators near other numbers.

use crate::exact::{Enclosed, Integer, Rational, RealCyclotomic};

/// The simplest rational number from 255/256 of a positive number to below the number.
pub(crate) fn slightly_less(value: &RealCyclotomic) -> Option<Rational> {
    let upper = value.enclosure(0).lower().clone();
    if upper.sign() <= 0 {
        return None;
    }
    let lower = &upper * &Rational::new(255, 256);
    Some(simplest(&lower, &upper))
}

/// The rational number of least denominator from `low` to below `high`, 0 < low < high.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    let whole = Rational::from(low.ceil());
    if whole < *high {
        return whole;
    }
    let floor = Rational::from(low.floor());
    let (low, high) = (low - &floor, high - &floor);
    // Here 0 < low < high ≤ 1.
    let inverse = simplest_above(&high.recip(), &low.recip());
    floor + inverse.recip()
}

/// The rational number of least denominator above `low` and up to `high`, 0 ≤ low < high.
fn simplest_above(low: &Rational, high: &Rational) -> Rational {
    let whole = Rational::from(low.floor() + Integer::one());
    if whole <= *high {
        return whole;
    }
    let floor = Rational::from(low.floor());
    let (low, high) = (low - &floor, high - &floor);
    if low.is_zero() {
        // No whole number is above a whole `low` and at most `high` < low + 1.
        let inverse = Rational::from(high.recip().ceil());
        return floor + inverse.recip();
    }
    let inverse = simplest(&high.recip(), &low.recip());
    floor + inverse.recip()
}
