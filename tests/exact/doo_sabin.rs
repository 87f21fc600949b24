//! The refinement of a Doo–Sabin face: w_0 = (n+5)/4n, w_j = (3 + 2cos(2πj/n))/4n.

use subcert::exact::{Rational, RealCyclotomic, Scalar as _};

fn rational(p: i64, q: i64) -> RealCyclotomic {
    RealCyclotomic::from(Rational::new(p, q))
}

fn cosine(j: i64, n: i64) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(j, n)).expect("a small conductor")
}

fn weights(n: i64) -> Vec<RealCyclotomic> {
    let weight = |j: i64| match j {
        0 => rational(n + 5, 4 * n),
        _ => &rational(3, 4 * n) + &(&rational(2, 4 * n) * &cosine(j, n)),
    };
    (0..n).map(weight).collect()
}

/// Σ_j w_j cos(2πjm/n), m = 0, …, n − 1.
fn eigenvalues(n: i64) -> Vec<RealCyclotomic> {
    let weights = weights(n);
    let eigenvalue = |m: i64| {
        let terms = weights.iter().zip(0..).map(|(w, j)| w * &cosine(j * m, n));
        terms.fold(rational(0, 1), |sum, term| &sum + &term)
    };
    (0..n).map(eigenvalue).collect()
}

#[test]
fn weights_sum_to_one() {
    for n in (3..=40).chain([148, 499, 500]) {
        assert_eq!(RealCyclotomic::total(&weights(n)), rational(1, 1), "{n}");
        assert!(weights(n).iter().all(|weight| weight.sign() > 0), "{n}");
    }
}

#[test]
fn eigenvalues_are_one_half_and_a_quarter() {
    for n in (3..=16).chain([37, 60]) {
        for (m, eigenvalue) in eigenvalues(n).iter().zip(0..) {
            let wanted = match eigenvalue {
                0 => rational(1, 1),
                m if m == 1 || m == n - 1 => rational(1, 2),
                _ => rational(1, 4),
            };
            assert_eq!(*m, wanted, "{eigenvalue} of {n}");
        }
    }
}

// For n = 4 these are the weights 9/16, 3/16, 1/16 of the biquadratic B-spline.
#[test]
fn a_square_face_is_biquadratic() {
    let sixteenth = |p| rational(p, 16);
    assert_eq!(weights(4), [9, 3, 1, 3].map(sixteenth));
}
