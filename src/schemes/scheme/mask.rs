//! Masks: affine refinement rules.

use super::rules::{Rules, RulesError};
use crate::cap::Cap;
use crate::exact::{Rational, Scalar};
use std::fmt::Display;

/// The mask of an affine scheme: rules with Σ_j a_{α,j} = 1 for every α.
#[derive(Clone, Debug, PartialEq)]
pub struct Mask<S = Rational> {
    rules: Rules<S>,
}

/// Why a table of numbers is not a mask.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MaskError {
    /// The rows are not a set of rules.
    #[error(transparent)]
    Rules(#[from] RulesError),
    /// A rule that is not an affine combination.
    #[error(
        "rule {rule} sums to {sum}, not to 1: its excess is {excess}; \
         the coefficients of every rule must sum to 1; rules are counted from 0"
    )]
    NotAffine {
        /// The number of the rule, counted from 0.
        rule: usize,
        /// Its sum.
        sum: String,
        /// Its sum minus 1.
        excess: String,
    },
}

impl MaskError {
    /// The cap that the mask is beyond, if this is what is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            MaskError::Rules(error) => error.cap(),
            MaskError::NotAffine { .. } => None,
        }
    }
}

impl<S: Scalar + PartialEq + Display> Mask<S> {
    /// The mask with these coefficients, one row for each α, and offset o.
    ///
    /// # Errors
    /// When the rows are not rules, or one does not sum to 1.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::scheme::Mask;
    ///
    /// let quarter = |p| Rational::new(p, 4);
    /// let error = Mask::new(vec![vec![quarter(3), quarter(1)], vec![quarter(1), quarter(1)]], 0);
    /// assert!(error.unwrap_err().to_string().starts_with("rule 1 sums to 1/2"));
    /// ```
    pub fn new(rows: Vec<Vec<S>>, offset: i64) -> Result<Mask<S>, MaskError> {
        let rules = Rules::new(rows, offset)?;
        let one = S::from_rational(&Rational::one());
        for (rule, row) in rules.rows().iter().enumerate() {
            let sum = S::total(row);
            if sum != one {
                let excess = sum.minus(&one).to_string();
                return Err(MaskError::NotAffine { rule, sum: sum.to_string(), excess });
            }
        }
        Ok(Mask { rules })
    }
}

impl<S: Scalar> Mask<S> {
    /// The rules of a filter, which may have any sums. Limits and differences of this have no meaning.
    pub(super) fn filter(rows: Vec<Vec<S>>, offset: i64) -> Result<Mask<S>, MaskError> {
        Ok(Mask { rules: Rules::new(rows, offset)? })
    }

    /// The mask as rules.
    #[must_use]
    pub fn rules(&self) -> &Rules<S> {
        &self.rules
    }

    /// The arity n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.rules.arity()
    }

    /// The width N.
    #[must_use]
    pub fn width(&self) -> usize {
        self.rules.width()
    }

    /// The offset o.
    #[must_use]
    pub fn offset(&self) -> i64 {
        self.rules.offset()
    }

    /// The same coefficients at another offset.
    #[must_use]
    pub fn with_offset(&self, offset: i64) -> Mask<S> {
        Mask { rules: self.rules.with_offset(offset) }
    }

    /// The mask of the same points with other numbers, as [`Rules::numbered_from`].
    ///
    /// # Panics
    /// When `first` is not below n.
    #[must_use]
    pub fn numbered_from(&self, first: usize) -> Mask<S> {
        Mask { rules: self.rules.numbered_from(first) }
    }

    /// The mask with `map` applied to every coefficient. `map` may round. The sums of the
    /// rules are not checked again.
    #[must_use]
    pub fn map<T: Scalar>(&self, map: impl FnMut(&S) -> T) -> Mask<T> {
        Mask { rules: self.rules.map(map) }
    }

    /// The difference mask b, with `Δ'_{ni+β} = Σ_j b_{β,j} Δ_{i+o+j}` for
    /// Δ_i = x_{i+1} − x_i:
    ///
    /// b_{β,j} = Σ_{h≤j} (a_{β,h} − a_{β+1,h}) for β = 0, …, n−2, and
    /// b_{n−1,j} = a_{0,j} − Σ_{β<n−1} b_{β,j}, with j = 0, …, N−1.
    ///
    /// Source: Mustafa and Hashmi 2010; Mustafa et al. 2020, section II.
    ///
    /// # Panics
    /// Never: the difference mask has the shape of the mask.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = parse_scheme("chaikin")?;
    /// let half = Rational::new(1, 2);
    /// let zero = Rational::zero();
    /// let difference = chaikin.masks()[0].difference();
    /// assert_eq!(difference.rows(), [[half.clone(), zero], [Rational::new(1, 4), Rational::new(1, 4)]]);
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn difference(&self) -> Rules<S> {
        let rows = self.rules.rows();
        let mut difference: Vec<Vec<S>> = Vec::with_capacity(rows.len());
        for pair in rows.windows(2) {
            let mut sum = S::zero();
            let partial_sums = pair[0].iter().zip(&pair[1]).map(|(left, right)| {
                sum = sum.plus(&left.minus(right));
                sum.clone()
            });
            difference.push(partial_sums.collect());
        }
        let last = rows[0].iter().enumerate().map(|(j, coefficient)| {
            let column = S::total(difference.iter().map(|row| &row[j]));
            coefficient.minus(&column)
        });
        let last = last.collect();
        difference.push(last);
        Rules::new(difference, self.offset()).expect("the shape of a mask is a shape of rules")
    }
}
