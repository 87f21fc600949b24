//! One number in f64 beside its exact value.

use super::convert::{exact, nearest, ulps_between};
use crate::exact::{Enclosed, Rational, Real};

/// One number computed in f64, and what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity<V = Rational> {
    /// What it is: `b[β][j]`, `T_c`, `Lambda_c`, `T_c*Lambda_c`, `sigma`,
    /// `sigma(o=0)`, `surface factor`, `error(c=…, k=…)`; for a tensor product those
    /// of one direction begin with `first ` or `second `. Of a ring, `m[a][b]` with the
    /// names of points, `T_c`, `Lambda_c` and `sigma`.
    pub name: String,
    /// The f64 result; it may be NaN or infinite.
    pub value: f64,
    /// The exact value, computed on the exact path.
    pub exact: V,
    /// |value − exact|; `None` when the value is not finite.
    pub error: Option<V>,
    /// The error in units in the last place of the nearest f64.
    pub ulps: Option<V>,
    /// The bound on the error, proven in advance: see [`Tracked`](super::Tracked). Infinite when
    /// nothing can be promised; `None` beyond
    /// [`MAX_TRACKED_STEPS`](super::MAX_TRACKED_STEPS).
    pub bound: Option<f64>,
    /// error/bound, from 0 to 1: how much of the bound the true error takes up.
    /// `None` where there is no bound, or it is 0 or infinite.
    pub tightness: Option<f64>,
}

impl<V: Real + Enclosed + PartialOrd> Quantity<V> {
    pub(super) fn new(name: String, value: f64, target: V, bound: Option<f64>) -> Quantity<V> {
        let distance = |found| V::from_rational(&found).minus(&target).magnitude();
        let error = exact(value).map(distance);
        let ulps = ulps_between(value, &target);
        let tightness = match (&error, bound) {
            (Some(error), Some(bound)) if bound > 0.0 && bound.is_finite() => {
                Some(nearest(error) / bound)
            }
            _ => None,
        };
        Quantity { name, value, exact: target, error, ulps, bound, tightness }
    }

    /// Whether the true error is within the bound, decided exactly; `None` without a
    /// bound. It always is: `Some(false)` would refute the proof of [`Tracked`](super::Tracked).
    #[must_use]
    pub fn encloses(&self) -> Option<bool> {
        let bound = self.bound?;
        Some(match (exact(bound), &self.error) {
            (None, _) => true,
            (Some(bound), Some(error)) => *error <= V::from_rational(&bound),
            (Some(_), None) => false,
        })
    }
}
