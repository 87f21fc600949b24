//! Sums and products of values, whose steps are counted.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Ring, Value, count};
use crate::text::Stop;

/// Values whose steps this meter counts.
pub struct Values<'m>(pub &'m Meter);

impl Ring<Value> for Values<'_> {
    fn integer(&self, value: i64) -> Value {
        Value::int(value)
    }

    fn add(&self, sum: &mut Value, term: &Value) -> Result<(), Stop> {
        plus(self.0, sum, term)
    }

    fn add_product(&self, sum: &mut Value, left: &Value, right: &Value) -> Result<(), Stop> {
        add(self.0, sum, left, right)
    }

    fn share(&self, x: &Value, k: usize) -> Result<Value, Stop> {
        over(self.0, x, &count(k).into())?.negated()
    }
}

/// left · right.
pub fn times(meter: &Meter, left: &Value, right: &Value) -> Result<Value, Stop> {
    meter.spend(left.steps(right).saturating_add(left.cost_of_sum(right)))?;
    left.times(right)
}

/// Adds left · right to a sum.
pub fn add(meter: &Meter, sum: &mut Value, left: &Value, right: &Value) -> Result<(), Stop> {
    meter.spend(1)?;
    if left.is_zero() || right.is_zero() {
        return Ok(());
    }
    plus(meter, sum, &times(meter, left, right)?)
}

/// Adds a term to a sum.
pub fn plus(meter: &Meter, sum: &mut Value, term: &Value) -> Result<(), Stop> {
    meter.spend(sum.steps(term).saturating_add(sum.cost_of_sum(term)))?;
    sum.add(1, term)
}

/// left / right.
pub fn over(meter: &Meter, left: &Value, right: &Value) -> Result<Value, Stop> {
    meter.spend(left.steps(right).saturating_add(left.cost_of_quotient(right)))?;
    left.over(right)
}
