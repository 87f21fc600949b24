//! The coefficients of masks whose smoothness is asked for: rational, or of one real field Q(α).

use crate::bound::{Budget, Order, PowerSearch};
use crate::exact::{FieldElement, IntegerPolynomial, Rational, RealAlgebraic};
use crate::joint::Entry;
use crate::scheme::Rules;

/// The most levels at a time.
const MAX_LEVELS: u32 = 24;

/// The most steps of the search for each order.
const MAX_STEPS: u64 = 20_000_000;

/// Rational numbers, or those of one real field Q(α).
pub trait Coefficient: Entry {
    /// The coordinates of the number in the basis 1, α, α², …, without zeros at the end but for the number 0; a rational
    /// number is its own only coordinate.
    fn coordinates(&self) -> Vec<Rational>;

    /// α, and its minimal polynomial; `None` for a rational number.
    fn generator(&self) -> Option<(&RealAlgebraic, &IntegerPolynomial)>;

    /// The least c ≤ 24 for which the c-th power of the operator of these rules has a norm below 1, and this norm;
    /// `None` where the search finds none. Only rational rules are searched.
    fn contraction(rules: &Rules<Self>) -> Option<(u32, Rational)>;
}

impl Coefficient for Rational {
    fn coordinates(&self) -> Vec<Rational> {
        vec![self.clone()]
    }

    fn generator(&self) -> Option<(&RealAlgebraic, &IntegerPolynomial)> {
        None
    }

    fn contraction(rules: &Rules) -> Option<(u32, Rational)> {
        let budget = Budget::new(MAX_STEPS);
        let mut search = PowerSearch::new(rules, Order::Adjoint).with_budget(budget);
        let norms = (1..=MAX_LEVELS).map_while(|c| Some((c, search.norm(c).ok()?.value)));
        norms.into_iter().find(|(_, norm)| *norm < Rational::one())
    }
}

impl Coefficient for FieldElement {
    fn coordinates(&self) -> Vec<Rational> {
        let coordinates = FieldElement::coordinates(self).coefficients();
        if coordinates.is_empty() { vec![Rational::zero()] } else { coordinates }
    }

    fn generator(&self) -> Option<(&RealAlgebraic, &IntegerPolynomial)> {
        self.field()
    }

    fn contraction(_: &Rules<FieldElement>) -> Option<(u32, Rational)> {
        None
    }
}
