//! Values of the limit at rational parameters.

use super::convergence::{contraction_constants, limit_at_repeating, limit_at_zero};
use super::error::{LimitError, MAX_LEVEL, MAX_OFFSET};
use super::functional::Functional;
use super::parameter::Parameter;
use crate::exact::{Rational, format, within};
use crate::scheme::{Mask, Rules};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The limit P^∞ of a convergent scheme, with exact values at rational parameters.
///
/// P^∞ = lim P^k, where P^k is the piecewise linear interpolant of the points x^k_i of
/// level k at the parameters i/n^k. The values of P^∞ are linear functionals of the control
/// points x^0. At 0 the functional is the left eigenvector for the eigenvalue 1 of the
/// scheme on its invariant window. At parameters with purely periodic digits it is the left
/// eigenvector of a product of blocks, one for each digit. At all other rational parameters
/// it is one of these functionals, applied to refined points.
///
/// Hypotheses: an affine mask with T_c < 1 for some c. This is checked by [`Limit::new`].
///
/// Source: `proofs/THEOREMS.md`, 2–4 and 82.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::{Functional, Limit};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("b-spline:degree=3")?;
/// let limit = Limit::new(scheme.masks()[0])?;
/// let weights = [1, 4, 1].map(|p| Rational::new(p, 6));
/// assert_eq!(limit.at(&Rational::zero())?, Functional::new(-1, weights));
/// let half = [1, 23, 23, 1].map(|p| Rational::new(p, 48));
/// assert_eq!(limit.at(&Rational::new(1, 2))?, Functional::new(-1, half));
/// let third = [8, 93, 60, 1].map(|p| Rational::new(p, 162));
/// assert_eq!(limit.at(&Rational::new(1, 3))?, Functional::new(-1, third));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Limit {
    mask: Mask,
    difference: Rules,
    contraction: Vec<Rational>,
    at_zero: Functional,
    /// The limits computed so far at parameters with purely periodic digits.
    repeating: Arc<Mutex<BTreeMap<Rational, Functional>>>,
}

impl Limit {
    /// The limit of the scheme of this mask.
    ///
    /// T_c is computed for n^c ≤ 2^10, and, while none is below 1, for n^c ≤ 2^16. Beyond this,
    /// branch and bound with a small cap on work is tried.
    ///
    /// # Errors
    /// When 1 is a multiple eigenvalue, so that there is no continuous limit; when no
    /// computed T_c is below 1; when the invariant window or the offset is too large.
    pub fn new(mask: &Mask) -> Result<Limit, LimitError> {
        if within(mask.offset(), MAX_OFFSET).is_none() {
            return Err(LimitError::Offset(mask.offset()));
        }
        let at_zero = limit_at_zero(mask)?;
        let difference = mask.difference();
        let contraction = contraction_constants(&difference);
        let least = contraction.iter().skip(1).min().unwrap_or(&contraction[0]);
        if *least >= Rational::one() {
            let blocks = u32::try_from(contraction.len() - 1).unwrap_or(u32::MAX);
            return Err(LimitError::NotShown { blocks, least: format::short(least, 6) });
        }
        let (mask, repeating) = (mask.clone(), Arc::default());
        Ok(Limit { mask, difference, contraction, at_zero, repeating })
    }

    /// The mask.
    #[must_use]
    pub fn mask(&self) -> &Mask {
        &self.mask
    }

    /// Its difference mask.
    #[must_use]
    pub fn difference(&self) -> &Rules {
        &self.difference
    }

    /// The computed constants T_0 = 1, T_1, …; at least one of them is below 1.
    #[must_use]
    pub fn contraction(&self) -> &[Rational] {
        &self.contraction
    }

    /// P^∞(t) as a functional of the control points, for a t whose n-adic digits are periodic
    /// after at most [`MAX_PARAMETER_DIGITS`](super::MAX_PARAMETER_DIGITS) digits, with a period
    /// of at most [`MAX_PERIOD`](super::MAX_PERIOD).
    ///
    /// # Errors
    /// When t is not such a parameter, or |t| is 2^60 or more.
    pub fn at(&self, t: &Rational) -> Result<Functional, LimitError> {
        let parameter = Parameter::new(t, self.mask.arity())?;
        let rules = self.mask.rules();
        if parameter.rest.is_zero() {
            return Ok(parameter.pull_back(&self.at_zero, rules));
        }
        Ok(parameter.pull_back(&self.at_repeating(&parameter.rest)?, rules))
    }

