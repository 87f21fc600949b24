//! Rational numbers plus multiples of logarithms.

use super::{Enclosed, Enclosure, Rational, natural_logarithm};
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
