//! Flows of least cost, and the differences between points of a ring and the limit.

use super::limit::{Labelled, LocalLimit, LocalLimitError, check_level, pulled_back};
use crate::bound::transport;
use crate::exact::{Rational, Real};
use crate::formula::Value;
use crate::scheme::LocalRules;

/// For each functional f, whose coefficients must sum to 0, a flow along the
/// [edges](LocalRules::edges) that carries fᵀM^k at the least cost ‖fᵀM^k‖_*.
///
/// # Errors
/// As [`LocalDistances::constant`](super::distance::LocalDistances::constant).
///
/// # Panics
/// When the coefficients of a functional do not sum to 0.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::limit::least_flows;
/// use subcert::scheme::parse_local_rules;
///
/// // Two levels later the difference along an edge of a square is at most 5/32 + 3/32 of
/// // those along this one and the opposite one.
/// let square = parse_local_rules("doo-sabin:n=4")?;
/// let difference = [1, -1, 0, 0].map(RealCyclotomic::from).to_vec();
/// let flow = [5, 0, -3, 0].map(|p| Rational::new(p, 32).into());
/// assert_eq!(least_flows(&square, vec![difference], 2)?, [flow]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_flows<S: Real + Ord + Value>(
    ring: &LocalRules<S>,
    functionals: Vec<Vec<S>>,
    level: u32,
) -> Result<Vec<Vec<S>>, LocalLimitError> {
    check_level(ring, functionals.len(), level)?;
    let functionals = functionals.into_iter().map(|f| ((), f)).collect();
    let after = pulled_back(ring, functionals).nth(level as usize);
    let flow = |((), f): &Labelled<S, ()>| {
        transport(f, ring.edges()).expect("coefficients that sum to 0").flow
    };
    Ok(after.expect("there is no last level").iter().map(flow).collect())
}

impl<S: Real + Ord + Value> LocalLimit<S> {
    /// e_a − w for every point a.
    #[must_use]
    pub fn errors(&self) -> Vec<Vec<S>> {
        (0..self.weights().len()).map(|a| self.error(a)).collect()
    }

    pub(super) fn error(&self, point: usize) -> Vec<S> {
        minus(&unit(self.weights().len(), point), self.weights())
    }
}

/// The unit vector e_a for a = `at`.
#[must_use]
pub fn unit<S: Real>(count: usize, at: usize) -> Vec<S> {
    let entry = |b| S::from_rational(&Rational::from(u32::from(b == at)));
    (0..count).map(entry).collect()
}

/// The difference of two functionals.
pub fn minus<'a, S: Real + 'a>(
    left: impl IntoIterator<Item = &'a S>,
    right: impl IntoIterator<Item = &'a S>,
) -> Vec<S> {
    left.into_iter().zip(right).map(|(x, y)| x.minus(y)).collect()
}
