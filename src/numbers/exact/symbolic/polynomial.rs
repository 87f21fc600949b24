//! Polynomials over the real cyclotomic numbers in named variables.

use super::monomial::Monomial;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt;
use std::ops::{Add, AddAssign, Mul, Sub};

/// A polynomial in named variables over the fields Q(2cos(2π/n)), in normal form:
/// two polynomials are equal exactly when they agree as functions.
///
/// The coefficients of all polynomials in one computation need a
/// [`common_conductor`](crate::exact::common_conductor).
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
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Polynomial {
    /// Stored apart from the other terms, since in many formulas most values are
    /// constants.
    constant: RealCyclotomic,
    /// In the order of the monomials. No coefficient is 0, and no monomial 1.
    terms: Vec<Term>,
}

type Term = (Monomial, RealCyclotomic);

impl Polynomial {
    /// The constant `value`.
    #[must_use]
    pub fn constant(value: impl Into<RealCyclotomic>) -> Polynomial {
        Polynomial { constant: value.into(), terms: Vec::new() }
    }

    /// The variable `name`.
    #[must_use]
    pub fn variable(name: &str) -> Polynomial {
        let terms = vec![(Monomial::variable(name), RealCyclotomic::from(1))];
        Polynomial { constant: RealCyclotomic::from(0), terms }
    }

    /// A multiple of a monomial.
    pub(super) fn term(monomial: Monomial, coefficient: RealCyclotomic) -> Polynomial {
        if monomial.is_one() || is_zero(&coefficient) {
            return Polynomial::constant(coefficient);
        }
        Polynomial { constant: RealCyclotomic::from(0), terms: vec![(monomial, coefficient)] }
    }

    /// The value of a constant polynomial; `None` when a variable remains.
    #[must_use]
    pub fn as_constant(&self) -> Option<RealCyclotomic> {
        self.terms.is_empty().then(|| self.constant.clone())
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty() && is_zero(&self.constant)
    }

    /// The variables, if every term besides the constant is a multiple of a single
    /// variable to the first power; otherwise `None`.
    ///
    /// ```
    /// use subcert::exact::Polynomial;
    /// let [x, y] = ["x", "y"].map(Polynomial::variable);
    /// assert_eq!((&x + &y).linear(), Some(vec!["x", "y"]));
    /// assert_eq!((&x * &y).linear(), None);
    /// ```
    #[must_use]
    pub fn linear(&self) -> Option<Vec<&str>> {
        fn variable(term: &Term) -> Option<&str> {
            match term.0.powers() {
                [(name, 1)] => Some(name),
                _ => None,
            }
        }
        self.terms.iter().map(variable).collect()
    }

    /// The coefficient of the monomial that is `variable` to the first power; 0 if there
    /// is none.
    #[must_use]
    pub fn coefficient(&self, variable: &str) -> RealCyclotomic {
        let is_variable =
            |monomial: &Monomial| matches!(monomial.powers(), [(name, 1)] if **name == *variable);
        let term = self.terms.iter().find(|(monomial, _)| is_variable(monomial));
        term.map_or(RealCyclotomic::from(0), |(_, coefficient)| coefficient.clone())
    }

    /// The coefficients c_0, c_1, … of Σ c_i·variable^i, none for 0; `None` when another variable occurs.
    ///
    /// ```
    /// use subcert::exact::{Polynomial, RealCyclotomic};
    ///
    /// let [w, x] = ["w", "x"].map(Polynomial::variable);
    /// let [zero, one] = [0, 1].map(RealCyclotomic::from);
    /// assert_eq!((&w * &w).coefficients_in("w"), Some(vec![zero.clone(), zero, one]));
    /// assert_eq!((&w * &x).coefficients_in("w"), None);
    /// ```
    #[must_use]
    pub fn coefficients_in(&self, variable: &str) -> Option<Vec<RealCyclotomic>> {
        let constant = (!is_zero(&self.constant)).then_some((0, &self.constant));
        let others = self.terms.iter().map(|(monomial, c)| Some((monomial.only(variable)?, c)));
        let terms: Option<Vec<(u32, &RealCyclotomic)>> =
            constant.map(Some).into_iter().chain(others).collect();
        let terms = terms?;
        let length = terms.iter().map(|(i, _)| *i as usize + 1).max().unwrap_or(0);
        let mut coefficients = vec![RealCyclotomic::from(0); length];
        for (i, c) in terms {
            coefficients[i as usize] = c.clone();
        }
        Some(coefficients)
    }

