//! Polynomials in one variable, and their roots by Sturm's theorem. The constant coefficient
//! comes first.

use crate::decimal::{Q, bits};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{Num, One, Signed, Zero};

/// The quotient and the remainder. The leading coefficient of the divisor has to divide the
/// coefficients that it meets.
pub fn divide<T: Num + Clone>(mut p: Vec<T>, divisor: &[T]) -> (Vec<T>, Vec<T>) {
    let degree = divisor.len() - 1;
    let mut quotient = vec![T::zero(); p.len().saturating_sub(degree)];
    for i in (0..quotient.len()).rev() {
        quotient[i] = p[i + degree].clone() / divisor[degree].clone();
        for (j, coefficient) in divisor.iter().enumerate() {
            p[i + j] = p[i + j].clone() - quotient[i].clone() * coefficient.clone();
        }
    }
    p.truncate(degree);
    (quotient, p)
}

/// Removes the leading coefficients that are 0.
pub fn trimmed(mut p: Vec<Q>) -> Vec<Q> {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

/// The sign: −1, 0 or 1.
pub fn signum<T: Signed>(value: &T) -> i8 {
    i8::from(value.is_positive()) - i8::from(value.is_negative())
}

/// The value p(x).
pub fn at(p: &[Q], x: &Q) -> Q {
    p.iter().rev().fold(Q::zero(), |sum, coefficient| sum * x + coefficient)
}

/// A greatest common divisor.
pub fn gcd(p: &[Q], q: &[Q]) -> Vec<Q> {
    let (mut one, mut other) = (trimmed(p.to_vec()), trimmed(q.to_vec()));
    while !other.is_empty() {
        let rest = divide(one, &other).1;
        (one, other) = (other, trimmed(rest));
    }
    one
}

/// An upper bound of the absolute values of the roots of p ≠ 0.
pub fn beyond_roots(p: &[Q]) -> Q {
    let p = trimmed(p.to_vec());
    let leading = &p[p.len() - 1];
    p.iter().map(|coefficient| (coefficient / leading).abs()).sum::<Q>() + Q::one()
}

/// The steps of [`roots_between`]: for each of so many coefficients, the squares of the lengths that the remainders and
/// their values have.
pub fn steps_between(p: &[Q], low: &Q, high: &Q) -> u64 {
    let length = p.len() as u64;
    let longest = p.iter().map(bits).max().unwrap_or(0) + bits(low) + bits(high);
    let blocks = length * longest / 1024;
    length * length * (1 + blocks + blocks * blocks / 16)
}

/// The number of distinct roots of p ≠ 0 between low and high, which are no roots themselves.
pub fn roots_between(p: &[Q], low: &Q, high: &Q) -> usize {
    // Sturm's chain is p, p′ and then the negated remainders. Positive factors do not matter.
    let p = whole(&trimmed(p.to_vec()));
    let derivative = (1..).zip(p.iter().skip(1)).map(|(i, c)| c * BigInt::from(i)).collect();
    let mut chain = vec![p, derivative];
    while let [.., before, last] = &chain[..]
        && !last.is_empty()
    {
        let rational = |p: &[BigInt]| p.iter().cloned().map(Q::from_integer).collect::<Vec<Q>>();
        let (_, remainder) = divide(rational(before), &rational(last));
        chain.push(whole(&trimmed(remainder)).into_iter().map(|c| -c).collect());
    }
    let changes = |x: &Q| {
        let signs = chain.iter().map(|p| sign_at(p, x)).filter(|sign| *sign != 0);
        signs.collect::<Vec<i8>>().windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low).saturating_sub(changes(high))
}

/// The positive multiple with integer coefficients without a common divisor.
fn whole(p: &[Q]) -> Vec<BigInt> {
    let over = p.iter().fold(BigInt::one(), |over, c| over.lcm(c.denom()));
    let whole: Vec<BigInt> = p.iter().map(|c| c.numer() * (&over / c.denom())).collect();
    let divisor = whole.iter().fold(BigInt::zero(), |divisor, c| divisor.gcd(c));
    whole.into_iter().map(|c| c / &divisor).collect()
}

/// The sign of p(x), that of Σ c_i·a^i·b^{d−i} for x = a/b.
fn sign_at(p: &[BigInt], x: &Q) -> i8 {
    let (mut value, mut power) = (BigInt::zero(), BigInt::one());
    for c in p.iter().rev() {
        value = value * x.numer() + c * &power;
        power *= x.denom();
    }
    signum(&value)
}
