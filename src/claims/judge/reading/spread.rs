//! Solving for the spread of the data in tables of depths.
//!
//! A depth is the logarithm of x to the base r, rounded, where x is inversely proportional to the
//! spread. Hence each printed depth encloses the spread in an interval.

use crate::bound::Rounded;
use crate::evaluation::trace::LevelCall;
use crate::exact::{Enclosed, Integer, Rational, RealCyclotomic};
use crate::finding::{Explanation, Solved};
use crate::judge::reading::consistent::DecimalRounding;
use crate::judge::reading::plain::{height, plainest_between};
use crate::judge::reading::space::ReadingSpace;
use crate::judge::reading::tried::Evaluated;

/// The greatest depth from which a bound is derived.
const MAX_DEPTH: i64 = 5_000;

/// The binary digits behind the point of squares of scales.
const DIGITS: u32 = 256;

/// The unknown parameter, where every x of the levels is inversely proportional to it.
pub(crate) fn unknown<'s>(space: &ReadingSpace<'s>) -> Option<&'s str> {
    let name = space.unknown.filter(|_| space.is_depth())?;
    is_spread(space, name).then_some(name)
}

/// Whether every printed depth has, if the parameter becomes two and three times as large, an x
/// that is half and a third, and the same ratio; and whether the form of the value shows this for
/// all other factors.
fn is_spread(space: &ReadingSpace<'_>, name: &str) -> bool {
    if !space.is_inverse(name) {
        return false;
    }
    let settings = space.settings(&[]);
    let base = &space.judge.assumed[name];
    let mut seen = false;
    for times in [2, 3].map(Rational::from) {
        let (other, times) =
            (settings.with_parameter(name, &(base * &times)), RealCyclotomic::from(times));
        for (row, line) in space.printed.iter().enumerate() {
            for column in (0..line.len()).filter(|&column| line[column].is_some()) {
                let call = |settings| space.judge.level_call(space.at(row, column, settings));
                match (call(&settings), call(&other)) {
                    (Some(once), Some(more)) => {
                        if once.ratio != more.ratio || once.x != &more.x * &times {
                            return false;
                        }
                        seen = true;
                    }
                    (None, None) => {}
                    _ => return false,
                }
            }
        }
    }
    seen
}

/// The readings with the spread solved for, where that explains at least `least` cells.
pub(crate) fn search(
    space: &ReadingSpace<'_>,
    name: &str,
    readings: &[&Evaluated],
    least: usize,
) -> Vec<Explanation> {
    readings.iter().filter_map(|one| solved(space, name, one, least)).collect()
}

fn solved(
    space: &ReadingSpace<'_>,
    name: &str,
    one: &Evaluated,
    least: usize,
) -> Option<Explanation> {
    let Evaluated { reading, levels, .. } = one;
    let mut intervals = Vec::new();
    for (printed, call) in space.printed.iter().flatten().zip(levels.iter().flatten()) {
        if let (Some(printed), Some(call)) = (printed, call) {
            intervals.extend(squares(call, &printed.decimal.value()));
        }
    }
    if intervals.len() < least {
        return None;
    }
    // Where most intervals meet, they meet right of the lower end of one of them.
    let meeting = |place: &Integer| -> Vec<&Integer> {
        let holding = intervals.iter().filter(|(low, high)| low <= place && place < high);
        holding.map(|(_, high)| high).collect()
    };
    let most = intervals.iter().map(|(low, _)| meeting(low).len()).max()?;
    if most < least {
        return None;
    }
    let base = &space.judge.assumed[name];
    let value = |(place, _): &(Integer, Integer)| {
        let holding = meeting(place);
        if holding.len() < most {
            return None;
        }
        let between = (root(place) * base, root(holding.iter().min()?) * base);
        // The lower end belongs to the intersection, but a spread is not 0.
        let inside = plainest_between(&between.0, &between.1);
        let ends = [between.0.clone(), inside].into_iter().filter(|value| !value.is_zero());
        Some((ends.min_by_key(height)?, between))
    };
    let values = intervals.iter().filter_map(value);
    let (simplest, between) = values.min_by_key(|(simplest, _)| height(simplest))?;
    let settings = space.settings(reading).with_parameter(name, &simplest);
    let values = space.values(&settings);
    let explained = space.explained(&values, DecimalRounding::Nearest);
    let differences = reading.iter().map(|change| space.difference(change)).collect();
    let solved = vec![Solved { name: name.to_owned(), between, simplest }];
    Some(Explanation { differences, solved, values, explained })
}

/// The interval of s² for which x/s has the printed level, in units of 2^−256; its ends are rounded
/// down to whole units.
fn squares(call: &LevelCall, printed: &Rational) -> Option<(Integer, Integer)> {
    let level = printed.numerator().to_i64().filter(|_| printed.is_integer())?;
    if !(0..=MAX_DEPTH).contains(&level) || call.ratio.sign() <= 0 || call.x.sign() <= 0 {
        return None;
    }
    // ratio^a ≥ (x/s)² ≥ ratio^b, up to which ends belong to it; at level 0, x/s has no upper
    // bound.
    let (a, b) = match call.rounded {
        Rounded::Up => (2 * level - 2, 2 * level),
        Rounded::Nearest => (2 * level - 1, 2 * level + 1),
        Rounded::Down => (2 * level, 2 * level + 2),
    };
    let (ratio, x) = (call.ratio.enclosure(2), call.x.enclosure(2));
    if ratio.lower().sign() <= 0 || x.lower().sign() <= 0 {
        return None;
    }
    let low = if level == 0 { Integer::zero() } else { square(x.lower(), ratio.upper(), a) };
    Some((low, square(x.upper(), ratio.lower(), b)))
}

/// ⌊2^256·x²/ratio^exponent⌋.
fn square(x: &Rational, ratio: &Rational, exponent: i64) -> Integer {
    let power = u32::try_from(exponent).expect("not negative, and capped");
    let top = x.numerator().pow(2) * ratio.denominator().pow(power);
    let bottom = x.denominator().pow(2) * ratio.numerator().pow(power);
    top.shifted_left(DIGITS).div_floor(&bottom)
}

/// The square root of a multiple of 2^−256, cut to a multiple of 2^−128.
fn root(square: &Integer) -> Rational {
    if square.is_zero() {
        return Rational::zero();
    }
    let half = u32::try_from(square.bits() / 2 + 1).expect("a number that fits in memory");
    // Newton's iteration falls from any number above the root, and ends at its floor.
    let (mut root, mut next) =
        (Integer::one().shifted_left(half + 1), Integer::one().shifted_left(half));
    while next < root {
        root = next;
        next = (&root + square.div_floor(&root)).shifted_right(1);
    }
    Rational::new(root, Integer::one().shifted_left(DIGITS / 2))
}
