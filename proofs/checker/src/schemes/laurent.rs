//! Laurent polynomials in z.

use crate::numbers::Value;
use crate::text::Stop;
use std::collections::BTreeMap;

/// The greatest |k| of a power z^k.
const MAX_POWER: u64 = 16_384;

/// The coefficients by the powers of z; none is 0.
pub type Laurent = BTreeMap<i64, Value>;

/// The cap of the powers.
pub const POWER: Stop = Stop::Capped("the powers of z in a symbol");

/// The number, or the polynomial in parameters, that this is without z.
pub fn constant(symbol: &Laurent) -> Option<Value> {
    match (symbol.len(), symbol.get(&0)) {
        (0, _) => Some(Value::int(0)),
        (1, found) => found.cloned(),
        _ => None,
    }
}

/// All coefficients with the other sign.
pub fn negated(symbol: Laurent) -> Result<Laurent, Stop> {
    symbol.into_iter().map(|(k, c)| Ok((k, c.negated()?))).collect()
}

/// Adds a term.
pub fn add(sum: &mut Laurent, power: i64, c: &Value) -> Result<(), Stop> {
    if power.unsigned_abs() > MAX_POWER {
        return Err(POWER);
    }
    let known = sum.remove(&power);
    let value = known.map_or(Ok(c.clone()), |known| known.plus(1, c))?;
    if !value.is_zero() {
        sum.insert(power, value);
    }
    Ok(())
}

/// The sum of these terms.
pub fn sum(terms: impl IntoIterator<Item = (i64, Value)>) -> Result<Laurent, Stop> {
    let mut sum = Laurent::new();
    terms.into_iter().try_for_each(|(power, c)| add(&mut sum, power, &c))?;
    Ok(sum)
}
