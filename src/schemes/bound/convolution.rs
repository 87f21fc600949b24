//! The coefficients of repeated convolution, by their recursions.

use super::power::Order;
use crate::exact::Scalar;
use crate::scheme::Rules;

/// How the coefficients of c convolutions are computed from the coefficients of fewer
/// convolutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Recursion {
    /// E^c_{l,f} = Σ_e E^1_{l,e} E^{c−1}_{e,f}: the correct recursion for c convolutions.
    Derived,
    /// `E^c_{l,f} = Σ_e E^{c−1}_{l,e} E^{c−1}_{e,f}`, as printed in some papers. For c ≥
    /// 3 it gives 2^{c−1} convolutions rather than c.
    Printed,
}

/// The sequence t_{nu+β} of rules r: r_{β,N−1−u} in adjoint, r_{β,u} in forward
/// order, with u = 0, …, N−1 and β = 0, …, n−1.
#[must_use]
pub fn sequence<S: Scalar>(rules: &Rules<S>, order: Order) -> Vec<S> {
    let last = rules.width() - 1;
    let column = |u: usize| match order {
        Order::Adjoint => last - u,
        Order::Forward => u,
    };
    let rows = rules.rows();
    (0..=last).flat_map(|u| rows.iter().map(move |row| row[column(u)].clone())).collect()
}

/// E^c_{l,f} of the sequence t of a scheme of arity n: E^1_{l,f} = t_{f−nl}, 0 outside
/// the sequence, and for c ≥ 2 the sum of the recursion over e = nl, …, ⌊f/n^{c−1}⌋.
///
/// This evaluates the definition term by term. [`power_norm`](super::power_norm) does not
/// use it. It visits about N^{c−1} terms, or N^{2^{c−1}−1} by the printed recursion.
///
/// Source: Mustafa et al. 2020, (6) and (26).
///
/// # Panics
/// When c is 0.
///
/// ```
/// use subcert::bound::{Order, Recursion, convolution_coefficient, sequence};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("chaikin")?;
/// let t = sequence(&scheme.masks()[0].difference(), Order::Adjoint);
/// assert_eq!(t, [0, 1, 2, 1].map(|p| Rational::new(p, 4)));
/// // The coefficient of z^3 in t(z)·t(z^2).
/// let e = convolution_coefficient(&t, 2, 2, 0, 3, Recursion::Derived);
/// assert_eq!(e, Rational::new(1, 16));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn convolution_coefficient<S: Scalar>(
    sequence: &[S],
    arity: usize,
    c: u32,
    l: i64,
    f: i64,
    recursion: Recursion,
) -> S {
    assert!(c > 0, "at least one convolution");
    let n = i64::try_from(arity).expect("the arity is capped");
    if c == 1 {
        let position = usize::try_from(f - n * l).ok();
        return position.and_then(|at| sequence.get(at)).cloned().unwrap_or_else(S::zero);
    }
    let last = f.div_euclid(n.pow(c - 1));
    let left = |e: i64| match recursion {
        Recursion::Derived => convolution_coefficient(sequence, arity, 1, l, e, recursion),
        Recursion::Printed => convolution_coefficient(sequence, arity, c - 1, l, e, recursion),
    };
    // For e beyond the end of the left factor, every term is 0.
    let length = i64::try_from(sequence.len()).expect("it fits in memory");
    let reach = match recursion {
        Recursion::Derived => n * l + length - 1,
        Recursion::Printed => last,
    };
    (n * l..=last.min(reach)).fold(S::zero(), |sum, e| {
        let right = convolution_coefficient(sequence, arity, c - 1, e, f, recursion);
        sum.plus(&left(e).times(&right))
    })
}

/// E^c_{l,f} for all l = 0, …, ⌊f/n^c⌋, one list for each f of the window max(0, `last` −
/// n^c + 1), …, `last`: a constant of c convolutions is the greatest absolute sum of
/// these lists. The coefficients equal those of [`convolution_coefficient`].
///
/// E^c_{l,f} depends only on f − n^e l, where e = c for the derived and e = 2^(c−1) for
/// the printed recursion. So one product of sequences, truncated after `last`, gives all
/// coefficients, with O(`last`·N) operations for each convolution.
///
/// Source: Khan et al. 2022, (9)–(13).
///
/// # Panics
/// When c or the arity is 0.
///
/// ```
/// use subcert::bound::{Recursion, convolution_window};
/// use subcert::exact::Rational;
///
/// // (1 + z)(1 + z²)/4 has four coefficients 1/4: one for each class mod 4.
/// let half = Rational::new(1, 2);
/// let window = convolution_window(&[half.clone(), half], 2, 2, 3, Recursion::Derived);
/// assert_eq!(window, vec![vec![Rational::new(1, 4)]; 4]);
/// ```
#[must_use]
pub fn convolution_window<S: Scalar>(
    sequence: &[S],
    arity: usize,
    c: u32,
    last: usize,
    recursion: Recursion,
) -> Vec<Vec<S>> {
    assert!(c > 0 && arity > 0, "at least one convolution, of an arity of at least 1");
    let length = last + 1;
    let power = |exponent: u32| arity.checked_pow(exponent).unwrap_or(length).min(length);
    let mut product: Vec<S> = sequence.iter().take(length).cloned().collect();
    // The number of convolutions so far.
    let mut factors = 1_u32;
    for _ in 1..c {
        (product, factors) = match recursion {
            Recursion::Derived => (spread(sequence, &product, power(factors), length), factors + 1),
            Recursion::Printed => {
                (spread(&product, &product, power(factors), length), factors.saturating_mul(2))
            }
        };
    }
    let (rows, stride) = (power(c), power(factors));
    let at = |f: usize, l: usize| {
        let position = stride.checked_mul(l).and_then(|skipped| f.checked_sub(skipped));
        position.and_then(|at| product.get(at)).cloned().unwrap_or_else(S::zero)
    };
    (length - rows..length).map(|f| (0..=f / rows).map(|l| at(f, l)).collect()).collect()
}

/// left(z^step)·right(z), truncated to `length` coefficients.
fn spread<S: Scalar>(left: &[S], right: &[S], step: usize, length: usize) -> Vec<S> {
    let degree = left.len().saturating_sub(1).saturating_mul(step);
    let length = length.min(degree.saturating_add(right.len()));
    let mut product = vec![S::zero(); length];
    for (i, a) in left.iter().enumerate().take_while(|(i, _)| i * step < length) {
        for (sum, b) in product[i * step..].iter_mut().zip(right) {
            *sum = sum.plus(&a.times(b));
        }
    }
    product
}
