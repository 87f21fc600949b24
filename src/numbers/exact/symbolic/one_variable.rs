//! Conversion between polynomials in named variables and polynomials in one variable.

use crate::exact::{Polynomial, Rational, RationalPolynomial};

impl Polynomial {
    /// This as a polynomial in `variable` over the rationals; `None` when another
    /// variable or an irrational coefficient occurs.
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
        let mut coefficients = vec![self.constant_term().as_rational()?.clone()];
        for (monomial, coefficient) in self.other_terms() {
            let exponent = monomial.only(variable)?;
            let place = usize::try_from(exponent).ok()?;
            if coefficients.len() <= place {
                coefficients.resize(place + 1, Rational::zero());
            }
            coefficients[place] = coefficient.as_rational()?.clone();
        }
        Some(RationalPolynomial::new(&coefficients))
    }
}

impl RationalPolynomial {
    /// This polynomial in the variable `variable`.
    #[must_use]
    pub fn in_name(&self, variable: &str) -> Polynomial {
        let x = Polynomial::variable(variable);
        let mut power = Polynomial::constant(Rational::one());
        let mut sum = Polynomial::default();
        for coefficient in self.coefficients() {
            sum = &sum + &(&Polynomial::constant(coefficient) * &power);
            power = &power * &x;
        }
        sum
    }

    /// This polynomial in the variable `variable`, as [`Polynomial`] prints it.
    #[must_use]
    pub fn describe(&self, variable: &str) -> String {
        self.in_name(variable).to_string()
    }
}
