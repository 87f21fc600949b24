//! Convergence of a scheme, and its limit at 0 and at parameters with repeating digits.

use super::error::{LimitError, MAX_PERIOD, MAX_WINDOW};
use super::functional::Functional;
use super::parameter::Parameter;
use crate::bound::{Budget, Order, PowerSearch, levels_within};
use crate::exact::{Rational, format, solve};
use crate::scheme::{Mask, Rules};

/// ‖Rᶜ‖ is always computed up to this number of residue classes.
const CLASSES: u64 = 1 << 10;

/// A norm below 1 is sought up to this number of residue classes; beyond it, only branch and
/// bound with at most `MOST_WORK` products of words is tried.
const MOST_CLASSES: u64 = 1 << 16;
const MOST_WORK: u64 = 1 << 25;

/// Of wide masks with long numbers, no norm takes more products of words than this.
const MOST_VISIT: u64 = 1 << 30;

/// ‖R^0‖ = 1, ‖R^1‖, …, in adjoint order: for n^c ≤ 2^10, and, while none is below 1, for
/// n^c ≤ 2^16, as far as `MOST_VISIT` suffices for a visit of all classes. Further norms follow if the last ones
/// decrease and branch and bound finds a norm below 1 with little work.
pub(super) fn contraction_constants(rules: &Rules) -> Vec<Rational> {
    let one = Rational::one();
    let mut search = PowerSearch::new(rules, Order::Adjoint);
    let mut constants = vec![one.clone()];
    let mut classes = rules.arity() as u64;
    let visited = levels_within(rules, MOST_VISIT).max(1);
    for c in 1.. {
        let contracts = constants[1..].iter().any(|constant| *constant < one);
        if classes > if contracts { CLASSES } else { MOST_CLASSES } || c > visited {
            if !contracts && fall(&constants) {
                constants.extend(first_below_one(rules, c));
            }
            break;
        }
        let norm = search.norm(c).expect("2^16 classes can be walked");
        constants.push(norm.value);
        classes = classes.saturating_mul(rules.arity() as u64);
    }
    constants
}

/// The least computed c with ‖R^c‖ < 1, if there is one.
#[must_use]
pub fn first_contraction(rules: &Rules) -> Option<u32> {
    let constants = contraction_constants(rules);
    let c = constants.iter().position(|constant| *constant < Rational::one());
    c.and_then(|c| u32::try_from(c).ok())
}

/// Whether the last constant is less than the one before. If not, a constant below 1 is not
/// expected soon.
fn fall(constants: &[Rational]) -> bool {
    constants.windows(2).next_back().is_some_and(|pair| pair[1] < pair[0])
}

/// ‖R^c‖, ‖R^{c+1}‖, … up to the first one below 1, with c = `first`; empty if none is
/// found within the work.
fn first_below_one(rules: &Rules, first: u32) -> Vec<Rational> {
    let search = PowerSearch::new(rules, Order::Adjoint);
    let mut search = search.with_budget(Budget::new(MOST_WORK));
    let mut constants = Vec::new();
    for c in first.. {
        let Some(found) = search.search(c) else { return Vec::new() };
        constants.push(found.norm.value);
        if constants[constants.len() - 1] < Rational::one() {
            break;
        }
    }
    constants
}

/// lim x^k_0 as a functional of the control points.
///
/// The rows l, …, h of the scheme have no column outside l, …, h when l − ⌊l/n⌋ ≤ o and h
/// − ⌊h/n⌋ ≥ o + N − 1. On this window the functional is the w with w = wA and Σ w_i = 1,
/// where A is the matrix of these rows. 1 is a simple eigenvalue exactly if there is only
/// one such w (`proofs/THEOREMS.md`, 3). The first equation of w(A − 1) = 0 follows from
/// the others, since the rows of A sum to 1. It is replaced by Σ w_i = 1.
pub(super) fn limit_at_zero(mask: &Mask) -> Result<Functional, LimitError> {
    let arity = i64::try_from(mask.arity()).expect("the arity is capped");
    let width = i64::try_from(mask.width()).expect("the width is capped");
    // l − ⌊l/n⌋ = ⌈l(n−1)/n⌉. Take the least l at which this is o, and the greatest h at
    // which it is o + N − 1.
    let first = (arity * (mask.offset() - 1)).div_euclid(arity - 1) + 1;
    let last = (arity * (mask.offset() + width - 1)).div_euclid(arity - 1);
    invariant(first, last, |i| Functional::point(i).after(mask.rules()))
}

/// The only w on a window with w = wB and Σ w_i = 1, for a matrix B whose rows have this window and sum to 1.
fn invariant(
    first: i64,
    last: i64,
    row: impl Fn(i64) -> Functional,
) -> Result<Functional, LimitError> {
    let size = usize::try_from(last - first + 1).expect("the window is not empty");
    if size > MAX_WINDOW {
        return Err(LimitError::Window(size));
    }
    let at = |i: i64| usize::try_from(i - first).expect("the window is invariant");
    let mut equations = vec![vec![Rational::zero(); size + 1]; size];
    for i in first..=last {
        for (column, coefficient) in row(i).terms() {
            equations[at(column)][at(i)] += coefficient;
        }
        equations[at(i)][at(i)] -= &Rational::one();
    }
    // The equations sum to 0, as the rows of B sum to 1.
    equations[0] = vec![Rational::one(); size + 1];
    let weights = solve(&equations).ok_or(LimitError::NoLimit { first, last })?;
    Ok(Functional::new(first, weights))
}

/// P^∞(t) as a functional of the control points, for 0 ≤ t < 1 with purely periodic n-adic digits.
///
/// With l ≤ ⌊l/n⌋ + o and ⌊(h + n − 1)/n⌋ + o + N − 1 ≤ h, the points at the indices l, …, h
/// around ⌊n^k t⌋ of level k are determined by those around ⌊n^{k−1} t⌋ of level k − 1. After one
/// period the limit is the same functional of them again: the w with w = wB and Σ w_i = 1, where B
/// is the matrix of one period. It is the only such w if the scheme converges.
///
/// Source: `proofs/THEOREMS.md`, 82.
pub(super) fn limit_at_repeating(mask: &Mask, t: &Rational) -> Result<Functional, LimitError> {
    let arity = mask.arity();
    let refused = || LimitError::Parameter { parameter: format::short(t, 12), arity };
    let period = Parameter::period(t, arity, MAX_PERIOD).ok_or_else(refused)?;
    let (first, last) = window(mask);
    invariant(first, last, |i| period.pull_back(&Functional::point(i), mask.rules()))
}

/// The l and h that are nearest to 0.
fn window(mask: &Mask) -> (i64, i64) {
    let arity = i64::try_from(mask.arity()).expect("the arity is capped");
    let width = i64::try_from(mask.width()).expect("the width is capped");
    let (mut first, mut last) = (0_i64, 0_i64);
    while first > first.div_euclid(arity) + mask.offset() {
        first -= 1;
    }
    while (last + arity - 1).div_euclid(arity) + mask.offset() + width - 1 > last {
        last += 1;
    }
    (first, last)
}
