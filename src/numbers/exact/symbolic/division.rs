//! Division of polynomials in several variables.

use super::monomial::Monomial;
use crate::exact::{Polynomial, RealCyclotomic};
use std::cmp::Ordering;

impl Monomial {
    /// The lexicographic order of the exponents, the first name first. It is kept by products.
    fn lexicographic(&self, other: &Monomial) -> Ordering {
        let (mut own, mut others) = (self.powers().iter(), other.powers().iter());
        loop {
            match (own.next(), others.next()) {
                (None, None) => return Ordering::Equal,
                (Some(_), None) => return Ordering::Greater,
                (None, Some(_)) => return Ordering::Less,
                (Some((a, m)), Some((b, n))) => match b.cmp(a).then(m.cmp(n)) {
                    Ordering::Equal => {}
                    order => return order,
                },
            }
        }
    }

    /// self / other, if it is a monomial.
    fn over(&self, other: &Monomial) -> Option<Monomial> {
        let mut quotient = Vec::new();
        let mut found = 0;
        for (name, exponent) in self.powers() {
            let known = other.powers().iter().find(|(divisor, _)| divisor == name);
            found += usize::from(known.is_some());
            let rest = exponent.checked_sub(known.map_or(0, |(_, exponent)| *exponent))?;
            if rest > 0 {
                quotient.push((name.clone(), rest));
            }
        }
        (found == other.powers().len()).then(|| Monomial::of(quotient))
    }
}

impl Polynomial {
    /// The coefficient of the greatest monomial, which is not 0 unless this is.
    #[must_use]
    pub fn leading_coefficient(&self) -> RealCyclotomic {
        self.leading().1
    }

    fn leading(&self) -> (Monomial, RealCyclotomic) {
        let greatest = self.other_terms().iter().max_by(|(a, _), (b, _)| a.lexicographic(b));
        greatest.cloned().unwrap_or_else(|| (Monomial::one(), self.constant_term().clone()))
    }

    /// The quotient if the divisor, which is not 0, divides this.
    ///
    /// ```
    /// use subcert::exact::{Polynomial, Rational};
    ///
    /// let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
    /// let (sum, difference) = (&x + &y, &x - &y);
    /// assert_eq!((&(&x * &x) - &(&y * &y)).exactly_over(&sum), Some(difference));
    /// assert_eq!((&x * &x).exactly_over(&sum), None);
    /// ```
    #[must_use]
    pub fn exactly_over(&self, divisor: &Polynomial) -> Option<Polynomial> {
        let (first, coefficient) = divisor.leading();
        let inverse = &RealCyclotomic::from(1) / &coefficient;
        let (mut rest, mut quotient) = (self.clone(), Polynomial::default());
        while !rest.is_zero() {
            let (monomial, c) = rest.leading();
            let term = Polynomial::term(monomial.over(&first)?, &c * &inverse);
            rest = &rest - &(divisor * &term);
            quotient += &term;
        }
        Some(quotient)
    }

    /// The greatest monomial that divides every term of all of these polynomials, as a polynomial.
    #[must_use]
    pub fn common_monomial(all: [&Polynomial; 2]) -> Polynomial {
        let mut monomials = all.into_iter().flat_map(Polynomial::monomials);
        let Some(first) = monomials.next() else { return Polynomial::constant(1) };
        let mut common = first.powers().to_vec();
        for monomial in monomials {
            for (name, exponent) in &mut common {
                let own = monomial.powers().iter().find(|(other, _)| other == name);
                *exponent = own.map_or(0, |(_, own)| *own).min(*exponent);
            }
            common.retain(|(_, exponent)| *exponent > 0);
        }
        Polynomial::term(Monomial::of(common), RealCyclotomic::from(1))
    }

    fn monomials(&self) -> impl Iterator<Item = Monomial> {
        let constant =
            (self.constant_term().as_rational().is_none_or(|c| !c.is_zero())).then(Monomial::one);
        constant.into_iter().chain(self.other_terms().iter().map(|(monomial, _)| monomial.clone()))
    }

    /// The coefficients p_0, p_1, … of Σ p_i·variable^i, which are polynomials in the other variables; none for 0.
    ///
    /// ```
    /// use subcert::exact::Polynomial;
    ///
    /// let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
    /// assert_eq!((&(&x * &y) + &y).by_powers("x"), [y.clone(), y]);
    /// ```
    #[must_use]
    pub fn by_powers(&self, variable: &str) -> Vec<Polynomial> {
        let mut found: Vec<Polynomial> = Vec::new();
        let constant = (Monomial::one(), self.constant_term().clone());
        for (monomial, c) in std::iter::once(&constant).chain(self.other_terms()) {
            let mut powers = monomial.powers().to_vec();
            let at = powers.iter().position(|(name, _)| **name == *variable);
            let exponent = at.map_or(0, |at| powers.remove(at).1 as usize);
            if found.len() <= exponent {
                found.resize(exponent + 1, Polynomial::default());
            }
            found[exponent] += &Polynomial::term(Monomial::of(powers), c.clone());
        }
        while found.last().is_some_and(Polynomial::is_zero) {
            found.pop();
        }
        found
    }
}
