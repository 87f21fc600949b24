//! Rational numbers plus multiples of logarithms.

use crate::exact::{Enclosed, Enclosure, Integer, Rational, natural_logarithm};
use std::cmp::Ordering;
use std::fmt;

/// r + Σ c·log_b(x), with rational r and c, and rational x > 0.
///
/// ```
/// use subcert::exact::{Enclosed, LogSum, LogTerm, Rational};
///
/// let term = LogTerm { factor: Rational::from(-1), base: 2, of: Rational::from(9) };
/// let sum = LogSum { rational: Rational::from(6), terms: vec![term] };
/// assert_eq!(sum.to_string(), "6 - log_2(9)");
/// assert!(sum.enclosure(0).lower() > &Rational::new(283, 100));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogSum {
    /// r.
    pub rational: Rational,
    /// The other terms.
    pub terms: Vec<LogTerm>,
}

/// c·log_b(x).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogTerm {
    /// c.
    pub factor: Rational,
    /// b, at least 2.
    pub base: usize,
    /// x, positive.
    pub of: Rational,
}

impl From<Rational> for LogSum {
    fn from(rational: Rational) -> LogSum {
        LogSum { rational, terms: Vec::new() }
    }
}

impl LogSum {
    /// This number times a rational one.
    #[must_use]
    pub fn scaled(mut self, factor: &Rational) -> LogSum {
        self.rational = &self.rational * factor;
        for term in &mut self.terms {
            term.factor = &term.factor * factor;
        }
        self
    }

    /// The sum of both.
    #[must_use]
    pub fn plus(mut self, other: LogSum) -> LogSum {
        self.rational += &other.rational;
        self.terms.extend(other.terms);
        self
    }
}

/// The level of the finest enclosures that are compared: 64·2^3 binary digits.
const MAX_LEVEL: u32 = 3;

/// The greatest exponent of a power that is computed exactly.
const MAX_POWER: i64 = 4_096;

impl LogSum {
    /// How this number compares with another one: by enclosures, and exactly where all logarithms have one
    /// base and small factors. `None` where neither tells.
    ///
    /// ```
    /// use std::cmp::Ordering;
    /// use subcert::exact::{LogSum, LogTerm, Rational};
    ///
    /// let log = |factor: i64, of: i64| LogTerm { factor: factor.into(), base: 2, of: of.into() };
    /// let sum = |whole: i64, term| LogSum { rational: whole.into(), terms: vec![term] };
    /// // 6 − log_2(9) = 5 + log_2(2/9) < 5 − 2·log_2(2)
    /// let exponent = sum(6, log(-1, 9));
    /// let other = LogTerm { of: Rational::new(2, 9), ..log(1, 1) };
    /// assert_eq!(exponent.compare(&sum(5, other)), Some(Ordering::Equal));
    /// assert_eq!(exponent.compare(&sum(5, log(-2, 2))), Some(Ordering::Less));
    /// ```
    #[must_use]
    pub fn compare(&self, other: &LogSum) -> Option<Ordering> {
        let difference = self.clone().plus(other.clone().scaled(&Rational::from(-1)));
        let order = |level| {
            let sign = difference.enclosure(level).sign().filter(|sign| *sign != 0)?;
            Some(sign.cmp(&0))
        };
        // Fine enclosures take longer than exact arithmetic with small exponents.
        (0..2)
            .find_map(order)
            .or_else(|| difference.vanishes().then_some(Ordering::Equal))
            .or_else(|| (2..=MAX_LEVEL).find_map(order))
    }

    /// Whether this number is shown to be 0: b^{rD} Π x^{cD} = 1, with D for which these exponents are
    /// integers.
    fn vanishes(&self) -> bool {
        let Some(base) = self.terms.first().map(|term| term.base) else {
            return self.rational.is_zero();
        };
        let one = LogTerm { factor: self.rational.clone(), base, of: Rational::from(base) };
        let terms = || self.terms.iter().chain([&one]);
        let common = terms().fold(Integer::one(), |lcm, term| lcm.lcm(&term.factor.denominator()));
        let scale = Rational::from(common);
        let powers = terms().map(|LogTerm { factor, base: own, of }| {
            let exponent = (factor * &scale).numerator().within(MAX_POWER)?;
            (*own == base).then_some(of.pow(i32::try_from(exponent).ok()?))
        });
        let product = powers.reduce(|product, power| Some(product? * power?)).flatten();
        product == Some(Rational::one())
    }
}

impl Enclosed for LogSum {
    fn enclosure(&self, level: u32) -> Enclosure {
        let bits = 64 << level;
        let term = |LogTerm { factor, base, of }: &LogTerm| {
            let (top, base) =
                (natural_logarithm(of, bits), natural_logarithm(&Rational::from(*base), bits));
            let over = Enclosure::new(base.upper().recip(), base.lower().recip());
            &Enclosure::exact(factor.clone()) * &(&top * &over)
        };
        let whole = Enclosure::exact(self.rational.clone());
        self.terms.iter().fold(whole, |sum, one| &sum + &term(one))
    }
}

impl fmt::Display for LogSum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        if !self.rational.is_zero() || self.terms.is_empty() {
            write!(f, "{}", self.rational)?;
            first = false;
        }
        for LogTerm { factor, base, of } in &self.terms {
            let negative = *factor < Rational::zero();
            f.write_str(match (first, negative) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            })?;
            first = false;
            if factor.abs() != Rational::one() {
                write!(f, "{}*", factor.abs())?;
            }
            write!(f, "log_{base}({of})")?;
        }
        Ok(())
    }
}
