//! A printed decimal against an exact value.

use super::finding::{Direction, Slip, Verdict};
use crate::exact::{Decimal, Enclosed, Integer, Rational, RealCyclotomic, Rounding};

/// The digits that a slip needs before it is more than luck: with fewer, a number
/// of random digits would be one slip away from the exact value more than once in
/// a thousand times. A digit can change in 9d ways, towards the value rounded or
/// cut; a pair can be exchanged in d−1; the point can be off by 3 places at most
/// either way; a sign has one other; there are four neighbours. Zeros at the end
/// do not count: 0.1600 for 0.1400 says no more than 0.16 for 0.14.
const DIGITS_FOR_DIGIT: usize = 5;
const DIGITS_FOR_SWAP: usize = 5;
const DIGITS_FOR_EXPONENT: usize = 4;
const DIGITS_FOR_SIGN: usize = 4;
const DIGITS_FOR_NEIGHBOUR: usize = 4;

/// How far the decimal point may be off.
const MAX_EXPONENT_SLIP: i32 = 3;

/// The verdict on `printed` for the value `exact`; `neighbours` are the exact
/// values of the cells around it with their direction.
pub(super) fn judge(
    printed: &Decimal,
    exact: &RealCyclotomic,
    neighbours: &[((i32, i32), &RealCyclotomic)],
) -> Verdict {
    match printed.rounding_of(exact) {
        Rounding::Exact | Rounding::Nearest => Verdict::Confirmed,
        Rounding::Truncated => Verdict::Rounding(Direction::Cut),
        Rounding::Up => Verdict::Rounding(Direction::Away),
        Rounding::Neither => {
            find_slip(printed, exact, neighbours).map_or(Verdict::Refuted, Verdict::Misprint)
        }
    }
}

/// Whether `exact` becomes `printed` by some rounding.
pub(super) fn matches(printed: &Decimal, exact: &RealCyclotomic) -> bool {
    printed.rounding_of(exact) != Rounding::Neither
}

/// The significant digits without the zeros at the end.
fn telling_digits(printed: &Decimal) -> usize {
    printed.mantissa().abs().to_string().trim_matches('0').len()
}

fn find_slip(
    printed: &Decimal,
    exact: &RealCyclotomic,
    neighbours: &[((i32, i32), &RealCyclotomic)],
) -> Option<Slip> {
    let digits = telling_digits(printed);
    if digits >= DIGITS_FOR_SIGN && matches(printed, &-exact) {
        return Some(Slip::Sign);
    }
    if digits >= DIGITS_FOR_EXPONENT {
        let places = (1..=MAX_EXPONENT_SLIP).flat_map(|places| [places, -places]);
        let moved = |places: i32| exact * &RealCyclotomic::from(Rational::power_of_ten(places));
        if let Some(places) = places.into_iter().find(|&places| {
            matches!(printed.rounding_of(&moved(places)), Rounding::Exact | Rounding::Nearest)
        }) {
            return Some(Slip::Exponent(places));
        }
    }
    if digits >= DIGITS_FOR_NEIGHBOUR {
        let same = neighbours.iter().find(|(_, value)| *value != exact && matches(printed, value));
        if let Some(((rows, columns), _)) = same {
            return Some(Slip::Neighbour(*rows, *columns));
        }
    }
    if digits < DIGITS_FOR_DIGIT.min(DIGITS_FOR_SWAP) || printed.value().sign() != exact.sign() {
        return None;
    }
    let unit = RealCyclotomic::from(printed.unit().recip());
    let scaled = (exact * &unit).abs();
    [scaled.step(Rational::round_half_even), scaled.floor()]
        .iter()
        .find_map(|correct| digit_slip(&printed.mantissa().abs(), correct, digits))
}

/// One digit changed, or two neighbours exchanged, between two integers of the
/// same length. A last digit that differs is no slip: inexact computing gives it too.
fn digit_slip(printed: &Integer, correct: &Integer, digits: usize) -> Option<Slip> {
    let printed: Vec<char> = printed.to_string().chars().collect();
    let correct: Vec<char> = correct.to_string().chars().collect();
    if printed.len() != correct.len() {
        return None;
    }
    let differing: Vec<usize> = (0..printed.len()).filter(|&i| printed[i] != correct[i]).collect();
    match differing[..] {
        [i] if digits >= DIGITS_FOR_DIGIT && i + 1 < printed.len() => {
            Some(Slip::Digit { position: i + 1, printed: printed[i], correct: correct[i] })
        }
        [i, j]
            if digits >= DIGITS_FOR_SWAP
                && j == i + 1
                && printed[i] == correct[j]
                && printed[j] == correct[i] =>
        {
            Some(Slip::Swap(i + 1))
        }
        _ => None,
    }
}
