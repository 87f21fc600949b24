//! What coefficients add up to.

use super::super::rules::MAX_ARITY;
use crate::exact::{Polynomial, Rational, Scalar as _};
use crate::formula::{FormulaErrorKind, Value};
use std::collections::BTreeSet;

/// The longest sum that a message states.
const MAX_WORDS: usize = 40;

/// What is wrong with coefficients whose sum has to be multiplied by one of these factors, each with the arity that it gives.
pub(super) fn lacks_factor(sum: &str, factors: &[(usize, String)], mask: &str) -> String {
    let write = |(n, factor): &(usize, String)| format!("write {factor}*{mask} for the arity {n}");
    let write: Vec<String> = factors.iter().map(write).collect();
    format!("the coefficients add up to {sum}; {}", write.join(", or "))
}

/// What is wrong with coefficients whose sum is no arity.
pub(super) fn no_arity(found: &str) -> String {
    format!(
        "the coefficients of a mask of arity n = 2, …, {MAX_ARITY} add up to n, and these {found}"
    )
}

/// What the sum of coefficients with parameters has to be.
pub(super) const EVERYWHERE: &str =
    "the coefficients of a mask of arity n add up to n for all values of its parameters";

/// The sum of coefficients.
pub(super) struct Sum<V> {
    values: Vec<V>,
    sum: V,
}

impl<V: Value + PartialEq> Sum<V> {
    /// The sum of these numbers.
    ///
    /// # Errors
    /// When no field within the caps has them all.
    pub(super) fn of(values: Vec<V>) -> Result<Sum<V>, FormulaErrorKind> {
        let values = V::together(values)?;
        let sum = V::total(&values);
        Ok(Sum { values, sum })
    }

    /// The sum.
    pub(super) fn total(&self) -> &V {
        &self.sum
    }

    /// The sum, if it is the arity of a mask.
    pub(super) fn arity(&self) -> Option<usize> {
        let sum = self.sum.as_rational().filter(Rational::is_integer)?;
        let arity = usize::try_from(sum.numerator().to_i64()?).ok()?;
        (2..=MAX_ARITY).contains(&arity).then_some(arity)
    }

    /// Whether the sums of the n rules are equal.
    pub(super) fn is_uniform(&self, arity: usize) -> bool {
        let rule = |alpha| V::total(self.values.iter().skip(alpha).step_by(arity));
        let first = rule(0);
        (1..arity).all(|alpha| rule(alpha) == first)
    }

    /// The sum in words, where it is plain and short.
    pub(super) fn words(&self) -> Option<String> {
        let words = if let Some(sum) = self.sum.as_rational() {
            sum.to_string()
        } else {
            let square = self.sum.times(&self.sum).as_rational()?;
            (self.is_positive()).then(|| format!("sqrt({square})"))?
        };
        (words.len() <= MAX_WORDS).then_some(words)
    }

    /// The arities n of which these are the coefficients but for a factor, each with the factor.
    pub(super) fn factors(&self) -> Vec<(usize, String)> {
        self.arities().into_iter().filter_map(|n| Some((n, self.over(n)?))).collect()
    }

    /// The arities for which the sums of all rules are equal, and not 0.
    pub(super) fn arities(&self) -> Vec<usize> {
        if self.sum.vanishes() == Some(true) {
            return Vec::new();
        }
        (2..=self.values.len().min(MAX_ARITY)).filter(|n| self.is_uniform(*n)).collect()
    }

    fn is_positive(&self) -> bool {
        self.sum.vanishes() == Some(false) && self.sum.absolute().as_ref() == Some(&self.sum)
    }

    /// n over the sum.
    fn over(&self, n: usize) -> Option<String> {
        let n = Rational::from(n);
        if let Some(sum) = self.sum.as_rational() {
            return (!sum.is_zero()).then(|| (n / sum).to_string());
        }
        // n/s = √(n²/s²)
        let square = self.sum.times(&self.sum).as_rational()?;
        (self.is_positive()).then(|| format!("sqrt({})", &n * &n / square))
    }
}

/// A sum that depends on parameters, and what makes it an arity n: a factor before the list, or the value of a parameter in
/// which the sum is linear.
pub(super) fn in_parameters(
    sum: &Polynomial,
    names: &BTreeSet<String>,
    arities: &[usize],
    list: &str,
) -> (String, String) {
    let words = sum.to_string();
    let solved = |n: usize| {
        names.iter().rev().find_map(|name| {
            // n = s + c·x
            let variable = Polynomial::variable(name);
            let c = sum.coefficient(name);
            let inverse = c.as_rational().filter(|c| !c.is_zero())?.recip();
            let rest = sum.minus(&variable.times(&Polynomial::constant(c)));
            let value = Polynomial::constant(Rational::from(n)).minus(&rest);
            let value = value.times(&Polynomial::constant(inverse));
            (!value.has(name)).then(|| format!("{value} for {name}, or "))
        })
    };
    let written = |n: &usize| {
        let solved = solved(*n).unwrap_or_default();
        format!("; for the arity {n} write {solved}{n}/({words})*{list}")
    };
    let found: String = arities.iter().take(2).map(written).collect();
    (words, found)
}
