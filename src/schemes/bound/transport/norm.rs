//! ‖w‖_*: the norm of functionals of rings, dual to the largest difference along edges.

use super::forest::by_rounding;
use super::network::{Transport, shortest};
use crate::exact::{Rational, Real};

/// ‖w‖_* = max { Σ_a w_a P_a : |P_a − P_b| ≤ 1 for every edge (a, b) }, for a functional
/// w with the coefficients w_a, a = 0, …, v−1: the norm dual to the largest difference of
/// a ring P along edges.
///
/// By duality of linear programs this is the least Σ|f_e| of the flows f along edges that
/// carry w_a out of every point a (the norm of Kantorovich and Rubinstein, for the metric
/// of the mesh). As the costs of the edges are integers, the maximum is attained by some
/// P with integer heights. On a cycle it is min_λ Σ_i |w_0 + … + w_i − λ|, with λ a
/// median.
///
/// The flow is built from shortest paths of the residual network. Of paths of equal cost,
/// one with the fewest edges is taken, so that the algorithm ends for real numbers too
/// (Edmonds and Karp 1972). `None` when the maximum is infinite, that is, when w does not
/// sum to 0 on some connected component.
///
/// # Panics
/// When an end of an edge is not a point.
///
/// ```
/// use subcert::bound::transport;
/// use subcert::exact::Rational;
///
/// // From one corner of a square to the opposite one.
/// let square = [(0, 1), (1, 2), (2, 3), (3, 0)];
/// let found = transport(&[1, 0, -1, 0].map(Rational::from), &square).unwrap();
/// assert_eq!(found.value, Rational::from(2));
/// assert_eq!(found.heights, [2, 1, 0, 1]);
/// assert!(transport(&[1, 0, 0, 0].map(Rational::from), &square).is_none());
/// ```
#[must_use]
pub fn transport<S: Real + Ord>(w: &[S], edges: &[(usize, usize)]) -> Option<Transport<S>> {
    transport_at_costs(w, edges, &vec![1; edges.len()])
}

/// max { Σ_a w_a P_a : |P_a − P_b| ≤ c_e for every edge e = (a, b) }, for costs c_e ≥ 0 of
/// the edges; [`transport()`] for costs 1. It equals the least Σ c_e|f_e| over the flows
/// that carry w_a out of every point a. Integer heights attain it, as the costs are
/// integers.
///
/// # Panics
/// When an end of an edge is not a point, or the number of costs is not the number of
/// edges.
///
/// ```
/// use subcert::bound::transport_at_costs;
/// use subcert::exact::Rational;
///
/// // Across a square, on the way whose edges cost less.
/// let square = [(0, 1), (1, 2), (2, 3), (3, 0)];
/// let w = [1, 0, -1, 0].map(Rational::from);
/// let found = transport_at_costs(&w, &square, &[5, 5, 2, 3]).unwrap();
/// assert_eq!(found.value, Rational::from(5));
/// assert_eq!(found.heights[0] - found.heights[2], 5);
/// ```
#[must_use]
pub fn transport_at_costs<S: Real + Ord>(
    w: &[S],
    edges: &[(usize, usize)],
    costs: &[u32],
) -> Option<Transport<S>> {
    // Denominators are cleared first; otherwise every step of the flow would have them.
    let scale = Rational::from(S::common_denominator(w));
    let scaled = |w: &[S], by: &Rational| -> Vec<S> {
        let by = S::from_rational(by);
        w.iter().map(|w| w.times(&by)).collect()
    };
    let w = scaled(w, &scale);
    let found = by_rounding(&w, edges, costs).or_else(|| shortest(&w, edges, costs))?;
    let back = scale.recip();
    let value = found.value.times(&S::from_rational(&back));
    Some(Transport { value, flow: scaled(&found.flow, &back), heights: found.heights })
}
