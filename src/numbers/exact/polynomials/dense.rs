//! Polynomials over a field, as the lists of their coefficients from the constant term upwards.

use crate::exact::{Rational, Real};

/// Without the coefficients 0 at the end.
pub(crate) fn trimmed<F: Real + PartialEq>(mut p: Vec<F>) -> Vec<F> {
    let zero = F::zero();
    let length = p.iter().rposition(|c| *c != zero).map_or(0, |last| last + 1);
    p.truncate(length);
    p
}

/// The value at `x`.
pub fn value_at<F: Real>(p: &[F], x: &F) -> F {
    p.iter().rev().fold(F::zero(), |value, c| value.times(x).plus(c))
}

/// The quotient and the remainder of p by q, whose last coefficient is not 0.
///
/// # Panics
/// When q is empty.
pub fn divided<F: Real + PartialEq>(p: &[F], q: &[F]) -> (Vec<F>, Vec<F>) {
    let (leading, lower) = q.split_last().expect("division by zero");
    let mut rest = p.to_vec();
    let mut quotient = vec![F::zero(); rest.len().saturating_sub(lower.len())];
    let inverse = F::from_rational(&Rational::one()).over(leading);
    for shift in (0..quotient.len()).rev() {
        let factor = rest.pop().expect("as long as shift + divisor").times(&inverse);
        for (x, c) in rest[shift..].iter_mut().zip(lower) {
            x.lessen(&factor.times(c));
        }
        quotient[shift] = factor;
    }
    (quotient, trimmed(rest))
}

/// The monic greatest common divisor; empty for two polynomials 0.
pub fn greatest_divisor<F: Real + PartialEq>(p: &[F], q: &[F]) -> Vec<F> {
    let (mut a, mut b) = (monic(trimmed(p.to_vec())), monic(trimmed(q.to_vec())));
    while !b.is_empty() {
        let rest = monic(divided(&a, &b).1);
        (a, b) = (b, rest);
    }
    a
}

fn monic<F: Real + PartialEq>(mut p: Vec<F>) -> Vec<F> {
    if let Some(leading) = p.last() {
        let inverse = F::from_rational(&Rational::one()).over(leading);
        for c in &mut p {
            *c = c.times(&inverse);
        }
    }
    p
}

/// The polynomial with the same roots, each of them simple.
pub fn square_free<F: Real + PartialEq>(p: &[F]) -> Vec<F> {
    let p = trimmed(p.to_vec());
    let common = greatest_divisor(&p, &derivative(&p));
    if common.len() <= 1 { p } else { divided(&p, &common).0 }
}

/// The derivative.
pub(crate) fn derivative<F: Real>(p: &[F]) -> Vec<F> {
    (1..p.len()).map(|i| p[i].times(&F::from_rational(&Rational::from(i)))).collect()
}

/// p(x^n).
pub fn stretched<F: Real>(p: &[F], n: usize) -> Vec<F> {
    let mut stretched = Vec::new();
    for c in p {
        stretched.resize(stretched.len().next_multiple_of(n), F::zero());
        stretched.push(c.clone());
    }
    stretched
}

/// p(q(z)) for a polynomial q.
pub(crate) fn composed<F: Real>(p: &[F], q: &[F]) -> Vec<F> {
    p.iter().rev().fold(Vec::new(), |value, c| {
        let mut next = product(&value, q);
        match next.first_mut() {
            Some(first) => first.accumulate(c),
            None => next.push(c.clone()),
        }
        next
    })
}

/// The product.
pub(crate) fn product<F: Real>(p: &[F], q: &[F]) -> Vec<F> {
    let mut product = vec![F::zero(); (p.len() + q.len()).saturating_sub(1)];
    if p.is_empty() {
        return Vec::new();
    }
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j].accumulate(&a.times(b));
        }
    }
    product
}
