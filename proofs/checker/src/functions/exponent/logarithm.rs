//! Enclosures of logarithms to the base n.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Q, count};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

/// The binary digits behind the point of natural logarithms, and of those to the base n.
const DIGITS: u64 = 192;
const PLACES: u64 = 96;

/// The longest numbers of which it is asked whether they are powers.
const MAX_BITS: u64 = 4_096;

/// The bounds of a number. They are equal if it is known exactly.
#[derive(Clone)]
pub struct Logarithm {
    pub low: Q,
    pub high: Q,
}

impl Logarithm {
    /// The number times a factor.
    pub fn scaled(&self, factor: &Q) -> Logarithm {
        let (low, high) = (&self.low * factor, &self.high * factor);
        if factor.is_negative() {
            return Logarithm { low: high, high: low };
        }
        Logarithm { low, high }
    }

    /// The number and another one.
    pub fn plus(&self, other: &Q) -> Logarithm {
        Logarithm { low: &self.low + other, high: &self.high + other }
    }
}

/// The primitive root r of n, and e with n = r^e.
pub fn root(n: usize) -> (usize, usize) {
    let exponent = |r: usize| {
        let powers = std::iter::successors(Some(r), |power| power.checked_mul(r));
        powers.zip(1..).take_while(|(power, _)| *power <= n).find(|(power, _)| *power == n)
    };
    (2..=n).find_map(|r| Some((r, exponent(r)?.1))).unwrap_or((n, 1))
}

/// log_n x, if it is rational. Then x is a power of the root of n.
fn exact(n: usize, x: &Q) -> Option<Q> {
    let (r, e) = root(n);
    let r = BigInt::from(r);
    let (top, bottom) = (x.numer(), x.denom());
    let (mut rest, negative) = match (top.is_one(), bottom.is_one()) {
        (_, true) => (top.clone(), false),
        (true, false) => (bottom.clone(), true),
        _ => return None,
    };
    if rest.bits() > MAX_BITS {
        return None;
    }
    let mut power = 0_usize;
    while !rest.is_one() {
        let (quotient, remainder) = rest.div_rem(&r);
        if !remainder.is_zero() {
            return None;
        }
        rest = quotient;
        power = power.saturating_add(1);
    }
    let value = count(power) / count(e);
    Some(if negative { -value } else { value })
}

/// log_n x for x > 0.
pub fn logarithm(n: usize, x: &Q) -> Option<Logarithm> {
    if !x.is_positive() {
        return None;
    }
    if let Some(value) = exact(n, x) {
        return Some(Logarithm { low: value.clone(), high: value });
    }
    let ([low, high], [least, greatest]) = (natural(x), natural(&count(n)));
    // ln n > 0.
    let low = Q::new(low.clone(), if low.is_negative() { least.clone() } else { greatest.clone() });
    let high = Q::new(high.clone(), if high.is_negative() { greatest } else { least });
    let unit = BigInt::one() << PLACES;
    let outward = |x: Q, up: bool| {
        let scaled = x * Q::from_integer(unit.clone());
        Q::new(if up { scaled.ceil() } else { scaled.floor() }.to_integer(), unit.clone())
    };
    Some(Logarithm { low: outward(low, false), high: outward(high, true) })
}

/// ln x, times 2^DIGITS: x = 2^e·m with 1/2 < m < 2, and ln m = 2 artanh((m − 1)/(m + 1)).
fn natural(x: &Q) -> [BigInt; 2] {
    let length = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX);
    let e = length(x.numer()).saturating_sub(length(x.denom()));
    let size = e.unsigned_abs();
    let m = if e < 0 {
        Q::new(x.numer() << size, x.denom().clone())
    } else {
        Q::new(x.numer().clone(), x.denom() << size)
    };
    let t = (&m - Q::one()) / (&m + Q::one());
    let scaled = &t * Q::from_integer(BigInt::one() << DIGITS);
    let ends = [scaled.floor().to_integer(), scaled.ceil().to_integer()];
    let third: BigInt = (BigInt::one() << DIGITS) / 3_u8;
    let two = [artanh(&third, false), artanh(&(third + 1_u8), true)];
    let [low, high] = ends;
    let of_m = [artanh(&low, false), artanh(&high, true)];
    let [below, above] = if e < 0 { [&two[1], &two[0]] } else { [&two[0], &two[1]] };
    [(&of_m[0] + below * e) * 2_u8, (&of_m[1] + above * e) * 2_u8]
}

/// A bound of artanh t = Σ t^{2k+1}/(2k + 1), |t| ≤ 2/5, times 2^DIGITS, from above or from below.
fn artanh(t: &BigInt, above: bool) -> BigInt {
    // The function is odd.
    if t.is_negative() {
        return -artanh(&-t, !above);
    }
    // What is cut is too small; from above, one is added wherever something is cut.
    let up = u8::from(above);
    let square: BigInt = ((t * t) >> DIGITS) + up;
    let (mut power, mut sum) = (t.clone(), BigInt::zero());
    for k in 0..DIGITS {
        sum += &power / (2_u64.saturating_mul(k).saturating_add(1)) + up;
        power = ((&power * &square) >> DIGITS) + up;
    }
    // The rest of the series is below 2^{−2·DIGITS}, and the power has this many units at most.
    if above { sum + power * 2_u8 } else { sum }
}
