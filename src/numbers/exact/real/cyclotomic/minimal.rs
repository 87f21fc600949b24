//! The minimal polynomial of a number.

use super::field::Field;
use super::number::{Element, Form, RealCyclotomic};
use super::symmetric::{prime_divisors, totient};
use crate::exact::{Enclosed, Integer, IntegerPolynomial, RealAlgebraic, SturmSequence};
use std::sync::Arc;

impl RealCyclotomic {
    /// The minimal polynomial over the rationals, as a primitive integer polynomial
    /// with positive leading coefficient.
    ///
    /// Its degree d is the number of distinct conjugates, which is determined exactly.
    /// Its coefficients follow by Newton's identities from the power sums of the
    /// conjugates, and the power sums are traces. The cost is d products in the field.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealCyclotomic};
    ///
    /// let cosine = RealCyclotomic::cosine(&Rational::new(1, 5))?;
    /// assert_eq!(cosine.minimal_polynomial().to_string(), "4x^2 + 2x - 1");
    /// # Ok::<(), subcert::exact::CosineError>(())
    /// ```
    #[must_use]
    pub fn minimal_polynomial(&self) -> IntegerPolynomial {
        match &self.0 {
            Form::Rational(value) => {
                IntegerPolynomial::from([-value.numerator(), value.denominator()])
            }
            Form::Irrational(element) => element.minimal_polynomial(),
        }
    }
}

impl Element {
    /// For the number f/q: Σ_i (−1)^i e_i (qx)^{d−i}, made primitive, where e_i is the
    /// i-th elementary symmetric function of the conjugates of f.
    fn minimal_polynomial(&self) -> IntegerPolynomial {
        let degree = self.conjugate_count();
        let symmetric = elementary(&self.power_sums(degree));
        let mut scale = Integer::one();
        let mut coefficients = vec![Integer::zero(); degree + 1];
        for (exponent, coefficient) in coefficients.iter_mut().enumerate() {
            let i = degree - exponent;
            let value = &symmetric[i] * &scale;
            *coefficient = if i % 2 == 1 { -value } else { value };
            scale *= &self.denominator;
        }
        IntegerPolynomial::new(coefficients).primitive()
    }

    /// The number of distinct conjugates: m divided by the order of the stabiliser in the
    /// Galois group (Z/n)*/±1.
    fn conjugate_count(&self) -> usize {
        let n = self.field.conductor();
        let group = (1..=n / 2).filter(|&a| num_integer::gcd(a, n) == 1);
        let fixing =
            group.filter(|&a| self.field.conjugate(&self.numerators, a) == self.numerators);
        self.field.degree() / fixing.count()
    }

    /// p_1, …, p_count, where the integer p_i is the sum of the i-th powers of the
    /// `count` distinct conjugates of f.
    fn power_sums(&self, count: usize) -> Vec<Integer> {
        let traces = traces(&self.field);
        let scale = Integer::from(self.field.degree() / count);
        let mut power = self.numerators.clone();
        let mut sums = Vec::with_capacity(count);
        for i in 0..count {
            if i > 0 {
                power = self.field.multiply(&power, &self.numerators);
            }
            let trace: Integer = power.iter().zip(&traces).map(|(a, trace)| a * trace).sum();
            sums.push(trace.div_floor(&scale));
        }
        sums
    }
}

/// The traces over Q of 1, C_1, …, C_{m−1}: the trace of 1 is m, and that of C_k is
/// Ramanujan's sum μ(h)·φ(n)/φ(h) with h = n/gcd(n, k).
fn traces(field: &Field) -> Vec<Integer> {
    let n = field.conductor();
    let trace = |k: usize| {
        if k == 0 {
            return Integer::from(field.degree());
        }
        let h = n / num_integer::gcd(n, k);
        let primes = prime_divisors(h);
        if primes.iter().product::<usize>() != h {
            return Integer::zero();
        }
        let size = Integer::from(totient(n) / totient(h));
        if primes.len() % 2 == 1 { -size } else { size }
    };
    (0..field.degree()).map(trace).collect()
}

/// e_0, …, e_d from p_1, …, p_d: i·e_i = Σ_{j=1}^i (−1)^{j−1} e_{i−j} p_j.
fn elementary(sums: &[Integer]) -> Vec<Integer> {
    let mut elementary = vec![Integer::one()];
    for i in 1..=sums.len() {
        let mut total = Integer::zero();
        for j in 1..=i {
            let term = &elementary[i - j] * &sums[j - 1];
            if j % 2 == 1 {
                total += &term;
            } else {
                total -= &term;
            }
        }
        elementary.push(total.div_floor(&Integer::from(i)));
    }
    elementary
}

impl From<&RealCyclotomic> for RealAlgebraic {
    /// This number as a root of its minimal polynomial.
    fn from(value: &RealCyclotomic) -> RealAlgebraic {
        if let Some(value) = value.as_rational() {
            return RealAlgebraic::from(value.clone());
        }
        let polynomial = value.minimal_polynomial();
        let sturm = SturmSequence::new(&polynomial);
        let mut level = 0;
        loop {
            let enclosure = value.enclosure(level);
            let (lower, upper) = (enclosure.lower().clone(), enclosure.upper().clone());
            if sturm.count_roots(&lower, &upper) == 1 {
                return RealAlgebraic::isolated(&Arc::new(polynomial), lower, upper);
            }
            level += 1;
        }
    }
}
