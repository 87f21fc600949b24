//! What coefficients add up to.

use super::super::rules::MAX_ARITY;
use crate::exact::{AlgebraicNumber, FieldError, Rational, Scalar as _};
use crate::formula::Value as _;

/// The longest sum that a message states.
const MAX_WORDS: usize = 40;

/// The sum of coefficients.
pub(super) struct Sum {
    values: Vec<AlgebraicNumber>,
    sum: AlgebraicNumber,
}

impl Sum {
    /// The sum of these numbers.
    ///
    /// # Errors
    /// When no field within the caps has them all.
    pub(super) fn of(values: &[AlgebraicNumber]) -> Result<Sum, FieldError> {
        let values = AlgebraicNumber::together(values)?;
        let sum = AlgebraicNumber::total(&values);
        Ok(Sum { values, sum })
    }

    /// The sum, if it is the arity of a mask.
    pub(super) fn arity(&self) -> Option<usize> {
        let sum = self.sum.as_rational().filter(Rational::is_integer)?;
        let arity = usize::try_from(sum.numerator().to_i64()?).ok()?;
        (2..=MAX_ARITY).contains(&arity).then_some(arity)
    }

    /// Whether the sums of the n rules are equal.
    pub(super) fn is_uniform(&self, arity: usize) -> bool {
        let rule = |alpha| AlgebraicNumber::total(self.values.iter().skip(alpha).step_by(arity));
        let first = rule(0);
        (1..arity).all(|alpha| rule(alpha) == first)
    }

    /// The sum in words, where it is plain and short.
    pub(super) fn words(&self) -> Option<String> {
        let words = if let Some(sum) = self.sum.as_rational() {
            sum.to_string()
        } else {
            let square = self.sum.times(&self.sum).as_rational()?;
            (self.sum.sign() > 0).then(|| format!("sqrt({square})"))?
        };
        (words.len() <= MAX_WORDS).then_some(words)
    }

    /// The arities n of which these are the coefficients but for a factor, each with the factor.
    pub(super) fn factors(&self) -> Vec<(usize, String)> {
        if self.sum.sign() == 0 {
            return Vec::new();
        }
        let arities = (2..=self.values.len().min(MAX_ARITY)).filter(|n| self.is_uniform(*n));
        arities.filter_map(|n| Some((n, self.over(n)?))).collect()
    }

    /// n over the sum.
    fn over(&self, n: usize) -> Option<String> {
        let n = Rational::from(n);
        if let Some(sum) = self.sum.as_rational() {
            return (!sum.is_zero()).then(|| (n / sum).to_string());
        }
        // n/s = √(n²/s²)
        let square = self.sum.times(&self.sum).as_rational()?;
        (self.sum.sign() > 0).then(|| format!("sqrt({})", &n * &n / square))
    }
}
