//! Polynomials in one variable, and their roots by Sturm's theorem. The constant coefficient
//! comes first.

use super::decimal::{Q, bits};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{Num, One, Signed, Zero};
use std::ops::{AddAssign, Mul};

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

/// The product.
pub fn multiplied<T: Num + Clone + AddAssign>(p: &[T], q: &[T]) -> Vec<T>
where
    for<'t> &'t T: Mul<Output = T>,
{
    let mut product = vec![T::zero(); (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
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
    let last = remainders(whole(p), whole(q)).into_iter().rfind(|p| !p.is_empty());
    let last: Vec<Q> = last.unwrap_or_default().into_iter().map(Q::from_integer).collect();
    whole(&last).into_iter().map(Q::from_integer).collect()
}

/// The steps of [`gcd`].
pub fn steps_of_gcd(p: &[Q], q: &[Q]) -> u64 {
    let [p, q] = [p, q].map(whole);
    steps(p.len().max(q.len()), longest(&p) + longest(&q))
}

/// The steps of the remainders of polynomials with so many coefficients, each of so many binary digits: those of products of
/// pairs of numbers that are as long as all coefficients together, for each pair of coefficients.
fn steps(count: usize, bits: u64) -> u64 {
    let count = count as u64;
    let blocks = count * bits / 1024;
    count * count * (1 + blocks + 3 * blocks * blocks)
}

fn longest(p: &[BigInt]) -> u64 {
    p.iter().map(BigInt::bits).max().unwrap_or(0)
}

/// An upper bound of the absolute values of the roots of p ≠ 0.
pub fn beyond_roots(p: &[Q]) -> Q {
    let p = trimmed(p.to_vec());
    let leading = &p[p.len() - 1];
    p.iter().map(|coefficient| (coefficient / leading).abs()).sum::<Q>() + Q::one()
}

/// The steps of [`roots_between`].
pub fn steps_between(p: &[Q], low: &Q, high: &Q) -> u64 {
    let p = whole(p);
    steps(p.len(), longest(&p) + bits(low) + bits(high))
}

/// The number of distinct roots of p ≠ 0 between low and high, which are no roots themselves.
pub fn roots_between(p: &[Q], low: &Q, high: &Q) -> usize {
    // Sturm's chain is p, p′ and then the negated remainders. Positive factors do not matter.
    let p = whole(p);
    let derivative = (1..).zip(p.iter().skip(1)).map(|(i, c)| c * BigInt::from(i)).collect();
    let chain = remainders(p, derivative);
    let changes = |x: &Q| {
        let signs = chain.iter().map(|p| sign_at(p, x)).filter(|sign| *sign != 0);
        signs.collect::<Vec<i8>>().windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low).saturating_sub(changes(high))
}

/// Two polynomials, and the negated remainders up to the last that is not 0, each with a positive factor: that of a
/// subresultant, so that the coefficients remain short without their common divisors.
fn remainders(p: Vec<BigInt>, q: Vec<BigInt>) -> Vec<Vec<BigInt>> {
    let (p, q) = if p.len() < q.len() { (q, p) } else { (p, q) };
    let leading = |p: &[BigInt]| p.last().map(Signed::abs).unwrap_or_default();
    let (mut lead, mut factor) = (BigInt::one(), BigInt::one());
    let mut chain = vec![p, q];
    while let [.., before, last] = &chain[..]
        && last.len() > 1
    {
        let fall = u32::try_from(before.len() - last.len()).unwrap_or(u32::MAX);
        let by = &lead * factor.pow(fall);
        let rest = pseudo_remainder(before.clone(), last);
        lead = leading(last);
        // g^δ/h^{δ−1}
        factor = if fall == 0 { factor } else { lead.pow(fall) / factor.pow(fall - 1) };
        chain.push(rest.into_iter().map(|c| -c / &by).collect());
    }
    chain
}

/// The remainder of |b|^{δ+1}·p by the divisor of the leading coefficient b, where δ is the difference of the degrees.
fn pseudo_remainder(mut p: Vec<BigInt>, divisor: &[BigInt]) -> Vec<BigInt> {
    let degree = divisor.len() - 1;
    let (lead, negative) = (divisor[degree].abs(), divisor[degree].is_negative());
    while p.len() > degree {
        let top = p.pop().unwrap_or_default();
        let top = if negative { -top } else { top };
        for c in &mut p {
            *c *= &lead;
        }
        let from = p.len() - degree;
        for (c, d) in p[from..].iter_mut().zip(divisor) {
            *c -= &top * d;
        }
    }
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

/// The positive multiple with integer coefficients without a common divisor, and without leading zeros.
fn whole(p: &[Q]) -> Vec<BigInt> {
    let p = trimmed(p.to_vec());
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
