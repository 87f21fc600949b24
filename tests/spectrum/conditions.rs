//! What the literature says of the eigenvalues.

use super::spectrum;
use crate::common::r;
use subcert::exact::RealExpression;
use subcert::spectrum::Curvature::{Bounded, Unbounded, Vanishing};

// Loop 1987 chose the weights for block 0; the curvature is unbounded from valence 7 on by block 2, and at
// valence 3 by the points of the second ring. Doo–Sabin: μ = 1/4 at every valence (Doo and Sabin 1978).
// Catmull–Clark: unbounded above valence 4.
#[test]
fn curvature_by_valence() {
    let of = |scheme: &str| -> Vec<_> {
        (3..=9).map(|n| spectrum(scheme, n).conditions.curvature.expect("a comparison")).collect()
    };
    let u = Unbounded;
    assert_eq!(of("loop"), [u, Bounded, Bounded, Bounded, u, u, u]);
    assert_eq!(of("loop-warren"), [u, u, u, Bounded, u, u, u]);
    assert_eq!(of("doo-sabin"), [Bounded; 7]);
    assert_eq!(of("catmull-clark"), [Vanishing, Bounded, u, u, u, u, u]);
    assert_eq!(of("sqrt3"), [u, Bounded, Bounded, Bounded, u, u, u]);
}

#[test]
fn moduli_after_the_subdominant_one() {
    let conditions = spectrum("loop", 3).conditions;
    assert_eq!(conditions.subdominant, Some(RealExpression::from(r(1, 4))));
    assert_eq!(conditions.next, Some(RealExpression::from(r(1, 8))));
    assert!(conditions.simple_one);
}
