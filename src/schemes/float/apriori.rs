//! A priori bounds on the error of f64 computations.

use super::upward::{add_up, div_up, mul_up, sub_down};
use crate::exact::{Enclosed, Rational, Real, Scalar};
use crate::formula::Value;
use crate::machine::{exact, nearest};

/// u = 2^−53, the unit roundoff.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// η = 2^−1074, the least positive f64.
const LEAST: f64 = f64::from_bits(1);

/// An exact value x, and a number e with |x̃ − x| ≤ e. Here x̃ is the f64 that the same
/// operations, in the same order, compute from the same numbers after each has been
/// converted to the nearest f64. Exact values are rational, or of another type of real
/// numbers.
///
/// A generic algorithm over [`Real`] performs the same operations on f64 and on this
/// type, provided that it does not branch on values; the algorithms of
/// [`bound`](crate::bound) do not. By induction over the operations, its f64 results lie
/// within e of the exact ones. The bound is a priori: it is computed from exact operands
/// and bounds only, never from an f64 result. e = ∞ gives no information; x̃ may be NaN.
///
/// **Rounding.** Let z̃ be the exact result of one operation on the f64 operands, z the
/// exact result on the exact operands, and |z̃ − z| ≤ d. The f64 result is fl(z̃), and
/// |fl(z̃) − z̃| ≤ max(u|z̃|, η/2) with u = 2^−53, η = 2^−1074, unless it overflows. It
/// does not overflow if |z̃| is at most the greatest f64. As
/// |z̃| ≤ m := |z| + d, the new error is at most e = d + max(u·m, η), and ∞ when m is
/// beyond the greatest f64. When d = 0 and z is itself an f64, z̃ = z = fl(z̃): e = 0.
///
/// **Propagation.** With e_x and e_y the errors of the operands, d is
///
/// | operation | d | because |
/// |---|---|---|
/// | conversion of x | 0 | z̃ = z = x |
/// | x ± y | e_x + e_y | |
/// | x·y | \|x\|e_y + \|y\|e_x + e_x e_y | x̃ỹ − xy = x(ỹ−y) + y(x̃−x) + (x̃−x)(ỹ−y) |
/// | x/y | (e_x + \|x/y\|e_y)/(\|y\| − e_y) | x̃/ỹ − x/y = ((x̃−x) − (x/y)(ỹ−y))/ỹ |
///
/// where the quotient has e = ∞ unless |y| > e_y. The magnitude, the negative, a sum with
/// an exact 0 and a product with an exact 0 or ±1 do not round. The error of the maximum
/// of two numbers is at most the greater of their errors, since max is 1-Lipschitz in the
/// maximum norm.
///
/// All bounds are computed in f64, rounded upwards after each operation.
///
/// ```
/// use subcert::exact::{Rational, Scalar};
/// use subcert::float::Tracked;
///
/// let tenth: Tracked = Tracked::from_rational(&Rational::new(1, 10));
/// let sum = Tracked::total(&vec![tenth; 10]);
/// assert_eq!(*sum.value(), Rational::one());
/// // The f64 sum is 0.9999999999999999, off by 1.1e-16.
/// assert!(sum.error() > 1.1e-16 && sum.error() < 2e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tracked<V = Rational> {
    value: V,
    error: f64,
}

impl<V> Tracked<V> {
    /// x, the exact value.
    #[must_use]
    pub fn value(&self) -> &V {
        &self.value
    }

    /// e, the bound on the absolute error of the f64 computation; never NaN.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error
    }
}

impl<V: Real + Value + Enclosed> Tracked<V> {
    /// The number `value`, converted to the nearest f64.
    #[must_use]
    pub fn nearest(value: V) -> Tracked<V> {
        Tracked::rounded(value, 0.0)
    }

    /// The result of an operation, where `value` is z and `before` is d in the notation
    /// of "Rounding" above.
    fn rounded(value: V, before: f64) -> Tracked<V> {
        if before == 0.0 && is_float(&value) {
            return Tracked { value, error: 0.0 };
        }
        let size = add_up(above(&value), before);
        // If `size` is infinite, so is the error.
        let error = add_up(before, mul_up(UNIT_ROUNDOFF, size).max(LEAST));
        Tracked { value, error }
    }

    /// Whether the f64 is certainly 0.
    fn is_exactly_zero(&self) -> bool {
        self.error == 0.0 && self.value.vanishes() == Some(true)
    }

    fn negated(&self) -> Tracked<V> {
        Tracked { value: V::zero().minus(&self.value), error: self.error }
    }

