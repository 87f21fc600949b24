//! Enclosures of numbers of fields Q(2cos(2π/n)).

#![warn(clippy::arithmetic_side_effects)]

use super::interval::Interval;
use crate::numbers::{Meter, Number, field};
use crate::text::Stop;

impl Interval {
    /// An enclosure of a number with about so many binary digits.
    pub fn of(number: &Number, bits: u64) -> Result<Interval, Stop> {
        if let Some(value) = number.rational() {
            return Interval::point(value);
        }
        let (n, coordinates) = number.coordinates();
        // Terms may cancel as far as they are long.
        let places = bits.saturating_add(number.bits());
        let low = field(n).enclose(places);
        let exponent = i64::try_from(places).unwrap_or(i64::MAX).saturating_neg();
        let x = Interval::new(low.clone(), low + 1_u8, exponent, places)?;
        coordinates.into_iter().rev().try_fold(Interval::from(0), |sum, c| {
            sum.times(&x, places)?.plus(&Interval::point(c)?, places)
        })
    }
}

/// The same, and its steps are counted.
pub fn enclosed(meter: &Meter, number: &Number, bits: u64) -> Result<Interval, Stop> {
    let places = bits.saturating_add(number.bits());
    meter.spend(places.saturating_mul(number.degree()) / 64)?;
    Interval::of(number, bits)
}
