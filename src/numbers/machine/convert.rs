//! Conversion between exact numbers and f64.

use crate::exact::{Enclosed, Integer, Rational, Real};
use std::cmp::Ordering;

/// 2^`LEAST_EXPONENT` is the least positive f64.
const LEAST_EXPONENT: i64 = -1074;

/// The number of bits of the fraction field of an f64.
const FRACTION_BITS: u32 = 52;

/// The f64 nearest to `value`; of two equally near ones, the one with the even last bit.
/// A value beyond the greatest f64 by half a unit in its last place or more gives an
/// infinity. A negative value that rounds to 0 gives −0.
///
/// The enclosure of an irrational value is refined until both ends round to the same f64.
///
/// The computation uses integer arithmetic on p/q only, so it is right for subnormal
/// results too. With 2^E ≤ |value| < 2^{E+1} and s = max(E − 52, −1074), the result is
/// m·2^s, where m is |value|/2^s rounded to an integer, half to even.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::nearest;
///
/// assert_eq!(nearest(&Rational::new(1, 10)), 0.1);
/// assert_eq!(nearest(&Rational::new(-2, 3)), -2.0 / 3.0);
/// assert_eq!(nearest(&Rational::power_of_ten(400)), f64::INFINITY);
/// ```
///
/// # Panics
/// Never.
#[must_use]
pub fn nearest(value: &impl Enclosed) -> f64 {
    // Results are compared by their bits, since −0 == 0.
    f64::from_bits(value.step(|value| nearest_rational(value).to_bits()))
}

fn nearest_rational(value: &Rational) -> f64 {
    let magnitude = f64::from_bits(nearest_bits(value, &DOUBLE));
    if value.sign() < 0 { -magnitude } else { magnitude }
}

/// The f32 nearest to `value`, as [`nearest`] for f64. It is not the f32 nearest to that f64: rounding
/// twice may miss by a unit in the last place.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::{nearest, nearest_f32};
///
/// assert_eq!(nearest_f32(&Rational::new(1, 10)), 0.1);
/// // Just above half-way between 1 and the next f32, and nearer to half-way than an f64 can tell.
/// let half_way = Rational::one() + Rational::from(2).pow(-24);
/// let above = half_way + Rational::from(2).pow(-60);
/// assert_eq!(nearest_f32(&above), 1.0 + f32::EPSILON);
/// assert_eq!(nearest(&above) as f32, 1.0);
/// ```
///
/// # Panics
/// Never.
#[must_use]
pub fn nearest_f32(value: &impl Enclosed) -> f32 {
    f32::from_bits(value.step(|value| {
        let bits = nearest_bits(value, &SINGLE);
        let sign = if value.sign() < 0 { 1 << 31 } else { 0 };
        sign | u32::try_from(bits).expect("at most that of the infinity")
    }))
}

/// A binary format of IEEE 754.
struct Layout {
    /// The number of bits of the fraction field.
    fraction: u32,
    /// 2 to this power is the least positive number.
    least: i64,
    /// The bits of the infinity.
    infinity: u64,
    /// Every number of at least 2 to this power rounds to the infinity.
    beyond: i64,
}

const DOUBLE: Layout = Layout {
    fraction: FRACTION_BITS,
    least: LEAST_EXPONENT,
    infinity: 0x7ff0_0000_0000_0000,
    beyond: 1_024,
};

const SINGLE: Layout = Layout { fraction: 23, least: -149, infinity: 0x7f80_0000, beyond: 128 };

/// The bits of the number of a format that is nearest to |`value`|.
fn nearest_bits(value: &Rational, layout: &Layout) -> u64 {
    let (p, q) = (value.numerator().abs(), value.denominator());
    if p.is_zero() {
        return 0;
    }
    let bits = |integer: &Integer| i64::try_from(integer.bits()).expect("it fits in memory");
    // 2^(guess−1) < p/q < 2^(guess+1).
    let guess = bits(&p) - bits(&q);
    if guess > layout.beyond + 2 {
        return layout.infinity;
    }
    if guess < layout.least - 2 {
        return 0;
    }
    let (left, right) = scaled(p.clone(), q.clone(), guess);
    let exponent = if left >= right { guess } else { guess - 1 };
    let unit = (exponent - i64::from(layout.fraction)).max(layout.least);
    let (left, right) = scaled(p, q, unit);
    let mantissa = round_half_even(&left, &right);
    let mantissa = mantissa.to_i128().and_then(|m| u64::try_from(m).ok()).expect("m ≤ 2^53");
    // With f bits of the fraction, m < 2^f occurs only at the least s; then m itself is the bit pattern
    // of the subnormal number. Otherwise the hidden bit of m adds 1 to the exponent field
    // s − least. If rounding gives m = 2^(f+1), the carry adds 1 once more.
    let field = u64::try_from(unit - layout.least).expect("s is not below the least");
    ((field << layout.fraction) + mantissa).min(layout.infinity)
}

