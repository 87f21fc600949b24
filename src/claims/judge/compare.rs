//! A printed decimal against an exact value.

use crate::exact::{Decimal, Enclosed, Integer, Rational, RealCyclotomic, Rounding};
use crate::finding::{Direction, Slip, Values, Verdict};

/// The digits that a slip needs before it is more than luck: a number of d random digits is any
/// slip away from the exact value, all kinds together, at most once in a thousand times. There are
/// 9·10^(d−1) such numbers. The sign leads to 2 of them, as rounded up or down; the point, off by up
/// to 3 places either way, to 6; four neighbours to 8; another digit that is not the last to
/// 9d − 10 of the value rounded to the nearest, and as many of it cut; two digits exchanged to d − 1
/// each. With d = 5 these are 2 + 6 + 8 + 35 + 4 = 55 of 90,000 without the cut value, and with
/// d = 6, 16 + 2·(44 + 5) = 114 of 900,000. Zeros at the end do not count: 0.1600 for 0.1400 says no
/// more than 0.16 for 0.14.
const DIGITS_FOR_SLIP: usize = 5;

/// The digits that a slip needs if it changes or exchanges digits of the value cut.
const DIGITS_FOR_CUT: usize = 6;

/// The digits that two exchanged numbers need together, each of them one at least:
/// with four neighbours, luck finds such a pair once in 5,000 times.
const DIGITS_FOR_EXCHANGED: usize = 5;

/// The digits that a number needs to be explained by another reading in all places but
/// the last.
const DIGITS_FOR_ROUNDING: usize = 3;

/// How far the decimal point may be off.
const MAX_EXPONENT_SLIP: i32 = 3;

/// The verdict on `printed` for the value `exact`; `neighbours` are the exact
/// values of the cells around it with their direction.
pub(crate) fn judge(
    printed: &Decimal,
    exact: &RealCyclotomic,
    neighbours: &[((i32, i32), &RealCyclotomic)],
) -> Verdict {
    match printed.rounding_of(exact) {
        Rounding::Exact | Rounding::Nearest => Verdict::Confirmed,
        // Of a value that is cut some digit is left: 0 is no 0.857.
        Rounding::Cut if printed.significant_digits() > 0 => Verdict::Rounding(Direction::Cut),
        Rounding::Up => Verdict::Rounding(Direction::Away),
        Rounding::Cut | Rounding::Neither => {
            find_slip(printed, exact, neighbours).map_or(Verdict::Refuted, Verdict::Misprint)
        }
    }
}

/// The values beside, above and below a cell, with their direction: rows down, columns
/// to the right.
pub(crate) fn around(
    values: &Values,
    row: usize,
    column: usize,
) -> Vec<((i32, i32), &RealCyclotomic)> {
    let steps = [(0, 1), (0, -1), (1, 0), (-1, 0)].into_iter();
    let value = |step| {
        let (row, column) = moved(row, column, step)?;
        Some((step, values.get(row)?.get(column)?.as_ref()?))
    };
    steps.filter_map(value).collect()
}

/// The place that is so many rows down and columns to the right.
pub(crate) fn moved(row: usize, column: usize, step: (i32, i32)) -> Option<(usize, usize)> {
    let row = row.checked_add_signed(step.0 as isize)?;
    Some((row, column.checked_add_signed(step.1 as isize)?))
}

/// Whether two cells, with what is printed and the exact value of each, are exchanged.
pub(crate) fn exchanged(
    first: &Decimal,
    first_exact: &RealCyclotomic,
    second: &Decimal,
    second_exact: &RealCyclotomic,
) -> bool {
    let (digits, other) = (first.telling_digits().len(), second.telling_digits().len());
    digits.min(other) > 0
        && digits + other >= DIGITS_FOR_EXCHANGED
        && !matches(first, first_exact)
        && !matches(second, second_exact)
        && matches(first, second_exact)
        && matches(second, first_exact)
}

/// Whether `exact` becomes `printed` by some rounding.
pub(crate) fn matches(printed: &Decimal, exact: &RealCyclotomic) -> bool {
    printed.rounding_of(exact) != Rounding::Neither
}

/// Whether a number that agrees up to its last place agrees by more than luck.
pub(crate) fn says_enough(printed: &Decimal) -> bool {
    printed.telling_digits().len() >= DIGITS_FOR_ROUNDING
}

fn find_slip(
    printed: &Decimal,
    exact: &RealCyclotomic,
    neighbours: &[((i32, i32), &RealCyclotomic)],
) -> Option<Slip> {
    let digits = printed.telling_digits().len();
    if digits < DIGITS_FOR_SLIP {
        return None;
    }
    if matches(printed, &-exact) {
        return Some(Slip::Sign);
    }
    let places = (1..=if printed.is_fraction() { 0 } else { MAX_EXPONENT_SLIP })
        .flat_map(|places| [places, -places]);
    let moved = |places: i32| exact * &RealCyclotomic::from(Rational::power_of_ten(places));
    if let Some(places) = places.into_iter().find(|&places| {
        matches!(printed.rounding_of(&moved(places)), Rounding::Exact | Rounding::Nearest)
    }) {
        return Some(Slip::Exponent(places));
    }
    let same = neighbours.iter().find(|(_, value)| *value != exact && matches(printed, value));
    if let Some(((rows, columns), _)) = same {
        return Some(Slip::Neighbour(*rows, *columns));
    }
    // A fraction has no point to move, and no value was rounded to its digits.
    if printed.is_fraction() || printed.value().sign() != exact.sign() {
        return None;
    }
    let unit = RealCyclotomic::from(printed.unit().recip());
    let scaled = (exact * &unit).abs();
    let cut = (digits >= DIGITS_FOR_CUT).then(|| scaled.floor());
    [Some(scaled.step(Rational::round_half_even)), cut]
        .iter()
        .flatten()
        .find_map(|correct| digit_slip(&printed.mantissa().abs(), correct))
}

/// One digit changed, or two neighbours exchanged, between two integers of the
/// same length. A last digit that differs is no slip: inexact computing gives it too.
fn digit_slip(printed: &Integer, correct: &Integer) -> Option<Slip> {
    let printed: Vec<char> = printed.to_string().chars().collect();
    let correct: Vec<char> = correct.to_string().chars().collect();
    if printed.len() != correct.len() {
        return None;
    }
    let differing: Vec<usize> = (0..printed.len()).filter(|&i| printed[i] != correct[i]).collect();
    match differing[..] {
        [i] if i + 1 < printed.len() => {
            Some(Slip::Digit { position: i + 1, printed: printed[i], correct: correct[i] })
        }
        [i, j] if j == i + 1 && printed[i] == correct[j] && printed[j] == correct[i] => {
            Some(Slip::Swap(i + 1))
        }
        _ => None,
    }
}
