//! Laurent polynomials in z, or in several variables.

use crate::numbers::Value;
use crate::text::Stop;
use std::collections::BTreeMap;
use std::slice::from_ref;

/// The greatest |k| of a power z^k.
const MAX_POWER: u64 = 16_384;

/// The exponents of the variables in a term. They are in lexicographic order.
pub trait Powers: Copy + Ord {
    /// The exponents.
    fn parts(&self) -> &[i64];

    /// These exponents, by their places.
    fn of(part: impl Fn(usize) -> Option<i64>) -> Option<Self>;

    /// No power of any variable.
    fn zero() -> Self;

    /// The exponents plus a multiple of others.
    fn plus(self, factor: i64, other: Self) -> Result<Self, Stop> {
        let part = |i: usize| self.parts()[i].checked_add(other.parts()[i].checked_mul(factor)?);
        Self::of(part).ok_or(POWER)
    }
}

impl Powers for i64 {
    fn parts(&self) -> &[i64] {
        from_ref(self)
    }

    fn of(part: impl Fn(usize) -> Option<i64>) -> Option<i64> {
        part(0)
    }

    fn zero() -> i64 {
        0
    }
}

impl Powers for [i64; 3] {
    fn parts(&self) -> &[i64] {
        self
    }

    fn of(part: impl Fn(usize) -> Option<i64>) -> Option<[i64; 3]> {
        Some([part(0)?, part(1)?, part(2)?])
    }

    fn zero() -> [i64; 3] {
        [0; 3]
    }
}

/// The coefficients by the powers of the variables; none is 0.
pub type Laurent<P = i64> = BTreeMap<P, Value>;

/// The cap of the powers.
pub const POWER: Stop = Stop::Capped("the powers of z in a symbol");

/// The number, or the polynomial in parameters, that this is without variables.
pub fn constant<P: Powers>(symbol: &Laurent<P>) -> Option<Value> {
    match (symbol.len(), symbol.get(&P::zero())) {
        (0, _) => Some(Value::int(0)),
        (1, found) => found.cloned(),
        _ => None,
    }
}

/// All coefficients with the other sign.
pub fn negated<P: Powers>(symbol: Laurent<P>) -> Result<Laurent<P>, Stop> {
    symbol.into_iter().map(|(k, c)| Ok((k, c.negated()?))).collect()
}

/// Adds a term.
pub fn add<P: Powers>(sum: &mut Laurent<P>, power: P, c: &Value) -> Result<(), Stop> {
    if power.parts().iter().any(|k| k.unsigned_abs() > MAX_POWER) {
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
pub fn sum<P: Powers>(terms: impl IntoIterator<Item = (P, Value)>) -> Result<Laurent<P>, Stop> {
    let mut sum = Laurent::new();
    terms.into_iter().try_for_each(|(power, c)| add(&mut sum, power, &c))?;
    Ok(sum)
}

/// The least and the greatest exponent of each variable; none of the polynomial 0.
pub fn ends<P: Powers>(symbol: &Laurent<P>) -> Option<[P; 2]> {
    let all = |i: usize| symbol.keys().map(move |powers| powers.parts()[i]);
    Some([P::of(|i| all(i).min())?, P::of(|i| all(i).max())?])
}
