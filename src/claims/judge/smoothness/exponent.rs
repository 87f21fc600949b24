//! Judging printed Hölder exponents.

use crate::claim::{ExponentStatement, PrintedExponent};
use crate::exact::{Decimal, Enclosed as _, Enclosure, LogSum, Rounding};
use crate::finding::{Direction, Proven, SmoothnessVerdict};
use crate::smoothness::Hoelder;
use std::cmp::Ordering;

/// The level of the finest enclosures that are compared: 64·2^3 binary digits.
const MAX_LEVEL: u32 = 3;

/// Judges what a paper says of the exponent.
pub(super) fn judge(
    proven: &Proven<'_>,
    exponent: &ExponentStatement,
    attained: Option<bool>,
) -> SmoothnessVerdict {
    let Some(hoelder) = proven.hoelder else {
        // Without limits there is no exponent.
        let diverges = proven.continuity_fails == Some(0);
        return if diverges { SmoothnessVerdict::Refuted } else { SmoothnessVerdict::Open };
    };
    let as_said = attained.map_or(Some(true), |said| Some(hoelder.attained? == said));
    let bound = |printed: &Option<PrintedExponent>, which: usize| {
        printed.as_ref().map_or(Some(true), |printed| bounds(hoelder, &printed.value)[which])
    };
    match exponent {
        ExponentStatement::Value(printed) => {
            SmoothnessVerdict::of_all(&[equals(hoelder, &printed.value), as_said])
        }
        ExponentStatement::Bounds { at_least, at_most } => {
            SmoothnessVerdict::of_all(&[bound(at_least, 0), bound(at_most, 1), as_said])
        }
        ExponentStatement::Decimal { decimal, .. } => match (rounding(hoelder, decimal), as_said) {
            (Some(Rounding::Neither), _) | (_, Some(false)) => SmoothnessVerdict::Refuted,
            (Some(Rounding::Cut), _) if decimal.significant_digits() == 0 => {
                SmoothnessVerdict::Refuted
            }
            (None, _) | (_, None) => SmoothnessVerdict::Open,
            (Some(Rounding::Exact | Rounding::Nearest), _) => SmoothnessVerdict::Confirmed,
            (Some(Rounding::Cut), _) => SmoothnessVerdict::Rounding(Direction::Cut),
            (Some(Rounding::Up), _) => SmoothnessVerdict::Rounding(Direction::Away),
        },
    }
}

/// Enclosures of the exponent: finer and finer ones where it is known exactly, otherwise that of its bounds.
fn enclosures(hoelder: &Hoelder) -> Vec<Enclosure> {
    match &hoelder.formula {
        Some(formula) => (0..=MAX_LEVEL).map(|level| formula.enclosure(level)).collect(),
        None => vec![Enclosure::new(hoelder.lower.clone(), hoelder.upper.clone())],
    }
}

/// Whether the exponent is this number.
fn equals(hoelder: &Hoelder, value: &LogSum) -> Option<bool> {
    let exact = is_equal(hoelder, value);
    exact.or_else(|| bounds(hoelder, value).contains(&Some(false)).then_some(false))
}

/// The same by exact arithmetic, where the exponent is known exactly and that decides.
fn is_equal(hoelder: &Hoelder, value: &LogSum) -> Option<bool> {
    let formula = hoelder.formula.as_ref()?;
    formula.equals(value).or_else(|| {
        let rational = LogSum::from(formula.as_rational()?.clone());
        rational.compare(value).map(Ordering::is_eq)
    })
}

/// Whether the exponent is at least this number, and whether it is at most this number.
fn bounds(hoelder: &Hoelder, value: &LogSum) -> [Option<bool>; 2] {
    if is_equal(hoelder, value) == Some(true) {
        return [Some(true); 2];
    }
    for (exponent, level) in enclosures(hoelder).iter().zip(0..) {
        // The bounds of an exponent that is not known exactly have one enclosure.
        let level = if hoelder.formula.is_some() { level } else { 1 };
        let value = value.enclosure(level);
        let at_least = decided(exponent.lower() >= value.upper(), exponent.upper() < value.lower());
        let at_most = decided(exponent.upper() <= value.lower(), exponent.lower() > value.upper());
        if at_least.is_some() || at_most.is_some() {
            return [at_least, at_most];
        }
    }
    [None; 2]
}

fn decided(holds: bool, fails: bool) -> Option<bool> {
    (holds || fails).then_some(holds)
}

/// How the decimal came from the exponent.
fn rounding(hoelder: &Hoelder, decimal: &Decimal) -> Option<Rounding> {
    let shown = decimal.value();
    enclosures(hoelder).iter().find_map(|exponent| {
        let ends = [exponent.lower(), exponent.upper()];
        let [low, high] = ends.map(|end| decimal.rounding_of(end));
        // Neither end may be a rounding, and they be on different sides.
        let apart = *ends[1] < shown || *ends[0] > shown;
        (low == high && (low != Rounding::Neither || apart)).then_some(low)
    })
}
