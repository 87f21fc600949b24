//! Sobolev exponents.

use crate::exact::{Adjugate, Rational};
use crate::joint::Entry;
use crate::smoothness::formula::ExponentFormula;
use crate::smoothness::independence::independent;
use crate::smoothness::symbol::Symbol;

/// The most rows of the matrix whose spectral radius is taken.
const MAX_ROWS: usize = 40;

/// The supremum of all s with |ξ|^s φ̂(ξ) in L² for large |ξ|, of the basic limit function φ, in the sense of distributions; `None`
/// beyond the caps.
///
/// Let the shifts of φ be linearly independent; otherwise φ is a combination of shifts of a function of which they are, and which
/// is as smooth. With A = σ^K B, b = n^{K−1}B and c_k = Σ_i b_{i+k} b_i, the transfer operator (Pf)_k = n Σ_j c_{nk−j} f_j takes
/// the coefficients of a cosine polynomial f to those of Σ_r |b|²f((ξ + 2πr)/n), and ∫ |φ̂|² over |ξ| from n^{j−1}π to n^jπ
/// is of the size n^{−2jK} ρ^j, ρ its spectral radius. So s = K − log_n(ρ)/2. Since P maps non-negative functions to such, ρ is its
/// greatest real eigenvalue, with an even eigenvector. `proofs/THEOREMS.md`, 137.
///
/// ```
/// use subcert::exact::{Enclosed, Rational};
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, sobolev_exponent};
///
/// let of = |name| sobolev_exponent(&Symbol::of(parse_scheme(name).unwrap().masks()[0])).expect("short masks");
/// // A spline of degree d is in H^s for s < d + 1/2.
/// assert_eq!(of("b-spline:degree=3").as_rational(), Some(&Rational::new(7, 2)));
/// // Of the four-point scheme ρ is a root of x² − 5x − 32.
/// assert!(of("four-point:w=1/16").to_string().starts_with("4 - 1/2*log_2(x), x = 8.684658"));
/// ```
#[must_use]
pub fn sobolev_exponent<F: Entry>(symbol: &Symbol<F>) -> Option<ExponentFormula> {
    let symbol = independent(symbol);
    let n = symbol.arity();
    let (order, rest) = symbol.sum_rules();
    let coefficients = rest.coefficients();
    let last = coefficients.len().saturating_sub(1);
    let rows = last / (n - 1) + 1;
    if rows > MAX_ROWS {
        return None;
    }
    let scale = (1..2 * order).fold(Rational::one(), |power, _| power * Rational::from(n));
    let scale = F::from_rational(&scale);
    let correlation: Vec<F> = (0..=last)
        .map(|k| {
            let pairs = coefficients[k..].iter().zip(coefficients);
            let sum = pairs.fold(F::zero(), |sum, (a, b)| sum.plus(&a.times(b)));
            sum.times(&scale)
        })
        .collect();
    // n·c_k; `scale` is n^{2K−1}.
    let c = |k: usize| correlation.get(k).cloned().unwrap_or_else(F::zero);
    let entry = |k: usize, j: usize| {
        let near = c((n * k).abs_diff(j));
        if j == 0 { near } else { near.plus(&c(n * k + j)) }
    };
    let matrix: Vec<Vec<F>> = (0..rows).map(|k| (0..rows).map(|j| entry(k, j)).collect()).collect();
    let characteristic = Adjugate::of(&matrix).characteristic;
    let root = F::real_roots(&characteristic)?.pop()?;
    Some(ExponentFormula::new(order, n, &root, 2))
}
