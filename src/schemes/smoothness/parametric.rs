//! Symbols whose coefficients are polynomials in parameters.

use super::independence::{Dependence, dependence, exchanged};
use super::range_error::SmoothRangeError;
use super::symbol::over_sigma;
use super::transition::windows;
use crate::exact::{BivariatePolynomial, Integer, Rational, RationalPolynomial, Scalar};
use crate::scheme::Rules;

/// A square matrix of polynomials, row by row.
pub(crate) type PolynomialMatrix = Vec<Vec<RationalPolynomial>>;

/// The symbol of a mask in parameters, up to a power of z: with polynomials in one or in several.
#[derive(Clone, Debug)]
pub(in crate::smoothness) struct ParametricSymbol<P = RationalPolynomial> {
    arity: usize,
    coefficients: Vec<P>,
}

/// Polynomials in parameters over the rationals.
pub(in crate::smoothness) trait InParameters: Scalar + PartialEq {
    /// The coordinates of each of these in one basis: those of the first, those of the second, and so on.
    fn coordinates(all: &[Self]) -> Vec<Vec<Rational>>;
}

impl InParameters for RationalPolynomial {
    fn coordinates(all: &[Self]) -> Vec<Vec<Rational>> {
        let count = all.iter().filter_map(RationalPolynomial::degree).max().map_or(0, |d| d + 1);
        let padded = |p: &RationalPolynomial| {
            let mut coefficients = p.coefficients();
            coefficients.resize(count, Rational::zero());
            coefficients
        };
        all.iter().map(padded).collect()
    }
}

impl InParameters for BivariatePolynomial {
    fn coordinates(all: &[Self]) -> Vec<Vec<Rational>> {
        let degrees = [0, 1].map(|i| all.iter().map(|p| p.degrees()[i]).max().unwrap_or(0));
        let side = [Rational::zero(), Rational::one()];
        let bernstein = |p: &BivariatePolynomial| p.bernstein([&side, &side], degrees);
        all.iter().map(|p| bernstein(p).into_iter().flatten().collect()).collect()
    }
}

/// A symbol that polynomials g without parameters do not reduce further.
pub(in crate::smoothness) struct Reduced<P> {
    pub(in crate::smoothness) symbol: ParametricSymbol<P>,
    /// The polynomials, in the order of the steps.
    pub(in crate::smoothness) steps: Vec<Vec<Rational>>,
    /// Whether the roots of one are elements of cycles of z ↦ z^n, so that the convergence of the first symbol does not
    /// follow from that of the reduced one.
    pub(in crate::smoothness) cycles: bool,
}

impl<P: InParameters> ParametricSymbol<P> {
    /// This, for C^m, if σ divides it: reduced by all polynomials g over the rationals for which g(z^n) divides A·g for all
    /// values of the parameters, and for m = 0 by those for which it divides A. Then, for m > 0, the shifts are linearly
    /// independent, or as good as that, for all values but the zeros of a polynomial that is not 0:
    /// `proofs/THEOREMS.md`, 112 (c) and (d).
    pub(in crate::smoothness) fn reduced(&self, m: usize) -> Reduced<P> {
        let (n, mut symbol) = (self.arity, self.clone());
        let (mut steps, mut cycles) = (Vec::new(), false);
        if self.over_sigma().is_none() {
            return Reduced { symbol, steps, cycles };
        }
        loop {
            let coordinates = P::coordinates(&symbol.coefficients);
            let count = coordinates.first().map_or(0, Vec::len);
            let plane = |i: usize| coordinates.iter().map(|one| one[i].clone()).collect();
            let planes: Vec<Vec<Rational>> = (0..count).map(plane).collect();
            let found = dependence(&planes, n).filter(|found| m > 0 || !found.cycles);
            let found = found.and_then(|Dependence { g, cycles }| {
                let over: Vec<P> = g.iter().map(P::from_rational).collect();
                Some((exchanged(&symbol.coefficients, &over, n)?, g, cycles))
            });
            let Some((coefficients, g, on_cycles)) = found else {
                return Reduced { symbol, steps, cycles };
            };
            symbol = ParametricSymbol { arity: n, coefficients }.trimmed();
            steps.push(g);
            cycles |= on_cycles;
        }
    }

