//! The symbol of a mask.

use crate::exact::{Rational, Scalar};
use crate::scheme::{Mask, MaskError, Rules};
use std::fmt::Display;

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

impl<F: Scalar + PartialEq> Symbol<F> {
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

    /// The coefficient of z^`power`, 0 where there is none.
    #[must_use]
    pub fn coefficient(&self, power: i64) -> F {
        let place = usize::try_from(i128::from(power) - i128::from(self.lowest)).ok();
        place.and_then(|place| self.coefficients.get(place)).cloned().unwrap_or_else(F::zero)
    }

    /// The coefficients that are stored, each with its power.
    pub fn terms(&self) -> impl Iterator<Item = (i64, &F)> {
        (self.lowest..).zip(&self.coefficients)
    }

    /// The symbol of the inner products of basic limit functions: (1/n) a(z) b(1/z), of two symbols of arity n.
    ///
    /// With φ(x) = Σ_k a_k φ(nx − k) and ψ(x) = Σ_l b_l ψ(nx − l), the function g(y) = ∫ φ(x) ψ(x − y) dx satisfies g(y) =
    /// Σ_j c_j g(ny − j) with c_j = (1/n) Σ_{k−l=j} a_k b_l.
    ///
    /// # Panics
    /// When the arities differ.
    #[must_use]
    pub fn correlation(&self, other: &Symbol<F>) -> Symbol<F> {
        assert_eq!(self.arity, other.arity, "symbols of one arity");
        let (first, last) = (self.powers(), other.powers());
        let mut sums = vec![F::zero(); self.coefficients.len() + other.coefficients.len() - 1];
        let length = other.coefficients.len();
        for (k, a) in self.coefficients.iter().enumerate() {
            for (l, b) in other.coefficients.iter().enumerate() {
                sums[k + length - 1 - l].accumulate(&a.times(b));
            }
        }
        let over = F::from_rational(&Rational::from(self.arity).recip());
        let sums = sums.iter().map(|sum| sum.times(&over)).collect();
        Symbol::new(self.arity, first.0 - last.1, sums)
    }

    /// Whether Σ_k a_k b_{k+nm} is n for m = 0 and 0 for all other integers m: the condition for biorthogonal filters, which
    /// is that on an orthogonal filter if both are one symbol.
    ///
    /// ```
    /// use subcert::scheme::parse_scheme;
    /// use subcert::smoothness::Symbol;
    ///
    /// let symbol = |name| Ok::<_, subcert::scheme::SchemeError>(Symbol::of(parse_scheme(name)?.masks()[0]));
    /// let (haar, chaikin) = (symbol("haar")?, symbol("chaikin")?);
    /// assert!(haar.is_dual_to(&haar) && !chaikin.is_dual_to(&chaikin));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    ///
    /// # Panics
    /// When the arities differ.
    #[must_use]
    pub fn is_dual_to(&self, other: &Symbol<F>) -> bool {
        let n = i64::try_from(self.arity).expect("a small arity");
        let products = self.correlation(other);
        let of_multiples = products.terms().filter(|(power, c)| power % n == 0 && **c != F::zero());
        let one = F::from_rational(&Rational::one());
        let mut of_multiples = of_multiples.map(|(power, c)| power == 0 && *c == one);
        of_multiples.next() == Some(true) && of_multiples.next().is_none()
    }

    /// The mask with this symbol, at the least offset: −⌊K/n⌋ for the highest power K.
    ///
    /// # Errors
    /// When a rule does not sum to 1, or has too many coefficients.
    ///
    /// # Panics
    /// Never.
    pub fn mask(&self) -> Result<Mask<F>, MaskError>
    where
        F: Display,
    {
        let n = i64::try_from(self.arity).expect("a small arity");
        let (rows, offset) =
            Rules::rows_of_symbol(n, self.powers(), |power| self.coefficient(power));
        Mask::new(rows, offset)
    }
}

/// The coefficients of p(z)b(z^s), of p and b not empty: of one level more, if s is n to the number of those in p.
pub(super) fn with_level<F: Scalar>(p: &[F], b: &[F], s: usize) -> Vec<F> {
    let mut product = vec![F::zero(); p.len() + (b.len() - 1) * s];
    for (i, factor) in b.iter().enumerate() {
        for (k, value) in p.iter().enumerate() {
            product[i * s + k].accumulate(&factor.times(value));
        }
    }
    product
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
