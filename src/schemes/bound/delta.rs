//! The δ condition: contraction in a single level.

use super::constants::{Constants, Operator};
use super::power::{ClassCap, Order};
use crate::exact::Rational;

/// δ of a scheme, and whether δ < 1: the condition under which one level contracts the
/// differences and the error bounds of the older papers hold.
#[derive(Clone, Debug, PartialEq)]
pub struct DeltaCondition {
    /// δ.
    pub delta: Rational,
}

impl DeltaCondition {
    /// For curves: δ = max_β Σ_j |b_{β,j}| = T_1.
    ///
    /// Source: Mustafa and Deng 2007, (2.3); Mustafa and Hashmi 2010, (5).
    ///
    /// # Errors
    /// Never for masks within the caps: one level has at most 64 residue classes.
    ///
    /// ```
    /// use subcert::bound::{Constants, DeltaCondition};
    /// use subcert::exact::Rational;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("four-point:w=1/4")?;
    /// let constants = Constants::new(scheme.masks()[0].clone());
    /// let condition = DeltaCondition::curve(&constants)?;
    /// assert_eq!(condition.delta, Rational::one());
    /// assert!(!condition.holds());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn curve(constants: &Constants) -> Result<DeltaCondition, ClassCap> {
        let delta = constants.norm(Operator::Difference, 1, Order::Adjoint)?;
        Ok(DeltaCondition { delta })
    }

    /// For a tensor product: δ = max_{α,β} Σ_s |a_{α,s}| Σ_r |b_{β,r}| = T_1Λ_1, for the
    /// direction in which it is greater.
    ///
    /// Source: Mustafa and Deng 2007, (3.2) and (3.8); Mustafa and Hashmi 2010, (6).
    ///
    /// # Errors
    /// Never for masks within the caps.
    pub fn surface(first: &Constants, second: &Constants) -> Result<DeltaCondition, ClassCap> {
        let delta = first.tensor_with(second, 1)?.max(second.tensor_with(first, 1)?);
        Ok(DeltaCondition { delta })
    }

    /// Whether δ < 1.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.delta < Rational::one()
    }
}