    /// n^mA/σ^k for k = 0, 1, … up to the order of the sum rules, which is m + 1 at least.
    pub(in crate::smoothness) fn scaled_differences(
        &self,
        m: usize,
        reduced: bool,
    ) -> Result<Vec<ParametricSymbol<P>>, SmoothRangeError> {
        let n = Rational::from(self.arity);
        let factor = (0..m).fold(Rational::one(), |power, _| power * &n);
        let all = std::iter::successors(Some(self.scaled(&factor)), ParametricSymbol::over_sigma);
        let all: Vec<ParametricSymbol<P>> = all.collect();
        let (found, needed) = (all.len() - 1, m.saturating_add(1));
        if found < needed {
            return Err(SmoothRangeError::SumRules { m, needed, found, reduced });
        }
        Ok(all)
    }
}

impl<P: Scalar + PartialEq> ParametricSymbol<P> {
    /// The symbol of these rules.
    pub(in crate::smoothness) fn of(rules: &Rules<P>) -> ParametricSymbol<P> {
        let places = (0..rules.width()).rev();
        let coefficients = places.flat_map(|j| rules.rows().iter().map(move |row| row[j].clone()));
        ParametricSymbol { arity: rules.arity(), coefficients: coefficients.collect() }.trimmed()
    }

    /// From the constant term upwards.
    pub(in crate::smoothness) fn coefficients(&self) -> &[P] {
        &self.coefficients
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

    /// The symbol over σ(z) = 1 + z + … + z^{n−1}, if σ divides it for every value of the parameter.
    pub(in crate::smoothness) fn over_sigma(&self) -> Option<ParametricSymbol<P>> {
        let coefficients = over_sigma(&self.coefficients, self.arity)?;
        Some(ParametricSymbol { arity: self.arity, coefficients }.trimmed())
    }

    /// This times a number.
    pub(in crate::smoothness) fn scaled(&self, factor: &Rational) -> ParametricSymbol<P> {
        let factor = P::from_rational(factor);
        let coefficients = self.coefficients.iter().map(|c| c.times(&factor)).collect();
        ParametricSymbol { arity: self.arity, coefficients }
    }

    /// Whether one of the n parts is a single coefficient 1: the scheme keeps the points of its data.
    pub(in crate::smoothness) fn is_interpolating(&self) -> bool {
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
    pub(in crate::smoothness) fn rules(&self) -> Rules<P> {
        let width = self.coefficients.len().div_ceil(self.arity).max(1);
        let zero = P::zero();
        let entry = |alpha: usize, j: usize| {
            self.coefficients.get(alpha + self.arity * (width - 1 - j)).unwrap_or(&zero).clone()
        };
        let row = |alpha| (0..width).map(|j| entry(alpha, j)).collect();
        Rules::new((0..self.arity).map(row).collect(), 0).expect("rules as long as those of a mask")
    }

    /// The matrices on windows, in the parameters.
    pub(in crate::smoothness) fn matrices(&self) -> Vec<Vec<Vec<P>>> {
        windows(&self.coefficients, self.arity, &P::zero())
    }
}

/// The matrices C_0, …, C_D of which a matrix of polynomials is the combination Σ_i C_i·b_i(t), with the
/// Bernstein polynomials b_i ≥ 0, Σ b_i = 1, where w = a + (b − a)t goes from a to b, and D is the degree.
pub(crate) fn bernstein(
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
pub(crate) fn multiplied<P: Scalar + PartialEq>(a: &[Vec<P>], b: &[Vec<P>]) -> Vec<Vec<P>> {
    let zero = P::zero();
    let entry = |row: &Vec<P>, j: usize| {
        let terms = row.iter().zip(b).filter(|(x, _)| **x != zero);
        terms.fold(P::zero(), |sum, (x, other)| sum.plus(&x.times(&other[j])))
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}
