//! The symbol of a mask.

use crate::exact::{Integer, IntegerPolynomial, Rational, RationalPolynomial};
use crate::scheme::{Mask, Rules};

/// z^lowest·P(z), P a polynomial with P(0) ≠ 0: the symbol of a scheme of arity n.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::Symbol;
///
/// let chaikin = Symbol::of(parse_scheme("chaikin")?.masks()[0]);
/// let (order, rest) = chaikin.sum_rules();
/// assert_eq!((order, rest.polynomial().describe("z")), (3, "1/4".to_owned()));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    arity: usize,
    lowest: i64,
    polynomial: RationalPolynomial,
}

impl Symbol {
    /// The symbol of a mask: a_{α,j} is the coefficient of z^{α − n(o+j)}.
    ///
    /// # Panics
    /// Never: an offset is far from the ends of its type.
    #[must_use]
    pub fn of(mask: &Mask) -> Symbol {
        let arity = mask.arity();
        let n = i64::try_from(arity).expect("a small arity");
        let width = i64::try_from(mask.width()).expect("a small width");
        // The power of the last coefficient of the first rule is the lowest.
        let lowest = -n * (mask.offset() + width - 1);
        let mut coefficients = Vec::with_capacity(arity * mask.width());
        for j in (0..mask.width()).rev() {
            coefficients.extend(mask.rules().rows().iter().map(|row| row[j].clone()));
        }
        Symbol::new(arity, lowest, &RationalPolynomial::new(&coefficients))
    }

    /// z^lowest·P(z), with the power of z in P taken out.
    pub(super) fn new(arity: usize, lowest: i64, polynomial: &RationalPolynomial) -> Symbol {
        let coefficients = polynomial.coefficients();
        let zeros = coefficients.iter().take_while(|c| c.is_zero()).count();
        let polynomial = RationalPolynomial::new(&coefficients[zeros..]);
        let zeros = i64::try_from(zeros).expect("it fits in memory");
        Symbol { arity, lowest: lowest + zeros, polynomial }
    }

    /// n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// P.
    #[must_use]
    pub fn polynomial(&self) -> &RationalPolynomial {
        &self.polynomial
    }

    /// The powers of z of the first and the last coefficient.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn powers(&self) -> (i64, i64) {
        let degree = self.polynomial.degree().unwrap_or(0);
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
    pub fn sum_rules(&self) -> (usize, Symbol) {
        let sigma = IntegerPolynomial::new(vec![Integer::one(); self.arity]);
        let (mut order, mut rest) = (0, self.polynomial.clone());
        while let Some(next) = quotient(&rest, &sigma) {
            (order, rest) = (order + 1, next);
        }
        (order, Symbol::new(self.arity, self.lowest, &rest))
    }

    /// A/σ^k times `factor`; `None` where the order of the sum rules is less than k.
    #[must_use]
    pub fn difference(&self, k: usize, factor: &Rational) -> Option<Symbol> {
        let sigma = IntegerPolynomial::new(vec![Integer::one(); self.arity]);
        let rest = (0..k).try_fold(self.polynomial.clone(), |rest, _| quotient(&rest, &sigma))?;
        let rest = rest.times(&RationalPolynomial::constant(factor.clone()));
        Some(Symbol::new(self.arity, self.lowest, &rest))
    }

    /// The rules of this symbol, at the offset of its lowest power up to a shift of the data.
    ///
    /// # Panics
    /// Never: a mask has no longer rules.
    #[must_use]
    pub fn rules(&self) -> Rules {
        let coefficients = self.polynomial.coefficients();
        let width = coefficients.len().div_ceil(self.arity).max(1);
        let entry = |alpha: usize, j: usize| {
            let place = alpha + self.arity * (width - 1 - j);
            coefficients.get(place).cloned().unwrap_or_else(Rational::zero)
        };
        let row = |alpha| (0..width).map(|j| entry(alpha, j)).collect();
        Rules::new((0..self.arity).map(row).collect(), 0).expect("rules as long as those of a mask")
    }
}

/// p/q, if q divides p.
pub(super) fn quotient(
    p: &RationalPolynomial,
    q: &IntegerPolynomial,
) -> Option<RationalPolynomial> {
    if p.is_zero() {
        return None;
    }
    let (scale, quotient, rest) = p.numerator().div_rem(q);
    if !rest.is_zero() {
        return None;
    }
    // p is a constant times its numerator.
    let whole = Rational::from(p.numerator().leading());
    let factor = p.coefficients().pop().unwrap_or_else(Rational::one) / whole;
    let over = RationalPolynomial::over(&quotient, &scale);
    Some(over.times(&RationalPolynomial::constant(factor)))
}
