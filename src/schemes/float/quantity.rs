//! A number in f64, compared with its exact value.

use crate::exact::{Enclosed, Rational, Real};
use crate::machine::{exact, nearest, ulps_between};

/// A number computed in f64, with its exact value, its error and a bound of the error.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity<V = Rational> {
    /// The name: `b[β][j]`, `T_c`, `Lambda_c`, `T_c*Lambda_c`, `sigma`, `sigma(o=0)`,
    /// `surface factor` or `error(c=…, k=…)`. For a tensor product, the names for one
    /// direction begin with `first ` or `second `. For a ring, `m[a][b]` with the names
    /// of points, `T_c`, `Lambda_c` or `sigma`.
    pub name: String,
    /// The f64 result; it may be NaN or infinite.
    pub value: f64,
    /// The exact value, computed on the exact path.
    pub exact: V,
    /// |value − exact|; `None` when the value is not finite.
    pub error: Option<V>,
    /// The error in units in the last place of the nearest f64; `None` when this is 0 and the result is not, since
    /// the units there are those of the subnormal numbers.
    pub ulps: Option<V>,
    /// The a priori bound of the error; see [`Tracked`](super::Tracked). Infinite when nothing
    /// is proven; `None` beyond [`MAX_TRACKED_STEPS`](super::MAX_TRACKED_STEPS).
    pub bound: Option<f64>,
    /// error/bound, from 0 to 1. `None` without a finite error, and when the bound is
    /// missing, 0 or infinite.
    pub tightness: Option<f64>,
}

impl<V: Real + Enclosed + PartialOrd> Quantity<V> {
    pub(super) fn new(name: String, value: f64, target: V, bound: Option<f64>) -> Quantity<V> {
        let distance = |found| V::from_rational(&found).minus(&target).magnitude();
        let error = exact(value).map(distance);
        let is_apart_from_zero = value != 0.0 && nearest(&target) == 0.0;
        let ulps = ulps_between(value, &target).filter(|_| !is_apart_from_zero);
        let tightness = match (&error, bound) {
            (Some(error), Some(bound)) if bound > 0.0 && bound.is_finite() => {
                Some(nearest(error) / bound)
            }
            _ => None,
        };
        Quantity { name, value, exact: target, error, ulps, bound, tightness }
    }

    /// Whether the true error is within the bound, decided exactly; `None` without a bound.
    /// `Some(false)` would refute the proof of [`Tracked`](super::Tracked).
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