/// (p/q)/2^`exponent` as a fraction of integers.
fn scaled(p: Integer, q: Integer, exponent: i64) -> (Integer, Integer) {
    let power = power_of_two(exponent.unsigned_abs());
    if exponent < 0 { (p * power, q) } else { (p, q * power) }
}

fn power_of_two(exponent: u64) -> Integer {
    Integer::from(2).pow(u32::try_from(exponent).expect("an exponent of an f64"))
}

/// p/q rounded to an integer, half to even.
fn round_half_even(p: &Integer, q: &Integer) -> Integer {
    let (floor, rest) = p.div_rem_floor(q);
    let up = match (&rest + &rest).cmp(q) {
        Ordering::Less => false,
        Ordering::Equal => !floor.is_even(),
        Ordering::Greater => true,
    };
    if up { floor + Integer::one() } else { floor }
}

/// The mantissa m and the exponent s with |`value`| = m·2^s, s ≥ −1074, for a
/// finite value.
pub(super) fn parts(value: f64) -> (u64, i64) {
    let bits = value.to_bits();
    let (fraction, field) = (bits & ((1 << FRACTION_BITS) - 1), (bits >> FRACTION_BITS) & 0x7ff);
    let hidden = u64::from(field > 0) << FRACTION_BITS;
    let field = i64::try_from(field.max(1)).expect("11 bits");
    (fraction + hidden, field - 1 + LEAST_EXPONENT)
}

/// m·2^`exponent`.
pub(super) fn binary(mantissa: Integer, exponent: i64) -> Rational {
    let power = power_of_two(exponent.unsigned_abs());
    if exponent < 0 { Rational::new(mantissa, power) } else { Rational::from(mantissa * power) }
}

/// The exact value of a finite f64; `None` for NaN and the infinities.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::exact;
///
/// assert_eq!(exact(-0.375), Some(Rational::new(-3, 8)));
/// assert_eq!(exact(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
/// assert_eq!(exact(f64::NAN), None);
/// ```
#[must_use]
pub fn exact(value: f64) -> Option<Rational> {
    value.is_finite().then(|| {
        let (mantissa, exponent) = parts(value);
        let magnitude = binary(Integer::from(mantissa), exponent);
        if value.is_sign_negative() { -magnitude } else { magnitude }
    })
}

/// The least f64 that is at least `value`; +∞ beyond the greatest f64.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::{lower, upper};
///
/// let third = Rational::new(1, 3);
/// assert_eq!(upper(&third), lower(&third).next_up());
/// assert_eq!(upper(&Rational::new(1, 4)), 0.25);
/// ```
#[must_use]
pub fn upper(value: &Rational) -> f64 {
    let near = nearest(value);
    match exact(near) {
        Some(found) if found < *value => near.next_up(),
        None if near < 0.0 => near.next_up(),
        _ => near,
    }
}

/// The greatest f64 that is at most `value`; −∞ below the least f64.
#[must_use]
pub fn lower(value: &Rational) -> f64 {
    -upper(&-value)
}

/// The unit in the last place of a finite f64: 2^{max(E,−1022)−52} for
/// 2^E ≤ |x| < 2^{E+1}, and 2^−1074 for x = 0; the distance from |x| to the next
/// greater f64. `None` for NaN and the infinities.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::ulp;
///
/// assert_eq!(ulp(1.0), Some(Rational::from(2).pow(-52)));
/// assert_eq!(ulp(0.0), Some(Rational::from(2).pow(-1074)));
/// ```
#[must_use]
pub fn ulp(value: f64) -> Option<Rational> {
    value.is_finite().then(|| binary(Integer::one(), parts(value).1))
}

/// |`value` − `target`| / ulp(nearest(`target`)), the distance in units in the last
/// place; at most 1/2 exactly when `value` is a nearest f64 (at a power of two, at most
/// 1/4 on the side towards 0). For a target beyond the greatest f64, the ulp of the
/// greatest f64 is used. `None` when `value` is not finite.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::ulps_between;
///
/// assert_eq!(ulps_between(1.0 + f64::EPSILON, &Rational::one()), Some(Rational::one()));
/// assert_eq!(ulps_between(f64::INFINITY, &Rational::one()), None);
/// ```
#[must_use]
pub fn ulps_between<V: Real + Enclosed>(value: f64, target: &V) -> Option<V> {
    let near = nearest(target).clamp(f64::MIN, f64::MAX);
    let distance = V::from_rational(&exact(value)?).minus(target).magnitude();
    Some(distance.over(&V::from_rational(&ulp(near)?)))
}

/// The shortest decimal that is read as `value`: `0.1`, `1e-7`, `inf`, `NaN`.
#[must_use]
pub fn shortest(value: f64) -> String {
    format!("{value:?}")
}