    /// The number of terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.terms.len() + usize::from(!is_zero(&self.constant))
    }

    /// The greatest sum of exponents in a term; 0 for a constant.
    #[must_use]
    pub fn degree(&self) -> u64 {
        self.terms.iter().map(|(monomial, _)| monomial.degree()).max().unwrap_or(0)
    }

    /// The coefficient of the monomial 1, which may be 0.
    pub(super) fn constant_term(&self) -> &RealCyclotomic {
        &self.constant
    }

    /// The monomials other than 1, and their coefficients.
    pub(super) fn other_terms(&self) -> &[(Monomial, RealCyclotomic)] {
        &self.terms
    }

    /// The coefficients, none of them 0.
    pub fn coefficients(&self) -> impl Iterator<Item = &RealCyclotomic> {
        let constant = Some(&self.constant).filter(|constant| !is_zero(constant));
        constant.into_iter().chain(self.terms.iter().map(|(_, coefficient)| coefficient))
    }

    /// Adds `others`, which are in the order of their monomials.
    fn add_terms(&mut self, others: impl ExactSizeIterator<Item = Term>) {
        let own = std::mem::take(&mut self.terms);
        self.terms.reserve(own.len() + others.len());
        let (mut own, mut others) = (own.into_iter().peekable(), others.peekable());
        loop {
            let order = match (own.peek(), others.peek()) {
                (Some((own, _)), Some((other, _))) => own.cmp(other),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => return,
            };
            match order {
                Ordering::Less => self.terms.extend(own.next()),
                Ordering::Greater => self.terms.extend(others.next()),
                Ordering::Equal => {
                    let both = own.next().zip(others.next());
                    let sum = both.map(|((monomial, a), (_, b))| (monomial, &a + &b));
                    self.terms.extend(sum.filter(|(_, coefficient)| !is_zero(coefficient)));
                }
            }
        }
    }
}

impl Default for Polynomial {
    /// 0.
    fn default() -> Polynomial {
        Polynomial::constant(0)
    }
}

fn is_zero(value: &RealCyclotomic) -> bool {
    value.as_rational().is_some_and(Rational::is_zero)
}

impl AddAssign<&Polynomial> for Polynomial {
    fn add_assign(&mut self, other: &Polynomial) {
        self.constant = &self.constant + &other.constant;
        if !other.terms.is_empty() {
            self.add_terms(other.terms.iter().cloned());
        }
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let mut sum = self.clone();
        sum += other;
        sum
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        let mut difference = self.clone();
        difference.constant = &self.constant - &other.constant;
        let negative = |(monomial, coefficient): &Term| (monomial.clone(), -coefficient);
        difference.add_terms(other.terms.iter().map(negative));
        difference
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        // No product of coefficients is 0, as the coefficients lie in a field.
        let mut product = Polynomial::constant(&self.constant * &other.constant);
        for (constant, terms) in [(&self.constant, &other.terms), (&other.constant, &self.terms)] {
            if !is_zero(constant) {
                let times = |(monomial, a): &Term| (monomial.clone(), constant * a);
                product.add_terms(terms.iter().map(times));
            }
        }
        let pairs = self.terms.iter().flat_map(|(left, a)| {
            other.terms.iter().map(move |(right, b)| (left.times(right), a * b))
        });
        let mut sums: BTreeMap<Monomial, RealCyclotomic> = BTreeMap::new();
        for (monomial, coefficient) in pairs {
            match sums.entry(monomial) {
                Entry::Vacant(place) => drop(place.insert(coefficient)),
                Entry::Occupied(mut place) => *place.get_mut() = place.get() + &coefficient,
            }
        }
        sums.retain(|_, coefficient| !is_zero(coefficient));
        product.add_terms(sums.into_iter());
        product
    }
}

impl Scalar for Polynomial {
    fn from_rational(value: &Rational) -> Self {
        Polynomial::constant(value.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn accumulate(&mut self, other: &Self) {
        *self += other;
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
}

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.pad("0");
        }
        let mut text = String::new();
        let constant = (Monomial::one(), self.constant.clone());
        let constant = Some((&constant.0, &constant.1)).filter(|(_, value)| !is_zero(value));
        for (monomial, coefficient) in
            constant.into_iter().chain(self.terms.iter().map(|(m, c)| (m, c)))
        {
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

/// Whether the sign of the term is a minus, and the term without its sign. An irrational
/// coefficient is itself a sum: it is printed in parentheses before variables, and keeps
/// its signs.
fn term(monomial: &Monomial, coefficient: &RealCyclotomic) -> (bool, String) {
    let (negative, magnitude) = match coefficient.as_rational() {
        Some(value) => (value.sign() < 0, value.abs().to_string()),
        None if monomial.is_one() => (false, coefficient.to_string()),
        None => (false, format!("({coefficient})")),
    };
    let mut factors = Vec::new();
    if monomial.is_one() || magnitude != "1" {
        factors.push(magnitude);
    }
    for (variable, exponent) in monomial.powers() {
        factors.push(match exponent {
            1 => variable.to_string(),
            _ => format!("{variable}^{exponent}"),
        });
    }
    (negative, factors.join("*"))
}
