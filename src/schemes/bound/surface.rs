//! Displacement of tensor product surfaces.

use super::displacement::{Terms, displaced};
use crate::exact::{Rational, Real};
use crate::scheme::Mask;

/// η¹_{α,β}, η²_{α,β}, η³_{α,β} of a tensor product of one mask with itself, at offset 0:
///
/// η¹ = |a_{β,0} A_α − α(n−β)/n²| + |a_{β,0} s_α|,
/// η² = |A_β − β/n| + |s_β|, η³ = |A_α A_β − αβ/n²| + |A_β s_α|,
///
/// where A_α = Σ_{h≥1} a_{α,h} and s_α = Σ_{m=1}^{N−2} ã_{α,m}; α, β = 0, …, n−1. With
/// [`Terms::Each`], |s_α| is replaced by Σ_{m=1}^{N−2} |ã_{α,m}|, and the factor Σ_r
/// a_{α,r} = 1 of |s_β| in η² by Σ_r |a_{α,r}|, as the triangle inequality gives.
///
/// Source: Mustafa et al. 2020, Theorem 7.
///
/// # Panics
/// When `alpha` or `beta` is not below the arity.
#[must_use]
pub fn surface_coefficients<S: Real>(
    mask: &Mask<S>,
    alpha: usize,
    beta: usize,
    terms: Terms,
) -> [S; 3] {
    let mask = mask.with_offset(0);
    let rows = mask.rules().rows();
    let fraction = |p: usize, q: usize| S::from_rational(&Rational::new(p, q));
    let n = mask.arity();
    let beyond = |rule: usize| S::total(&rows[rule][1..]);
    let tail = |rule: usize| terms.gather(displaced(&mask, rule).iter().skip(1));
    let first = &rows[beta][0];
    let norm = terms.gather(&rows[alpha]);
    let near = |value: S, target: S| value.minus(&target).magnitude();
    let (a, b) = (beyond(alpha), beyond(beta));
    [
        near(first.times(&a), fraction(alpha * (n - beta), n * n))
            .plus(&first.magnitude().times(&tail(alpha))),
        near(b.clone(), fraction(beta, n)).plus(&norm.times(&tail(beta))),
        near(a.times(&b), fraction(alpha * beta, n * n)).plus(&b.magnitude().times(&tail(alpha))),
    ]
}

/// ν = max_{α,β} (x_1 η¹ + x_2 η² + x_3 η³) for the spreads x_1, x_2, x_3 of the three
/// differences, with the η of [`surface_coefficients`].
///
/// Source: Mustafa et al. 2020, Theorem 8.
#[must_use]
pub fn surface_displacement<S: Real>(mask: &Mask<S>, spreads: [&S; 3], terms: Terms) -> S {
    let arity = mask.arity();
    let pairs = (0..arity).flat_map(|alpha| (0..arity).map(move |beta| (alpha, beta)));
    let weighted = |(alpha, beta)| {
        let eta = surface_coefficients(mask, alpha, beta, terms);
        eta.iter().zip(spreads).fold(S::zero(), |sum, (eta, spread)| sum.plus(&eta.times(spread)))
    };
    // Not `S::maximum`, which is at least 0: spreads may be negative here.
    pairs.map(weighted).reduce(|best, value| best.greater(&value)).unwrap_or_else(S::zero)
}

/// The sound displacement factor of a tensor product: max_{α,β} (ς_α λ_β + ς_β), where
/// ς_α = Σ_m |ã_{α,m}| belongs to the first mask, and λ_β = Σ_j |a_{β,j}| and ς_β = Σ_m
/// |ã_{β,m}| belong to the second, at the masks' offsets.
///
/// Let S be the refinement by a mask, and L the refinement by linear interpolation. Then
/// S⊗S − L⊗L = (S−L)⊗S + L⊗(S−L). Hence ‖P^{k+1} − P^k‖_∞ is at most this factor times
/// the largest difference of P^k along a mesh direction.
#[must_use]
pub fn surface_factor<S: Real>(first: &Mask<S>, second: &Mask<S>) -> S {
    let moved = |mask: &Mask<S>, rule| Terms::Each.gather(&displaced(mask, rule));
    let pairs =
        (0..first.arity()).flat_map(|alpha| (0..second.arity()).map(move |beta| (alpha, beta)));
    S::maximum(pairs.map(|(alpha, beta)| {
        let norm = S::sum_of_magnitudes(&second.rules().rows()[beta]);
        moved(first, alpha).times(&norm).plus(&moved(second, beta))
    }))
}
