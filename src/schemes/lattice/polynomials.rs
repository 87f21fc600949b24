//! What a mask on Z^d does to polynomials: sum rules, the natural shift, reproduction.

use super::monomials::{of_degree, power, power_of};
use crate::exact::{Rational, Real, Scalar, only_solution};
use crate::scheme::LatticeMask;

/// The highest order of sum rules that is looked for.
pub const MAX_ORDER: u32 = 64;

/// The order K of the sum rules: the greatest for which the moments Σ_{γ ≡ ε} a(γ)γ^μ, |μ| < K, are the same for all classes ε of Z^d/MZ^d.
///
/// Then S takes a polynomial p of degree j < K to p∘M^{−1} plus terms of lower degree, and all polynomials of degree K − 1 are generated.
///
/// ```
/// use subcert::lattice::sum_rules;
/// use subcert::scheme::parse_lattice;
///
/// // The box spline of Loop's scheme, and the mask of the butterfly scheme.
/// let quartic = parse_lattice("(1+x)^2*(1+y)^2*(1+x*y)^2/16")?;
/// assert_eq!(sum_rules(&quartic), 4);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn sum_rules<S: Scalar + PartialEq>(mask: &LatticeMask<S>) -> u32 {
    let classes: Vec<usize> =
        mask.coefficients().keys().map(|place| mask.dilation().split(*place).0).collect();
    let holds = |k: &u32| {
        of_degree(*k, mask.dimension()).into_iter().all(|exponents| {
            let mut sums = vec![S::zero(); mask.dilation().class_count()];
            for ((place, c), class) in mask.coefficients().iter().zip(&classes) {
                sums[*class].accumulate(&c.times(&S::from_rational(&power(*place, exponents))));
            }
            sums.iter().all(|sum| *sum == sums[0])
        })
    };
    (0..MAX_ORDER).take_while(holds).last().map_or(0, |k| k + 1)
}

/// m_1 = (1/m) Σ_γ γ a(γ), the mean of the places.
#[must_use]
pub fn mean<S: Scalar>(mask: &LatticeMask<S>) -> Vec<S> {
    let scale = S::from_rational(&Rational::from(mask.dilation().class_count()).recip());
    let coordinate = |axis: usize| {
        let terms = mask.coefficients().iter();
        let terms = terms.map(|(place, c)| c.times(&S::from_rational(&place[axis].into())));
        terms.fold(S::zero(), |sum, term| sum.plus(&term)).times(&scale)
    };
    (0..mask.dimension()).map(coordinate).collect()
}

/// τ = (M − I)^{−1} m_1, the centre of mass of the basic limit function φ.
///
/// With sum rules of order 2 it is the only shift with which lines are reproduced: the point p_β of the data stands at β + τ, and the point α of
/// level k at M^{−k}(α + τ).
///
/// # Panics
/// Never: 1 is no eigenvalue of M.
#[must_use]
pub fn natural_shift<S: Real + PartialEq>(mask: &LatticeMask<S>) -> Vec<S> {
    let rows = mask.dilation().rows().enumerate().zip(mean(mask));
    let row = |((i, row), right): ((usize, &[i64]), S)| {
        let entries = row.iter().enumerate().map(|(j, x)| Rational::from(x - i64::from(i == j)));
        entries.map(|x| S::from_rational(&x)).chain([right]).collect()
    };
    only_solution(rows.map(row).collect::<Vec<Vec<S>>>()).expect("1 is no eigenvalue of M")
}

/// The degree k up to which polynomials are reproduced at the natural shift: there are sum rules of order k + 1, and Σ_γ a(γ)(γ − m_1)^μ = 0 for
/// 1 ≤ |μ| ≤ k.
#[must_use]
pub fn reproduction<S: Scalar + PartialEq>(mask: &LatticeMask<S>) -> u32 {
    let mean = mean(mask);
    let centred: Vec<(Vec<S>, &S)> = mask
        .coefficients()
        .iter()
        .map(|(place, c)| {
            let place = place.iter().zip(&mean);
            (place.map(|(x, m)| S::from_rational(&(*x).into()).minus(m)).collect(), c)
        })
        .collect();
    let vanishes = |k: &u32| {
        of_degree(*k, mask.dimension()).into_iter().all(|exponents| {
            let moment = centred
                .iter()
                .fold(S::zero(), |sum, (place, c)| sum.plus(&c.times(&power_of(place, exponents))));
            moment == S::zero()
        })
    };
    (1..sum_rules(mask)).take_while(vanishes).last().unwrap_or(0)
}
