//! Minimal polynomials of expressions.

use super::algebra::Algebra;
use super::node::RealExpression;
use crate::exact::{Enclosed, IntegerPolynomial, MAX_CONDUCTOR, RealAlgebraic, SturmSequence};
use std::sync::Arc;

/// The greatest degree over Q of the field in which a minimal polynomial is looked for.
const MAX_DEGREE: u64 = 200;

/// The greatest product of the degrees of the roots of an expression.
const MAX_DIMENSION: u64 = 24;

impl RealExpression {
    /// This number as a root of a polynomial over the integers; `None` where its field is too large.
    ///
    /// The number is an element of an algebra of finite dimension over K = Q(2cos(2π/n)), and so a root of
    /// the characteristic polynomial of the multiplication by it. The product of the conjugates of this
    /// polynomial is one over Q.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn to_algebraic(&self) -> Option<RealAlgebraic> {
        if let Some(value) = self.as_number() {
            return Some(RealAlgebraic::from(value));
        }
        let field = &self.0.field;
        let dimension = field.degree() / (field.conductor / 2).max(1);
        if field.conductor > u64::from(MAX_CONDUCTOR)
            || dimension > MAX_DIMENSION
            || field.degree() > MAX_DEGREE
        {
            return None;
        }
        if let Some(Some(value)) = self.0.rational.get() {
            return Some(RealAlgebraic::from(value.clone()));
        }
        let mut algebra = Algebra::new(field);
        let element = algebra.element(self);
        let norm = Algebra::norm(&algebra.characteristic(&element));
        let polynomial = IntegerPolynomial::over_common_denominator(&norm).square_free();
        let sturm = SturmSequence::new(&polynomial);
        let alone = |level: u32| {
            let near = self.enclosure(level);
            let (lower, upper) = (near.lower().clone(), near.upper().clone());
            (sturm.count_roots(&lower, &upper) == 1).then_some((lower, upper))
        };
        let (lower, upper) = (0..).find_map(alone).expect("the roots are apart");
        Some(RealAlgebraic::isolated(&Arc::new(polynomial), lower, upper))
    }

    /// The minimal polynomial over Q, primitive and with a positive leading coefficient; `None` where it
    /// is out of reach: where the field's degree is above 200, or where
    /// [`IntegerPolynomial::irreducible_factors`] gives up.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealExpression, Scalar};
    ///
    /// let root = |n: i64| RealExpression::from(Rational::from(n)).sqrt().expect("a positive number");
    /// let sum = root(2).plus(&root(3));
    /// assert_eq!(sum.minimal_polynomial().expect("a small field").to_string(), "x^4 - 10x^2 + 1");
    /// ```
    #[must_use]
    pub fn minimal_polynomial(&self) -> Option<IntegerPolynomial> {
        match self.as_number() {
            Some(value) => Some(value.minimal_polynomial()),
            None => self.to_algebraic()?.minimal_polynomial(),
        }
    }
}