    /// self·other if self is 0 or ±1 without error.
    fn trivial_product(&self, other: &Tracked<V>) -> Option<Tracked<V>> {
        if self.error != 0.0 {
            return None;
        }
        let factor = self.value.as_rational()?;
        if factor.is_zero() {
            // 0·x̃ = 0 for every finite x̃. If the error of x is infinite, the product
            // may be 0·∞.
            let error = if other.error.is_finite() { 0.0 } else { f64::INFINITY };
            Some(Tracked { value: V::zero(), error })
        } else if factor == Rational::one() {
            Some(other.clone())
        } else {
            (-factor == Rational::one()).then(|| other.negated())
        }
    }
}

impl<V: Real + Value + Enclosed> Scalar for Tracked<V> {
    fn from_rational(value: &Rational) -> Tracked<V> {
        Tracked::nearest(V::from_rational(value))
    }

    fn plus(&self, other: &Tracked<V>) -> Tracked<V> {
        if self.is_exactly_zero() {
            other.clone()
        } else if other.is_exactly_zero() {
            self.clone()
        } else {
            Tracked::rounded(self.value.plus(&other.value), add_up(self.error, other.error))
        }
    }

    fn minus(&self, other: &Tracked<V>) -> Tracked<V> {
        self.plus(&other.negated())
    }

    fn times(&self, other: &Tracked<V>) -> Tracked<V> {
        if let Some(product) = self.trivial_product(other).or_else(|| other.trivial_product(self)) {
            return product;
        }
        let linear = add_up(
            mul_up(above(&self.value), other.error),
            mul_up(above(&other.value), self.error),
        );
        let before = add_up(linear, mul_up(self.error, other.error));
        Tracked::rounded(self.value.times(&other.value), before)
    }
}

impl<V: Real + Value + Enclosed> Real for Tracked<V> {
    fn magnitude(&self) -> Tracked<V> {
        Tracked { value: self.value.magnitude(), error: self.error }
    }

    fn greater(&self, other: &Tracked<V>) -> Tracked<V> {
        let value = self.value.greater(&other.value);
        Tracked { value, error: self.error.max(other.error) }
    }

    /// # Panics
    /// When the exact value of `other` is 0.
    fn over(&self, other: &Tracked<V>) -> Tracked<V> {
        let value = self.value.over(&other.value);
        let divisor = sub_down(below(&other.value), other.error);
        if divisor == 0.0 || self.error.is_infinite() {
            return Tracked { value, error: f64::INFINITY };
        }
        let numerator = add_up(self.error, mul_up(above(&value), other.error));
        Tracked::rounded(value, div_up(numerator, divisor))
    }
}

/// Whether `value` is itself an f64.
fn is_float(value: &impl Value) -> bool {
    let Some(value) = value.as_rational() else { return false };
    match small(&value) {
        // p < 2^127, and q is a power of two, at most 2^126. So p/q is an f64 exactly if
        // the odd part of p has at most 53 bits.
        Some((p, q)) => {
            q.is_power_of_two() && (p == 0 || p >> p.trailing_zeros() < 1 << f64::MANTISSA_DIGITS)
        }
        None => exact(nearest(&value)).as_ref() == Some(&value),
    }
}

/// An f64 that is at least |x|.
///
/// For |x| = p/q with p, q < 2^127 the machine computes r = fl(fl(p)/fl(q)) with three
/// roundings by relative errors of at most u, so that p/q ≤ r(1+u)/(1−u)² ≤ r(1+4u) and
/// p/q ≥ r(1−u)/(1+u)² ≥ r(1−4u). Nothing underflows. For other x, |x| lies between the
/// two neighbours of its nearest f64.
fn above(value: &(impl Value + Enclosed)) -> f64 {
    match quotient(value) {
        Some(r) => mul_up(r, 1.0 + 4.0 * UNIT_ROUNDOFF),
        None => nearest(value).abs().next_up(),
    }
}

/// An f64 that is at most |x|; see [`above`].
fn below(value: &(impl Value + Enclosed)) -> f64 {
    match quotient(value) {
        Some(r) => (r * (1.0 - 4.0 * UNIT_ROUNDOFF)).next_down().max(0.0),
        None => nearest(value).abs().next_down().max(0.0),
    }
}

#[expect(clippy::cast_precision_loss, reason = "the proof counts these roundings")]
fn quotient(value: &impl Value) -> Option<f64> {
    small(&value.as_rational()?).map(|(p, q)| p as f64 / q as f64)
}

/// (p, q) with |value| = p/q, if both are below 2^127.
fn small(value: &Rational) -> Option<(u128, u128)> {
    let p = value.numerator().to_i128()?.unsigned_abs();
    let q = value.denominator().to_i128()?.unsigned_abs();
    Some((p, q)).filter(|_| p <= i128::MAX.unsigned_abs())
}
