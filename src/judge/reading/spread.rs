//! Solving for the spread of the data in tables of depths.
//!
//! A depth is a logarithm of x to the base r, rounded; x is inversely proportional to
//! the spread. Each printed depth k bounds the spread between two numbers.

use crate::bound::{Rounded, log_level_algebraic};
use crate::evaluation::trace::LevelCall;
use crate::exact::{Enclosed, Integer, Rational, RealCyclotomic};
use crate::finding::{Explanation, Solved};
use crate::judge::reading::consistent::DecimalRounding;
use crate::judge::reading::scale::{is_simple, simplest_between};
use crate::judge::reading::space::Space;
use crate::judge::reading::tried::Evaluated;

/// The greatest depth from which a bound is derived.
const MAX_DEPTH: i64 = 5_000;

/// The binary digits of squares of scales.
const DIGITS: u32 = 256;

/// The unstated parameter that every x of the levels is inversely proportional to.
pub(crate) fn unknown<'s>(space: &'s Space<'_>) -> Option<&'s str> {
    if !space.is_depth() {
        return None;
    }
    let names = space.assume.iter().filter(|name| space.judge.assumed[*name].sign() > 0);
    names.map(String::as_str).find(|name| is_spread(space, name))
}

/// Whether the printed definition takes x to x/2 and x/3, and the ratio to itself, when
/// the parameter becomes two and three times as much, and its form shows it for all others.
fn is_spread(space: &Space<'_>, name: &str) -> bool {
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
    space: &Space<'_>,
    name: &str,
    readings: &[&Evaluated],
    least: usize,
) -> Vec<Explanation> {
    readings.iter().filter_map(|one| solved(space, name, one, least)).collect()
}

/// How many tables the spreads give that differ in their printed form, where one cell
/// is as printed, at most: while the level of this one stays, each other's changes at
/// most as often as powers of the greatest ratio are needed for the least.
pub(crate) fn candidates(space: &Space<'_>) -> Integer {
    let settings = space.settings(&[]);
    let (mut ratios, mut cells) = (Vec::new(), 0);
    for (row, line) in space.printed.iter().enumerate() {
        for column in (0..line.len()).filter(|&column| line[column].is_some()) {
            let call = space.judge.level_call(space.at(row, column, &settings));
            ratios.extend(call.map(|call| call.ratio));
            cells += 1;
        }
    }
    let one = RealCyclotomic::from(1);
    let inside = |ratio: &&RealCyclotomic| ratio.sign() > 0 && **ratio < one;
    let (least, greatest) =
        (ratios.iter().filter(inside).min(), ratios.iter().filter(inside).max());
    let (Some(least), Some(greatest)) = (least, greatest) else { return Integer::from(cells) };
    let changes = log_level_algebraic(greatest, least, Rounded::Up).unwrap_or(u32::MAX);
    Integer::from(cells) * (Integer::one() + Integer::from(cells) * Integer::from(changes))
}

fn solved(space: &Space<'_>, name: &str, one: &Evaluated, least: usize) -> Option<Explanation> {
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
    // The greatest number of intervals meets right of the lower end of one of them.
    let covering = |place: &Integer| {
        intervals.iter().filter(|(low, high)| low <= place && place < high).count()
    };
    let (count, place) = intervals.iter().map(|(low, _)| (covering(low), low)).max()?;
    if count < least {
        return None;
    }
    let meeting = intervals.iter().filter(|(low, high)| low <= place && place < high);
    let high = meeting.map(|(_, high)| high).min()?;
    let base = &space.judge.assumed[name];
    let between = (root(place) * base, root(high) * base);
    // The assumed value, where it does as well.
    let simplest = if between.0 <= *base && *base < between.1 {
        base.clone()
    } else {
        Some(simplest_between(&between.0, &between.1)).filter(is_simple)?
    };
    let settings = space.settings(reading).with_parameter(name, &simplest);
    let values = space.values(&settings);
    let explained = space.explained(&values, DecimalRounding::Nearest);
    let differences = reading.iter().map(|change| space.difference(change)).collect();
    let solved = vec![Solved { name: name.to_owned(), between, simplest }];
    Some(Explanation { differences, solved, values, explained })
}

/// The squares of the s, as multiples of 2^−256, for which x/s has the printed level;
/// up to a multiple.
fn squares(call: &LevelCall, printed: &Rational) -> Option<(Integer, Integer)> {
    let level = printed.numerator().to_i64().filter(|_| printed.is_integer())?;
    if !(0..=MAX_DEPTH).contains(&level) || call.ratio.sign() <= 0 || call.x.sign() <= 0 {
        return None;
    }
    // ratio^a ≥ x/s ≥ ratio^b up to which ends belong to it; level 0 is also less.
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

/// The root of a multiple of 2^−256, cut to 2^−128.
fn root(square: &Integer) -> Rational {
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
