//! Polynomials over the rationals in named variables.

use super::Rational;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Sub};

/// Variables with their exponents, all positive; empty for the constant term.
type Monomial = BTreeMap<String, u32>;

/// A polynomial over Q in named variables, in normal form: two polynomials are
/// equal exactly when they agree as functions.
///
/// ```
/// use subcert::exact::Polynomial;
///
/// let w = Polynomial::variable("w");
/// let square = &(&w + &w) * &w;
/// assert_eq!(square.to_string(), "2*w^2");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Polynomial {
    /// No coefficient is 0.
    terms: BTreeMap<Monomial, Rational>,
}

impl Polynomial {
    /// The constant `value`.
    #[must_use]
    pub fn constant(value: Rational) -> Polynomial {
        Polynomial::monomial(Monomial::new(), value)
    }

    /// The variable `name`.
    #[must_use]
    pub fn variable(name: &str) -> Polynomial {
        Polynomial::monomial(Monomial::from([(name.to_owned(), 1)]), Rational::one())
    }

    fn monomial(monomial: Monomial, coefficient: Rational) -> Polynomial {
        if coefficient.is_zero() {
            return Polynomial::default();
        }
        Polynomial { terms: BTreeMap::from([(monomial, coefficient)]) }
    }

    /// The value of a constant polynomial; `None` when a variable remains.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::zero()),
            1 => self.terms.get(&Monomial::new()).cloned(),
            _ => None,
        }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The number of terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// The greatest sum of exponents in a term; 0 for a constant.
    #[must_use]
    pub fn degree(&self) -> u64 {
        let degree = |monomial: &Monomial| monomial.values().map(|&e| u64::from(e)).sum();
        self.terms.keys().map(degree).max().unwrap_or(0)
    }

    /// The number of binary digits of all coefficients together.
    #[must_use]
    pub fn bits(&self) -> u64 {
        self.terms.values().map(Rational::bits).sum()
    }

    fn add_term(&mut self, monomial: Monomial, coefficient: &Rational) {
        if coefficient.is_zero() {
            return;
        }
        let sum = match self.terms.get(&monomial) {
            Some(present) => present + coefficient,
            None => coefficient.clone(),
        };
        if sum.is_zero() {
            self.terms.remove(&monomial);
        } else {
            self.terms.insert(monomial, sum);
        }
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.terms {
            sum.add_term(monomial.clone(), coefficient);
        }
        sum
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        let mut difference = self.clone();
        for (monomial, coefficient) in &other.terms {
            difference.add_term(monomial.clone(), &-coefficient);
        }
        difference
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        let mut product = Polynomial::default();
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                let mut monomial = left.clone();
                for (variable, exponent) in right {
                    let sum = monomial.entry(variable.clone()).or_insert(0);
                    *sum = sum.checked_add(*exponent).expect("an exponent below 2^32");
                }
                product.add_term(monomial, &(a * b));
            }
        }
        product
    }
}

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.pad("0");
        }
        let mut text = String::new();
        for (monomial, coefficient) in &self.terms {
            let negative = coefficient.sign() < 0;
            text.push_str(match (text.is_empty(), negative) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            });
            let magnitude = coefficient.abs();
            let mut factors = Vec::new();
            if monomial.is_empty() || magnitude != Rational::one() {
                factors.push(magnitude.to_string());
            }
            for (variable, exponent) in monomial {
                factors.push(match exponent {
                    1 => variable.clone(),
                    _ => format!("{variable}^{exponent}"),
                });
            }
            text.push_str(&factors.join("*"));
        }
        f.pad(&text)
    }
}
