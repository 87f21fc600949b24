//! What the literature says of the eigenvalues.

use super::spectrum;
use crate::common::r;
use subcert::exact::RealExpression;
use subcert::float::nearest;
use subcert::spectrum::Curvature::{Bounded, Growing, Unbounded, Vanishing};
use subcert::spectrum::surroundings;

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
    let g = Growing;
    assert_eq!(of("doo-sabin"), [Bounded, Bounded, g, g, g, g, g]);
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

/// Block 2 of the wider ring, iterated in f64 and scaled by λ^−2: it grows like the number of steps where the eigenvalue
/// λ² has a Jordan block, and stays bounded otherwise.
#[test]
fn jordan_blocks_let_curvature_grow() {
    for (scheme, n, growing) in [
        ("doo-sabin", 4, false),
        ("doo-sabin", 5, true),
        ("doo-sabin", 8, true),
        ("loop", 6, false),
        ("catmull-clark", 4, false),
    ] {
        let rings = surroundings(scheme, Some(n)).expect("a valence");
        let ring = rings.wider.as_ref().expect("a wider ring");
        let conditions = rings.spectrum().expect("a spectrum").conditions;
        assert_eq!(conditions.curvature == Some(Growing), growing, "{scheme} {n}");
        let weight = |a, b| nearest(ring.weights().entry(a, b));
        let count = ring.point_count();
        let matrix: Vec<Vec<f64>> =
            (0..count).map(|a| (0..count).map(|b| weight(a, b)).collect()).collect();
        let mut points = Vec::new();
        for orbit in ring.orbits() {
            for i in 0..orbit.count {
                let turn = f64::from(u8::try_from(2 * i).expect("few points"));
                let order = f64::from(u8::try_from(n).expect("few points"));
                let turn = 2.0 * std::f64::consts::PI * turn / order;
                points.push(if orbit.count == 1 { 0.0 } else { turn.cos() });
            }
        }
        let mut sizes = Vec::new();
        for step in 1..=18 {
            points = matrix
                .iter()
                .map(|row| 4.0 * row.iter().zip(&points).map(|(w, x)| w * x).sum::<f64>())
                .collect();
            if step % 6 == 0 {
                sizes.push(points.iter().fold(0.0_f64, |most, x| most.max(x.abs())));
            }
        }
        let steps = [sizes[1] - sizes[0], sizes[2] - sizes[1]];
        if growing {
            assert!((0.9..1.1).contains(&(steps[1] / steps[0])), "{scheme} {n}: {sizes:?}");
        } else {
            assert!(steps[1].abs() < 1e-3 * sizes[0], "{scheme} {n}: {sizes:?}");
        }
    }
}
