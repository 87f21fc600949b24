//! Whether a scheme keeps the ratios of neighbouring differences between 1/r and r.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, index, wrong};
use super::masks::{Mask, divided, signed};
use super::steps::{plus, times};
use crate::numbers::{Meter, Piece, Value};
use crate::text::Stop;

/// The greatest order of the differences.
const MAX_ORDER: i64 = 8;

/// The value of `keeps_ratios`; `None` if the call is another one.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    let ("keeps_ratios", [m, r]) = (call.function, call.arguments) else { return Ok(None) };
    let (meter, piece) = (call.library.meter, call.piece());
    let m = index(m, 0, MAX_ORDER)?;
    if r.minus(&Value::int(1))?.sign(piece)? < 0 {
        return wrong("a ratio is at least 1");
    }
    let mask = Mask::called(call)?;
    let Some(b) = divided(meter, &mask.values, (mask.arity, m), piece)? else {
        return wrong("the symbol has no differences of this order");
    };
    let cone = Cone { meter, piece, square: times(meter, r, r)?, r };
    Ok(Some(Value::int(cone.is_kept(&b, mask.arity)?.into())))
}

/// The sequences d with d_i ≥ 0, d_{i+1} ≤ r d_i and d_i ≤ r d_{i+1} for all i.
struct Cone<'c> {
    meter: &'c Meter,
    piece: Option<&'c Piece<'c>>,
    r: &'c Value,
    /// r².
    square: Value,
}

impl Cone<'_> {
    /// Whether all d'_j = Σ_i b_{j−ni}d_i are of this kind. The conditions on d' for j + n are those for j, one place later.
    fn is_kept(&self, b: &[Value], n: usize) -> Result<bool, Stop> {
        let (n, zero, minus_one) = (signed(n)?, Value::int(0), Value::int(-1));
        let one = Value::int(1);
        let last = signed(b.len())?;
        for j in 0..n {
            // From the first i with j − ni below the length of b to the last one with j + 1 − ni ≥ 0.
            let next = j.saturating_add(1);
            let first = next.saturating_sub(last).div_euclid(n);
            let window = first..=next.div_euclid(n);
            for [of_j, of_next] in [[&one, &zero], [self.r, &minus_one], [&minus_one, self.r]] {
                let mut functional = Vec::new();
                for i in window.clone() {
                    let entry = |j: i64| {
                        let place = j.saturating_sub(n.saturating_mul(i));
                        usize::try_from(place).ok().and_then(|place| b.get(place))
                    };
                    let mut sum = Value::int(0);
                    for (factor, b) in [(of_j, entry(j)), (of_next, entry(next))] {
                        if let Some(b) = b {
                            plus(self.meter, &mut sum, &times(self.meter, factor, b)?)?;
                        }
                    }
                    functional.push(sum);
                }
                if !self.is_positive(&functional)? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Whether Σ_i c_i d_i ≥ 0 for all d. With ρ_i = d_{i+1}/d_i it is d_p(c_p + ρ_p(c_{p+1} + ρ_{p+1}(…))), each ρ is any number from 1/r to r, and the
    /// least value of ρV is V/r or rV. The values are multiplied by powers of r: no polynomial has to be divided by r.
    fn is_positive(&self, functional: &[Value]) -> Result<bool, Stop> {
        let (mut least, mut power) = (Value::int(0), Value::int(1));
        for c in functional.iter().rev() {
            if least.sign(self.piece)? < 0 {
                least = times(self.meter, &least, &self.square)?;
            }
            plus(self.meter, &mut least, &times(self.meter, &power, c)?)?;
            power = times(self.meter, &power, self.r)?;
        }
        Ok(least.sign(self.piece)? >= 0)
    }
}
