//! Polynomials over the real cyclotomic numbers in named variables.

use super::{Rational, RationalPolynomial, RealCyclotomic, Scalar};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Sub};

/// Variables with their exponents, all positive; empty for the constant term.
type Monomial = BTreeMap<String, u32>;

/// A polynomial in named variables over the fields Q(2cos(2π/n)), in normal form:
/// two polynomials are equal exactly when they agree as functions.
///
/// The coefficients of all polynomials that are brought together need a
/// [`common_conductor`](super::common_conductor).
///
/// ```
/// use subcert::exact::{Polynomial, Rational, RealCyclotomic};
///
/// let w = Polynomial::variable("w");
/// let square = &(&w + &w) * &w;
/// assert_eq!(square.to_string(), "2*w^2");
///
/// let cosine = Polynomial::constant(RealCyclotomic::cosine(&Rational::new(1, 5))?);
/// assert_eq!((&cosine * &w).to_string(), "(cos(2*pi/5))*w");
/// # Ok::<(), subcert::exact::CosineError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Polynomial {
    /// No coefficient is 0.
    terms: BTreeMap<Monomial, RealCyclotomic>,
}

impl Polynomial {
    /// The constant `value`.
    #[must_use]
    pub fn constant(value: impl Into<RealCyclotomic>) -> Polynomial {
        Polynomial::monomial(Monomial::new(), value.into())
    }

    /// The variable `name`.
    #[must_use]
    pub fn variable(name: &str) -> Polynomial {
        Polynomial::monomial(Monomial::from([(name.to_owned(), 1)]), RealCyclotomic::from(1))
    }

    fn monomial(monomial: Monomial, coefficient: RealCyclotomic) -> Polynomial {
        if is_zero(&coefficient) {
            return Polynomial::default();
        }
        Polynomial { terms: BTreeMap::from([(monomial, coefficient)]) }
    }

    /// The value of a constant polynomial; `None` when a variable remains.
    #[must_use]
    pub fn as_constant(&self) -> Option<RealCyclotomic> {
        match self.terms.len() {
            0 => Some(RealCyclotomic::zero()),
            1 => self.terms.get(&Monomial::new()).cloned(),
            _ => None,
        }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// This as a polynomial in `variable` over the rationals; `None` when another
    /// variable or an irrational coefficient remains.
    ///
    /// ```
    /// use subcert::exact::Polynomial;
    ///
    /// let (v, w) = (Polynomial::variable("v"), Polynomial::variable("w"));
    /// assert_eq!((&w * &w).in_variable("w").and_then(|p| p.degree()), Some(2));
    /// assert_eq!((&v * &w).in_variable("w"), None);
    /// ```
    #[must_use]
    pub fn in_variable(&self, variable: &str) -> Option<RationalPolynomial> {
        let mut coefficients = Vec::new();
        for (monomial, coefficient) in &self.terms {
            let exponent = monomial.get(variable).copied().unwrap_or(0);
            if monomial.len() > usize::from(exponent > 0) {
                return None;
            }
            let place = usize::try_from(exponent).ok()?;
            if coefficients.len() <= place {
                coefficients.resize(place + 1, Rational::zero());
            }
            coefficients[place] = coefficient.as_rational()?.clone();
        }
        Some(RationalPolynomial::new(&coefficients))
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

    /// The coefficients, none of them 0.
    pub fn coefficients(&self) -> impl Iterator<Item = &RealCyclotomic> {
        self.terms.values()
    }

    fn add_term(&mut self, monomial: Monomial, coefficient: RealCyclotomic) {
        let sum = match self.terms.get(&monomial) {
            Some(present) => present + &coefficient,
            None => coefficient,
        };
        if is_zero(&sum) {
            self.terms.remove(&monomial);
        } else {
            self.terms.insert(monomial, sum);
        }
    }
}

fn is_zero(value: &RealCyclotomic) -> bool {
    value.as_rational().is_some_and(Rational::is_zero)
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.terms {
            sum.add_term(monomial.clone(), coefficient.clone());
        }
        sum
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        let mut difference = self.clone();
        for (monomial, coefficient) in &other.terms {
            difference.add_term(monomial.clone(), -coefficient);
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
                product.add_term(monomial, a * b);
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
            let (negative, term) = term(monomial, coefficient);
            text.push_str(match (text.is_empty(), negative) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            });
            text.push_str(&term);
        }
        f.pad(&text)
    }
}

/// A term without its sign, and whether that is a minus. An irrational coefficient
/// is a sum itself, and stands in parentheses before variables.
fn term(monomial: &Monomial, coefficient: &RealCyclotomic) -> (bool, String) {
    let (negative, magnitude) = match coefficient.as_rational() {
        Some(value) => (value.sign() < 0, value.abs().to_string()),
        None if monomial.is_empty() => (false, coefficient.to_string()),
        None => (false, format!("({coefficient})")),
    };
    let mut factors = Vec::new();
    if monomial.is_empty() || magnitude != "1" {
        factors.push(magnitude);
    }
    for (variable, exponent) in monomial {
        factors.push(match exponent {
            1 => variable.clone(),
            _ => format!("{variable}^{exponent}"),
        });
    }
    (negative, factors.join("*"))
}
