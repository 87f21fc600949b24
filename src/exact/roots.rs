//! The real roots of a polynomial, found with its Sturm sequence.

use super::{
    Enclosed, Integer, IntegerPolynomial, Rational, RealAlgebraic, RealCyclotomic, SturmSequence,
};
use std::sync::Arc;

/// The greatest conductor of a number whose minimal polynomial is computed.
const MAX_CONDUCTOR: u32 = 60;

impl RealAlgebraic {
    /// The distinct real roots of `polynomial`, in increasing order.
    ///
    /// # Panics
    /// When `polynomial` is 0.
    #[must_use]
    pub fn roots_of(polynomial: &IntegerPolynomial) -> Vec<RealAlgebraic> {
        SturmSequence::new(polynomial).roots()
    }

    /// This number as a root of its minimal polynomial; `None` where its conductor is above 60.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealAlgebraic, RealCyclotomic};
    ///
    /// // cos(2π/5) = (√5 − 1)/4
    /// let cosine = RealCyclotomic::cosine(&Rational::new(1, 5))?;
    /// let root = RealAlgebraic::of_cyclotomic(&cosine).expect("a small conductor");
    /// assert_eq!(root.polynomial().to_string(), "4x^2 + 2x - 1");
    /// assert!(root > RealAlgebraic::from(Rational::new(3, 10)));
    /// # Ok::<(), subcert::exact::CosineError>(())
    /// ```
    #[must_use]
    pub fn of_cyclotomic(number: &RealCyclotomic) -> Option<RealAlgebraic> {
        if let Some(rational) = number.as_rational() {
            return Some(RealAlgebraic::from(rational.clone()));
        }
        if number.conductor() > MAX_CONDUCTOR {
            return None;
        }
        let mut roots = RealAlgebraic::roots_of(&number.minimal_polynomial());
        // The conjugates are apart from this number, so that one of them is left at some level.
        for level in 0.. {
            let near = number.enclosure(level);
            roots.retain(|root| {
                let other = root.enclosure(level);
                other.lower() <= near.upper() && near.lower() <= other.upper()
            });
            if roots.len() <= 1 {
                break;
            }
        }
        roots.pop()
    }
}

impl SturmSequence {
    /// The real roots of the polynomial, in increasing order.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn roots(&self) -> Vec<RealAlgebraic> {
        self.roots_between(None, None)
    }

    /// The real roots from `low` to `high`, both included, in increasing order. `None`
    /// means no bound on that side.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn roots_between(
        &self,
        low: Option<Rational>,
        high: Option<Rational>,
    ) -> Vec<RealAlgebraic> {
        let polynomial = Arc::new(self.polynomial().clone());
        // Cauchy: every root is below 1 + max |c_i/c_d| in absolute value.
        let largest = polynomial.coefficients().iter().map(Integer::abs).max();
        let ratio =
            Rational::new(largest.unwrap_or_else(Integer::zero), polynomial.leading().abs());
        let bits = u32::try_from(ratio.ceil().bits()).expect("a number that fits in memory");
        let bound = Rational::from(Integer::one().shifted_left(bits + 1));
        let mut roots = Vec::new();
        roots.extend(
            low.clone().filter(|low| polynomial.sign_at(low) == 0).map(RealAlgebraic::from),
        );
        // Bisection. The left half is on top of the stack.
        let mut stack = vec![(low.unwrap_or_else(|| -&bound), high.unwrap_or(bound))];
        while let Some((lower, upper)) = stack.pop() {
            match self.count_roots(&lower, &upper) {
                0 => {}
                1 => roots.push(RealAlgebraic::isolated(&polynomial, lower, upper)),
                _ => {
                    let middle = (&lower + &upper) / Rational::from(2);
                    stack.push((middle.clone(), upper));
                    stack.push((lower, middle));
                }
            }
        }
        roots
    }
}
