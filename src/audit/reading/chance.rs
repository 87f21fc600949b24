//! How likely a reading explains a table by luck.

use crate::claim::Printed;
use crate::exact::{Integer, Rational};

/// The chance beyond which a reading is not reported: one in a thousand.
const MAX_CHANCE: i64 = 1_000;

/// Of a hundred readings of unrelated values, the one that explains most explains
/// some cells by luck: an upper bound on how many tables of random digits would be
/// explained so well.
///
/// `cells` are the printed numbers, each with the number of values it could have
/// been taken for: a decimal of d significant digits one of 9·10^(d−1), a depth
/// one of as many as the table shows different ones. A number of `readings` was
/// tried, and one explains `explained` cells, of which `free` are used up by
/// parameters that were solved for. Then the expected number of readings that do as
/// well is at most readings · C(n, m) / Π of the m smallest of those numbers.
pub(super) fn chance(cells: &[Integer], explained: usize, free: usize, readings: usize) -> Rational {
    let counted = explained.saturating_sub(free);
    let mut possibilities = cells.to_vec();
    possibilities.sort();
    let subsets = (0..counted).fold(Integer::one(), |binomial, i| {
        (binomial * Integer::from(cells.len() - i)).div_floor(&Integer::from(i + 1))
    });
    let product = possibilities[..counted].iter().fold(Integer::one(), |p, count| p * count);
    Rational::new(Integer::from(readings) * subsets, product)
}

/// Whether that is unlikely enough to be reported.
pub(super) fn is_small(chance: &Rational) -> bool {
    *chance <= Rational::new(1, MAX_CHANCE)
}

/// The number of values that a printed number could have been taken for.
pub(super) fn possibilities(printed: &Printed, depths: Option<usize>) -> Integer {
    match depths {
        Some(different) => Integer::from(different.max(2)),
        None => {
            let digits = u32::try_from(printed.decimal.significant_digits().max(1)).unwrap_or(1);
            Integer::from(9) * Integer::power_of_ten(digits - 1)
        }
    }
}
