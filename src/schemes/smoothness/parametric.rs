//! Symbols whose coefficients are polynomials in parameters.

use super::independence::independent;
use super::symbol::Symbol;
use super::transition::windows;
use crate::exact::{Integer, Rational, RationalPolynomial, Scalar};
use crate::scheme::Rules;

/// The values at which the independence of shifts is tried. They are no special ones.
const PROBES: [[(i64, i64); 2]; 4] =
    [[(3, 17), (5, 19)], [(-7, 23), (11, 29)], [(13, 7), (-17, 11)], [(-31, 13), (-37, 17)]];

/// A square matrix of polynomials, row by row.
pub(super) type PolynomialMatrix = Vec<Vec<RationalPolynomial>>;

/// The symbol of a mask in parameters, up to a power of z: with polynomials in one or in several.
#[derive(Clone, Debug)]
pub struct ParametricSymbol<P = RationalPolynomial> {
    arity: usize,
    coefficients: Vec<P>,
}

impl<P: Scalar + PartialEq> ParametricSymbol<P> {
    /// The symbol of these rules.
    #[must_use]
    pub fn of(rules: &Rules<P>) -> ParametricSymbol<P> {
        let places = (0..rules.width()).rev();
        let coefficients = places.flat_map(|j| rules.rows().iter().map(move |row| row[j].clone()));
        ParametricSymbol { arity: rules.arity(), coefficients: coefficients.collect() }.trimmed()
    }

    fn trimmed(mut self) -> ParametricSymbol<P> {
        let zero = P::zero();
        while self.coefficients.last() == Some(&zero) {
            self.coefficients.pop();
        }
        let zeros = self.coefficients.iter().take_while(|c| **c == zero).count();
        self.coefficients.drain(..zeros);
        self
    }

    /// n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// The symbol over σ(z) = 1 + z + … + z^{n−1}, if σ divides it for every value of the parameter.
    #[must_use]
    pub fn over_sigma(&self) -> Option<ParametricSymbol<P>> {
        let n = self.arity;
        let mut rest = self.coefficients.clone();
        let count = (rest.len() + 1).checked_sub(n)?;
        let mut quotient = Vec::with_capacity(count);
        for i in 0..count {
            let c = rest[i].clone();
            rest[i..i + n].iter_mut().for_each(|x| x.lessen(&c));
            quotient.push(c);
        }
        let zero = P::zero();
        let divides = count > 0 && rest.iter().all(|x| *x == zero);
        divides.then(|| ParametricSymbol { arity: n, coefficients: quotient }.trimmed())
    }

    /// This times a number.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> ParametricSymbol<P> {
        let factor = P::from_rational(factor);
        let coefficients = self.coefficients.iter().map(|c| c.times(&factor)).collect();
        ParametricSymbol { arity: self.arity, coefficients }
    }

    /// The symbol with the values of the coefficients.
    pub(super) fn value(&self, value: impl Fn(&P) -> Rational) -> Symbol {
        Symbol::new(self.arity, 0, self.coefficients.iter().map(value).collect())
    }

    /// Whether the shifts of the basic limit function are linearly independent for all values of the parameters but the
    /// zeros of a polynomial that is not 0; `value` gives a coefficient at two values. One probe shows it, at which
    /// neither end of the symbol vanishes: `proofs/THEOREMS.md`, 112 (c).
    pub(super) fn is_independent(&self, value: impl Fn(&P, [&Rational; 2]) -> Rational) -> bool {
        PROBES.iter().any(|[one, other]| {
            let [one, other] = [one, other].map(|(top, bottom)| Rational::new(*top, *bottom));
            let at = self.value(|c| value(c, [&one, &other]));
            at.coefficients().len() == self.coefficients.len() && independent(&at) == at
        })
    }

    /// Whether one of the n parts is a single coefficient 1: the scheme keeps the points of its data.
    #[must_use]
    pub fn is_interpolating(&self) -> bool {
        let (zero, one) = (P::zero(), P::from_rational(&Rational::one()));
        (0..self.arity).any(|e| {
            let part = self.coefficients.iter().skip(e).step_by(self.arity);
            part.filter(|c| **c != zero).eq([&one])
        })
    }

    /// The rules of the symbol.
    ///
    /// # Panics
    /// Never: a mask has no longer rules.
    #[must_use]
    pub fn rules(&self) -> Rules<P> {
        let width = self.coefficients.len().div_ceil(self.arity).max(1);
        let zero = P::zero();
        let entry = |alpha: usize, j: usize| {
            self.coefficients.get(alpha + self.arity * (width - 1 - j)).unwrap_or(&zero).clone()
        };
        let row = |alpha| (0..width).map(|j| entry(alpha, j)).collect();
        Rules::new((0..self.arity).map(row).collect(), 0).expect("rules as long as those of a mask")
    }

    /// The matrices on windows, in the parameters.
    pub(super) fn matrices(&self) -> Vec<Vec<Vec<P>>> {
        windows(&self.coefficients, self.arity, &P::zero())
    }
}

impl ParametricSymbol {
    /// The symbol at a value of the parameter.
    #[must_use]
    pub fn at(&self, value: &Rational) -> Symbol {
        self.value(|c| c.value_at(value))
    }
}

/// The matrices C_0, …, C_D of which a matrix of polynomials is the combination Σ_i C_i·b_i(t), with the
/// Bernstein polynomials b_i ≥ 0, Σ b_i = 1, where w = a + (b − a)t goes from a to b, and D is the degree.
pub(super) fn bernstein(
    matrix: &PolynomialMatrix,
    degree: usize,
    (a, b): (&Rational, &Rational),
) -> Vec<Vec<Vec<Rational>>> {
    let line = RationalPolynomial::new(&[a.clone(), b - a]);
    let entry = |p: &RationalPolynomial| -> Vec<Rational> {
        let zero = RationalPolynomial::constant(Rational::zero());
        let terms = p.coefficients().into_iter().rev();
        let moved =
            terms.fold(zero, |value, c| value.times(&line).plus(&RationalPolynomial::constant(c)));
        let c = moved.coefficients();
        let weight = |i: usize, k: usize| Rational::new(choose(i, k), choose(degree, k));
        let sum = |i: usize| c.iter().enumerate().take(i + 1).map(|(k, c)| c * weight(i, k)).sum();
        (0..=degree).map(sum).collect()
    };
    let all: Vec<Vec<Vec<Rational>>> =
        matrix.iter().map(|row| row.iter().map(entry).collect()).collect();
    let pick =
        |i: usize| all.iter().map(|row| row.iter().map(|c| c[i].clone()).collect()).collect();
    (0..=degree).map(pick).collect()
}

fn choose(top: usize, bottom: usize) -> Integer {
    let small = |x| u32::try_from(x).expect("a low degree");
    Integer::binomial(small(top), small(bottom))
}

/// AB.
pub(super) fn multiplied<P: Scalar + PartialEq>(a: &[Vec<P>], b: &[Vec<P>]) -> Vec<Vec<P>> {
    let zero = P::zero();
    let entry = |row: &Vec<P>, j: usize| {
        let terms = row.iter().zip(b).filter(|(x, _)| **x != zero);
        terms.fold(P::zero(), |sum, (x, other)| sum.plus(&x.times(&other[j])))
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}
