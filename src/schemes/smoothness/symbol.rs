//! The symbol of a mask.

use crate::exact::{Rational, Scalar};
use crate::joint::Entry;
use crate::scheme::{Mask, Rules};

/// z^lowest·P(z), P a polynomial with P(0) ≠ 0: the symbol of a scheme of arity n.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::Symbol;
///
/// let chaikin = Symbol::of(parse_scheme("chaikin")?.masks()[0]);
/// let (order, rest) = chaikin.sum_rules();
/// assert_eq!((order, rest.coefficients()), (3, &[Rational::new(1, 4)][..]));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol<F = Rational> {
    arity: usize,
    lowest: i64,
    /// From the constant term of P upwards; neither the first nor the last is 0.
    coefficients: Vec<F>,
}

impl<F: Entry> Symbol<F> {
    /// The symbol of a mask: a_{α,j} is the coefficient of z^{α − n(o+j)}.
    ///
    /// # Panics
    /// Never: an offset is far from the ends of its type.
    #[must_use]
    pub fn of(mask: &Mask<F>) -> Symbol<F> {
        let arity = mask.arity();
        let n = i64::try_from(arity).expect("a small arity");
        let width = i64::try_from(mask.width()).expect("a small width");
        // The power of the last coefficient of the first rule is the lowest.
        let lowest = -n * (mask.offset() + width - 1);
        let mut coefficients = Vec::with_capacity(arity * mask.width());
        for j in (0..mask.width()).rev() {
            coefficients.extend(mask.rules().rows().iter().map(|row| row[j].clone()));
        }
        Symbol::new(arity, lowest, coefficients)
    }

    /// z^lowest·P(z), with the power of z in P taken out.
    pub(super) fn new(arity: usize, lowest: i64, mut coefficients: Vec<F>) -> Symbol<F> {
        let zero = F::zero();
        let length = coefficients.iter().rposition(|c| *c != zero).map_or(0, |last| last + 1);
        coefficients.truncate(length);
        let zeros = coefficients.iter().take_while(|c| **c == zero).count();
        coefficients.drain(..zeros);
        let zeros = i64::try_from(zeros).expect("it fits in memory");
        Symbol { arity, lowest: lowest + zeros, coefficients }
    }

    /// n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// The coefficients of P, from the constant term upwards.
    #[must_use]
    pub fn coefficients(&self) -> &[F] {
        &self.coefficients
    }

    /// The powers of z of the first and the last coefficient.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn powers(&self) -> (i64, i64) {
        let degree = self.coefficients.len().saturating_sub(1);
        (self.lowest, self.lowest + i64::try_from(degree).expect("it fits in memory"))
    }

    /// The support of the basic limit function φ, φ(t) = Σ a_s φ(nt − s): the powers of the symbol over
    /// n − 1.
    #[must_use]
    pub fn support(&self) -> (Rational, Rational) {
        let (low, high) = self.powers();
        let over = |power| Rational::from(power) / Rational::from(self.arity - 1);
        (over(low), over(high))
    }

    /// The order K of the sum rules, and B with A = σ^K B.
    #[must_use]
    pub fn sum_rules(&self) -> (usize, Symbol<F>) {
        let (mut order, mut rest) = (0, self.coefficients.clone());
        while let Some(next) = over_sigma(&rest, self.arity) {
            (order, rest) = (order + 1, next);
        }
        (order, Symbol::new(self.arity, self.lowest, rest))
    }

    /// A/σ^k times `factor`; `None` where the order of the sum rules is less than k.
    #[must_use]
    pub fn difference(&self, k: usize, factor: &Rational) -> Option<Symbol<F>> {
        let start = self.coefficients.clone();
        let rest = (0..k).try_fold(start, |rest, _| over_sigma(&rest, self.arity))?;
        let factor = F::from_rational(factor);
        let rest = rest.iter().map(|c| c.times(&factor)).collect();
        Some(Symbol::new(self.arity, self.lowest, rest))
    }

    /// The rules of this symbol, at the offset of its lowest power up to a shift of the data.
    ///
    /// # Panics
    /// Never: a mask has no longer rules.
    #[must_use]
    pub fn rules(&self) -> Rules<F> {
        let width = self.coefficients.len().div_ceil(self.arity).max(1);
        let entry = |alpha: usize, j: usize| {
            let place = alpha + self.arity * (width - 1 - j);
            self.coefficients.get(place).cloned().unwrap_or_else(F::zero)
        };
        let row = |alpha| (0..width).map(|j| entry(alpha, j)).collect();
        Rules::new((0..self.arity).map(row).collect(), 0).expect("rules as long as those of a mask")
    }
}

/// p/σ, σ(z) = 1 + z + … + z^{n−1}, if σ divides p ≠ 0.
pub(super) fn over_sigma<F: Scalar + PartialEq>(p: &[F], n: usize) -> Option<Vec<F>> {
    let count = (p.len() + 1).checked_sub(n).filter(|count| *count > 0)?;
    let mut rest = p.to_vec();
    let mut quotient = Vec::with_capacity(count);
    for i in 0..count {
        let c = rest[i].clone();
        rest[i..i + n].iter_mut().for_each(|x| x.lessen(&c));
        quotient.push(c);
    }
    let zero = F::zero();
    rest.iter().all(|x| *x == zero).then_some(quotient)
}
