//! Roots of exact numbers.

use crate::exact::{Enclosed as _, Enclosure, Integer, IntegerPolynomial, Rational, RealAlgebraic};
use std::cmp::Ordering;

/// The greatest degree of a polynomial of a root that is compared where enclosures do not decide.
const MAX_DEGREE: usize = 64;

/// The digits after the point of an enclosure of a root.
const PLACES: u32 = 14;

/// θ for θ^degree = root, between two neighbouring decimals of 14 places, or the number itself.
pub(crate) fn enclosed_root(root: &RealAlgebraic, degree: usize) -> Enclosure {
    let power = i32::try_from(degree).expect("a short product");
    let unit = Rational::from(Integer::power_of_ten(PLACES));
    let at = |x: &Integer| (Rational::from(x.clone()) / &unit).pow(power);
    let low = greatest(|x| root.cmp_rational(&at(x)).is_ge());
    let is_root = root.cmp_rational(&at(&low)).is_eq();
    let high = if is_root { low.clone() } else { &low + &Integer::one() };
    Enclosure::new(Rational::from(low) / &unit, Rational::from(high) / unit)
}

/// How a^{1/m} compares with b^{1/n}, for a, b ≥ 0; `None` where they are near and beyond the cap.
pub(super) fn order(
    (a, m): (&RealAlgebraic, usize),
    (b, n): (&RealAlgebraic, usize),
) -> Option<Ordering> {
    if m == n {
        return Some(a.cmp(b));
    }
    let (x, y) = (enclosed_root(a, m), enclosed_root(b, n));
    if x.upper() < y.lower() || y.upper() < x.lower() {
        return Some(x.lower().cmp(y.lower()));
    }
    let power = |x: &Rational, k: usize| Some(x.pow(i32::try_from(k).ok()?));
    if let (Some(a), Some(b)) = (a.as_rational(), b.as_rational()) {
        return Some(power(a, n)?.cmp(&power(b, m)?));
    }
    let theta = |x: &RealAlgebraic, degree: usize| {
        let least = x.polynomial().degree()? * degree;
        (least <= MAX_DEGREE).then(|| algebraic_root(x, degree))?
    };
    Some(theta(a, m)?.cmp(&theta(b, n)?))
}

/// The rational number q ≥ 0 with q^degree = x, if there is one.
pub(super) fn rational_root(x: &Rational, degree: usize) -> Option<Rational> {
    let degree = u32::try_from(degree).ok()?;
    Some(Rational::new(root(&x.numerator(), degree)?, root(&x.denominator(), degree)?))
}

/// The positive θ with θ^degree = x, as a root of f(z^degree), f a polynomial of x.
pub(super) fn algebraic_root(x: &RealAlgebraic, degree: usize) -> Option<RealAlgebraic> {
    let mut stretched = Vec::new();
    for c in x.polynomial().coefficients() {
        stretched.resize(stretched.len().next_multiple_of(degree), Integer::zero());
        stretched.push(c.clone());
    }
    let power = i32::try_from(degree).ok()?;
    // The power of a root is a root of f, and x is the only one of these in its interval.
    let is_root = |theta: &RealAlgebraic| {
        let enclosure = theta.enclosure(1);
        let (low, high) = (enclosure.lower().pow(power), enclosure.upper().pow(power));
        let (least, greatest) = x.bounds();
        let inside = least <= low && high <= greatest;
        let rational = x.as_rational().is_some_and(|x| low <= *x && *x <= high);
        theta.sign() > 0 && (inside || rational)
    };
    RealAlgebraic::roots_of(&IntegerPolynomial::new(stretched)).into_iter().find(is_root)
}

fn root(x: &Integer, degree: u32) -> Option<Integer> {
    let root = greatest(|root| root.pow(degree) <= *x);
    (root.pow(degree) == *x).then_some(root)
}

/// The greatest x ≥ 0 for which a condition holds that holds at 0, up to some x, and from there on no more.
pub(super) fn greatest(holds: impl Fn(&Integer) -> bool) -> Integer {
    let (mut low, mut high) = (Integer::zero(), Integer::one());
    while holds(&high) {
        low = high.clone();
        high = high.shifted_left(1);
    }
    while &high - &low > Integer::one() {
        let middle = (&low + &high).shifted_right(1);
        if holds(&middle) { low = middle } else { high = middle }
    }
    low
}