    fn at_repeating(&self, rest: &Rational) -> Result<Functional, LimitError> {
        // Entries are inserted in one step, so the map is consistent even after a panic
        // in another thread.
        let known = || self.repeating.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(limit) = known().get(rest) {
            return Ok(limit.clone());
        }
        let limit = limit_at_repeating(&self.mask, rest)?;
        known().insert(rest.clone(), limit.clone());
        Ok(limit)
    }

    /// P^k(t) as a functional of the control points.
    ///
    /// # Errors
    /// As [`Limit::at`], and when the level k is above 128.
    pub fn polygon_at(&self, level: u32, t: &Rational) -> Result<Functional, LimitError> {
        self.polygon_from(level, t, &Rational::zero())
    }

    /// As [`Limit::polygon_at`], for the polygon with x^k_i at the parameter (i + shift)/n^k.
    ///
    /// # Errors
    /// As [`Limit::polygon_at`].
    pub fn polygon_from(
        &self,
        level: u32,
        t: &Rational,
        shift: &Rational,
    ) -> Result<Functional, LimitError> {
        let (parameter, rest) = self.split(level, t)?;
        Ok(parameter.pull_back(&Functional::on_line(&(rest - shift)), self.mask.rules()))
    }

    /// P^∞(t) − P^k(t) as a functional of the differences Δ_i = x_{i+1} − x_i of the
    /// control points: the functional P^∞ − P^0 at the place of t between two points of
    /// level k, applied to Δ^k = D^k Δ. Its norm is attained by its [extremal
    /// polygon](Functional::extremal_polygon), so every bound of ‖P^∞ − P^k‖_∞/max|Δ| is
    /// at least this norm.
    ///
    /// Source: `proofs/THEOREMS.md`, 5.
    ///
    /// # Errors
    /// As [`Limit::polygon_at`].
    ///
    /// # Panics
    /// Never: the coefficients of both values sum to 1.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Limit;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("b-spline:degree=3")?;
    /// let limit = Limit::new(scheme.masks()[0])?;
    /// let error = limit.error(0, &Rational::zero())?;
    /// assert_eq!(error.norm(), Rational::new(1, 3));
    /// assert_eq!(error.extremal_polygon().points, [0, -1, 0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn error(&self, level: u32, t: &Rational) -> Result<Functional, LimitError> {
        self.error_from(level, t, &Rational::zero())
    }

    /// As [`Limit::error`], for the polygon with x^k_i at the parameter (i + shift)/n^k.
    ///
    /// # Errors
    /// As [`Limit::polygon_at`].
    ///
    /// # Panics
    /// Never: the coefficients of both values sum to 1.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{Limit, natural_shift};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("chaikin")?;
    /// let limit = Limit::new(scheme.masks()[0])?;
    /// let natural = natural_shift(limit.mask()).shift;
    /// let error = limit.error_from(1, &Rational::new(1, 4), &natural)?;
    /// assert_eq!(error.norm(), Rational::new(1, 16));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn error_from(
        &self,
        level: u32,
        t: &Rational,
        shift: &Rational,
    ) -> Result<Functional, LimitError> {
        let (parameter, rest) = self.split(level, t)?;
        let polygon = Functional::on_line(&(&rest - shift));
        let error = self.at(&rest)?.plus(&Rational::from(-1), &polygon);
        let error = error.on_differences().expect("both values are affine combinations");
        Ok(parameter.pull_back(&error, &self.difference))
    }

    fn split(&self, level: u32, t: &Rational) -> Result<(Parameter, Rational), LimitError> {
        if level > MAX_LEVEL {
            return Err(LimitError::Level(level));
        }
        let arity = self.mask.arity();
        Ok(Parameter::new(t, arity)?.split(level, arity))
    }
}
