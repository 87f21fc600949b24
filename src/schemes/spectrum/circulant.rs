//! Circulant matrices as polynomials in the rotation.

use crate::exact::{Rational, RealCyclotomic, Scalar};
use std::collections::BTreeMap;

/// Σ_d a_d z^d, d = 0, …, n−1, modulo z^n = 1: the circulant matrix with the entries m_{i,j} = a_{j−i}.
/// On the vectors ω^{kj}, ω = e^{2πi/n}, it acts as the number Σ_d a_d ω^{kd}.
#[derive(Clone, Debug)]
pub(super) struct Circulant {
    /// n; 0 for a multiple of the identity that has met no other.
    order: usize,
    terms: BTreeMap<usize, RealCyclotomic>,
}

impl Circulant {
    /// The sum of these terms (d, a_d).
    pub(super) fn new(
        order: usize,
        terms: impl IntoIterator<Item = (usize, RealCyclotomic)>,
    ) -> Circulant {
        let mut sum = Circulant { order, terms: BTreeMap::new() };
        terms.into_iter().for_each(|(d, value)| sum.add(d % order, &value));
        sum
    }

    fn add(&mut self, d: usize, value: &RealCyclotomic) {
        let target = self.terms.entry(d).or_insert_with(RealCyclotomic::zero);
        target.accumulate(value);
        if target.sign() == 0 {
            self.terms.remove(&d);
        }
    }

    /// The (d, a_d) with a_d ≠ 0.
    pub(super) fn terms(&self) -> impl Iterator<Item = (usize, &RealCyclotomic)> {
        self.terms.iter().map(|(d, value)| (*d, value))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether a_d = a_{n−d} for all d, so that Σ a_d ω^{kd} is real for all k.
    pub(super) fn is_even(&self) -> bool {
        let mirrored = |d: usize| if d == 0 { 0 } else { self.order.saturating_sub(d) };
        self.terms().all(|(d, value)| self.terms.get(&mirrored(d)) == Some(value))
    }

    /// Σ_d a_d cos(2πkd/n), where `cosines` are cos(2πj/n) for j = 0, …, n−1.
    pub(super) fn real_part(&self, k: usize, cosines: &[RealCyclotomic]) -> RealCyclotomic {
        let mut sum = RealCyclotomic::zero();
        for (d, value) in self.terms() {
            sum.accumulate(&value.times(&cosines[d * k % cosines.len()]));
        }
        sum
    }
}

impl Scalar for Circulant {
    fn from_rational(value: &Rational) -> Self {
        let mut constant = Circulant { order: 0, terms: BTreeMap::new() };
        constant.add(0, &RealCyclotomic::from(value.clone()));
        constant
    }
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.accumulate(other);
        sum
    }
    fn accumulate(&mut self, other: &Self) {
        self.order = self.order.max(other.order);
        for (d, value) in other.terms() {
            self.add(d, value);
        }
    }
    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.times(&Circulant::from_rational(&Rational::from(-1))))
    }
    fn times(&self, other: &Self) -> Self {
        let order = self.order.max(other.order);
        let mut product = Circulant { order, terms: BTreeMap::new() };
        for (i, a) in self.terms() {
            for (j, b) in other.terms() {
                let d = if order == 0 { 0 } else { (i + j) % order };
                product.add(d, &a.times(b));
            }
        }
        product
    }
}
