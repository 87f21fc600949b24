//! Whether a scheme converges, and its limit at 0.

use super::error::{LimitError, MAX_WINDOW};
use super::functional::{Functional, rule_at};
use crate::bound::{Order, power_norm};
use crate::exact::{Rational, solve};
use crate::scheme::{Mask, Rules};

/// The residue classes up to which ‖Rᶜ‖ is computed in any case.
const CLASSES: u64 = 1 << 10;

/// The residue classes up to which a norm below 1 is looked for.
const MOST_CLASSES: u64 = 1 << 16;

/// ‖R^0‖ = 1, ‖R^1‖, …, in adjoint order: for n^c ≤ 2^10, and for n^c ≤ 2^16 while
/// none is below 1.
pub(super) fn contraction_constants(rules: &Rules) -> Vec<Rational> {
    let one = Rational::one();
    let mut constants = vec![one.clone()];
    let mut classes = rules.arity() as u64;
    for c in 1.. {
        let contracts = constants[1..].iter().any(|constant| *constant < one);
        if classes > if contracts { CLASSES } else { MOST_CLASSES } {
            break;
        }
        let norm = power_norm(rules, c, Order::Adjoint).expect("2^16 classes can be walked");
        constants.push(norm.value);
        classes = classes.saturating_mul(rules.arity() as u64);
    }
    constants
}

/// lim x^k_0 as a functional of the control points.
///
/// The rows l, …, h of the scheme have no column outside l, …, h when
/// l − ⌊l/n⌋ ≤ o and h − ⌊h/n⌋ ≥ o + N − 1. On this window the functional is the w
/// with w = wA and Σ w_i = 1, and 1 is a simple eigenvalue exactly when w is the only
/// one (`proofs/THEOREMS.md`, 3). Of w(A − 1) = 0 the first equation follows from the
/// others, since the rows of A sum to 1; Σ w_i = 1 takes its place.
pub(super) fn limit_at_zero(mask: &Mask) -> Result<Functional, LimitError> {
    let arity = i64::try_from(mask.arity()).expect("the arity is capped");
    let width = i64::try_from(mask.width()).expect("the width is capped");
    // l − ⌊l/n⌋ = ⌈l(n−1)/n⌉: the least l at which it is o, the greatest h.
    let first = (arity * (mask.offset() - 1)).div_euclid(arity - 1) + 1;
    let last = (arity * (mask.offset() + width - 1)).div_euclid(arity - 1);
    let size = usize::try_from(last - first + 1).expect("the window is not empty");
    if size > MAX_WINDOW {
        return Err(LimitError::Window(size));
    }
    let at = |i: i64| usize::try_from(i - first).expect("the window is invariant");
    let mut equations = vec![vec![Rational::zero(); size + 1]; size];
    for i in first..=last {
        for (column, coefficient) in rule_at(mask.rules(), i) {
            equations[at(column)][at(i)] += coefficient;
        }
        equations[at(i)][at(i)] -= &Rational::one();
    }
    equations[0] = vec![Rational::one(); size + 1];
    let weights = solve(&equations).ok_or(LimitError::NoLimit { first, last })?;
    Ok(Functional::new(first, weights))
}
