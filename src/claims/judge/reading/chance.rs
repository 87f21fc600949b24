//! How likely a reading explains a table by luck.

use crate::claim::Printed;
use crate::exact::{Integer, Rational};

/// A reading is reported if luck gives as good a reading in at most one of this many tables of
/// unrelated numbers.
const MOST_LUCK: i64 = 1_000;

/// The number of values that a wrong reading of a depth is thought to give with the same
/// likelihood: it is often a level or two off.
const LIKELY_DEPTHS: i64 = 4;

/// The fewest cells that a reading explains, where there are so many. One cell of several is no explanation, whatever
/// its odds are.
pub(crate) const LEAST_CELLS: usize = 2;

/// An upper bound on how many readings of unrelated values would explain `m` of these
/// cells: candidates · e_m(p_1, …, p_n), where the candidates are the readings, each with every
/// value of a recovered parameter that is as plain as its own; p_i is how likely an unrelated value
/// becomes the i-th printed number, and e_m the elementary symmetric polynomial, which
/// bounds how likely m of n independent events happen (`proofs/THEOREMS.md`, 51).
///
/// m is the number of cells that are explained beyond those that are as printed anyway. Cells that
/// are certain, p_i = 1, are left out, and m is less by their number.
pub(crate) fn chance(likelihoods: &[Rational], m: usize, candidates: Integer) -> Rational {
    let one = Rational::one();
    let telling: Vec<&Rational> = likelihoods.iter().filter(|p| **p != one).collect();
    let m = m.saturating_sub(likelihoods.len() - telling.len());
    // e_0, …, e_m of the likelihoods so far.
    let mut symmetric = vec![Rational::zero(); m + 1];
    symmetric[0] = Rational::one();
    for p in telling {
        for k in (1..=m).rev() {
            let more = &symmetric[k - 1] * p;
            symmetric[k] += &more;
        }
    }
    &symmetric[m] * Rational::from(candidates)
}

/// Whether a chance is so small that a reading is reported.
pub(crate) fn is_small(chance: &Rational) -> bool {
    *chance <= Rational::new(1, MOST_LUCK)
}

/// How likely an unrelated value becomes this decimal: with d significant digits,
/// 1 in 9·10^(d−1); the zeros at its end do not count. That a number is printed as 0
/// tells nothing: what makes one value small may make all of them small.
pub(crate) fn of_decimal(printed: &Printed) -> Rational {
    if printed.decimal.mantissa().is_zero() {
        return Rational::one();
    }
    let digits = printed.decimal.mantissa().abs().to_string();
    let digits = digits.trim_end_matches('0').len();
    let digits = u32::try_from(digits).unwrap_or(u32::MAX).min(10_000);
    Rational::new(Integer::one(), Integer::from(9) * Integer::power_of_ten(digits - 1))
}

/// How likely a wrong reading gives a depth.
pub(crate) fn of_depth() -> Rational {
    Rational::new(1, LIKELY_DEPTHS)
}
