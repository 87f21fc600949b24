//! Sets of values of a parameter, in words.

use super::radical::radical;
use crate::exact::{
    Enclosed as _, Integer, Interval, IntervalSet, Rational, RationalPolynomial, RealAlgebraic,
    format::fixed, format::short,
};
use std::ops::Bound;

/// The places of a decimal that is cut.
const PLACES: u32 = 12;

/// The longest exact fraction that stands in place of its decimal.
const LONGEST: usize = 16;

/// The significant digits of an end that a search has left.
const DIGITS: i32 = 6;

/// A search halves intervals. Its ends have powers of two as denominators, and this one at least.
const HALVED: i64 = 64;

/// A gap beside an interval is narrow up to this part of its length.
const NARROW: i64 = 64;

/// The values of a parameter for which something is proved. A search that proves it for no value has found none, which is
/// not to say that there are none.
pub(crate) fn set_text(set: &IntervalSet, variable: &str) -> String {
    joined(&found_texts(set, variable), variable)
}

/// The same of values up to whose ends it is proved, beside those for which the opposite is.
pub(crate) fn proved_text(set: &IntervalSet, opposite: &IntervalSet, variable: &str) -> String {
    joined(&proved_texts(set, opposite, variable), variable)
}

fn joined(texts: &[String], variable: &str) -> String {
    let between = if texts.iter().any(|text| text.contains(',')) { "; or " } else { " or " };
    if texts.is_empty() { format!("no {variable} that is found") } else { texts.join(between) }
}

/// Each interval of a set that is known exactly as a condition on a variable, such as `1/4 < w <= 1/2`.
///
/// ```
/// use subcert::exact::PiecewisePolynomial;
/// use subcert::report::interval_texts;
///
/// let x = PiecewisePolynomial::variable();
/// let set = x.times(&x).minus(&x).below(&18.into());
/// assert_eq!(interval_texts(&set, "w"), ["(1 - √73)/2 < w < (1 + √73)/2"]);
/// ```
#[must_use]
pub fn interval_texts(set: &IntervalSet, variable: &str) -> Vec<String> {
    let place = |end: &Bound<RealAlgebraic>, _: bool| End::of(end, number);
    let ends = |one: &Interval| [place(&one.low, false), place(&one.high, true)];
    set.intervals().iter().map(|one| condition(one, &ends(one), variable)).collect()
}

/// Each interval of a set for which something is proved: ends that a search has left are decimals, rounded towards the
/// interval.
#[must_use]
pub fn found_texts(set: &IntervalSet, variable: &str) -> Vec<String> {
    proved_texts(set, &IntervalSet::default(), variable)
}

/// The same, beside the set for which the opposite is proved. Where a narrow gap is between the two, the end is that of
/// the opposite, and it is said how near to it the proof comes: `|w| < 1/2, proved up to 3.1·10^-5 of the ends`.
#[must_use]
pub fn proved_texts(set: &IntervalSet, opposite: &IntervalSet, variable: &str) -> Vec<String> {
    let all = set.intervals();
    let text = |(i, one): (usize, &Interval)| {
        let before = i.checked_sub(1).and_then(|i| place_of(&all[i].high));
        let after = all.get(i + 1).and_then(|next| place_of(&next.low));
        let places = opposite.intervals();
        let below = places.iter().filter_map(|other| place_of(&other.high)).filter(|place| {
            place_of(&one.low).is_some_and(|low| *place <= low)
                && before.is_none_or(|before| before <= *place)
        });
        let above = places.iter().filter_map(|other| place_of(&other.low)).filter(|place| {
            place_of(&one.high).is_some_and(|high| *place >= high)
                && after.is_none_or(|after| *place <= after)
        });
        let ends = [
            found_end(one, &one.low, below.max(), false),
            found_end(one, &one.high, above.min(), true),
        ];
        let gaps: Vec<&Rational> = ends.iter().filter_map(|end| end.gap.as_ref()).collect();
        let said = condition(one, &ends, variable);
        let Some(gap) = gaps.iter().max() else { return said };
        let which = match (&ends[0].gap, &ends[1].gap) {
            (Some(_), Some(_)) => "ends",
            (Some(_), None) if ends[1].text.is_some() => "lower end",
            (None, Some(_)) if ends[0].text.is_some() => "upper end",
            _ => "end",
        };
        format!("{said}, proved up to {} of the {which}", distance(gap))
    };
    all.iter().enumerate().map(text).collect()
}

/// An end of an interval in words.
struct End {
    /// The number; none where there is no end.
    text: Option<String>,
    closed: bool,
    /// What is open beside it, where it is the end of the opposite.
    gap: Option<Rational>,
}

impl End {
    fn of(end: &Bound<RealAlgebraic>, text: impl Fn(&RealAlgebraic) -> String) -> End {
        let closed = matches!(end, Bound::Included(_));
        End { text: place_of(end).map(text), closed, gap: None }
    }
}

fn place_of(end: &Bound<RealAlgebraic>) -> Option<&RealAlgebraic> {
    match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place),
    }
}

/// An end of an interval for which something is proved; `facing` is where the opposite begins.
fn found_end(
    interval: &Interval,
    end: &Bound<RealAlgebraic>,
    facing: Option<&RealAlgebraic>,
    upper: bool,
) -> End {
    let exact = || End::of(end, number);
    let Some(place) = place_of(end) else { return exact() };
    if facing == Some(place) {
        return exact();
    }
    let length = match (place_of(&interval.low), place_of(&interval.high)) {
        (Some(low), Some(high)) => apart(low, high),
        _ => Rational::one(),
    };
    if let Some(facing) = facing.filter(|facing| !is_left_over(facing)) {
        let gap = apart(place.min(facing), place.max(facing));
        if &gap * Rational::from(NARROW) <= length {
            return End { text: Some(number(facing)), closed: false, gap: Some(gap) };
        }
    }
    let rational = place.as_rational().filter(|_| is_left_over(place));
    let Some(rounded) = rational.map(|value| rounded(value, !upper)) else { return exact() };
    // In an interval that is shorter than the last digit no decimal is left.
    if interval.contains(&rounded) {
        return End::of(end, |_| short(&rounded, DIGITS.unsigned_abs() + 1));
    }
    exact()
}

/// How far two numbers are apart, rounded upwards.
fn apart(low: &RealAlgebraic, high: &RealAlgebraic) -> Rational {
    high.enclosure(0).upper() - low.enclosure(0).lower()
}

/// Whether this is an end of a search, and not of a set.
fn is_left_over(place: &RealAlgebraic) -> bool {
    let Some(value) = place.as_rational() else { return false };
    let denominator = value.denominator();
    let power_of_two =
        Integer::one().shifted_left(u32::try_from(denominator.bits()).unwrap_or(1) - 1);
    denominator > Integer::from(HALVED) && denominator == power_of_two
}

/// A decimal of [`DIGITS`] significant digits beside a number that is not 0.
fn rounded(value: &Rational, upwards: bool) -> Rational {
    let mut power = 0;
    while value.abs() < Rational::power_of_ten(power) {
        power -= 1;
    }
    while value.abs() >= Rational::power_of_ten(power + 1) {
        power += 1;
    }
    let unit = Rational::power_of_ten(power + 1 - DIGITS);
    let count = value / &unit;
    Rational::from(if upwards { count.ceil() } else { count.floor() }) * unit
}

/// A positive distance in two digits, rounded upwards: `3.1·10^-5`.
fn distance(gap: &Rational) -> String {
    let mut power = 0;
    while *gap < Rational::power_of_ten(power) {
        power -= 1;
    }
    let tenths = Rational::from((gap * Rational::power_of_ten(1 - power)).ceil());
    let size = short(&(&tenths / Rational::from(10)), 3);
    if power < -3 {
        return format!("{size}·10^{power}");
    }
    short(&(tenths * Rational::power_of_ten(power - 1)), 3)
}

fn condition(interval: &Interval, [low, high]: &[End; 2], variable: &str) -> String {
    let sign = |end: &End| if end.closed { "<=" } else { "<" };
    let symmetric = low.gap.is_some()
        && high.gap.is_some()
        && low.text.as_ref().and_then(|text| text.strip_prefix('-')) == high.text.as_deref();
    match (&low.text, &high.text) {
        (None, None) => format!("every {variable}"),
        (Some(only), Some(_)) if interval.low == interval.high => format!("{variable} = {only}"),
        (Some(from), None) => format!("{variable} {} {from}", sign(low).replace('<', ">")),
        (_, Some(end)) if symmetric => format!("|{variable}| < {end}"),
        (from, to) => {
            let to = to.as_ref().map(|to| format!(" {} {to}", sign(high))).unwrap_or_default();
            let from = from.as_ref().map(|from| format!("{from} {} ", sign(low)));
            format!("{}{variable}{to}", from.unwrap_or_default())
        }
    }
}

/// A number: exactly, where that is short, by square roots too; otherwise a decimal that is cut.
#[must_use]
pub fn number(place: &RealAlgebraic) -> String {
    let exact = place.as_rational().map_or_else(|| radical(place), |value| Some(value.to_string()));
    exact.filter(|text| text.chars().count() <= LONGEST).unwrap_or_else(|| {
        let unit = Rational::from(Integer::power_of_ten(PLACES));
        let cut = place.step(|value| (value * &unit).trunc());
        format!("{}…", fixed(&(Rational::from(cut) / unit), PLACES))
    })
}

/// The minimal polynomial of a number, or one that may have factors, which the text says.
#[must_use]
pub fn polynomial(number: &RealAlgebraic, parameter: &str) -> String {
    let (polynomial, note) = match number.minimal_polynomial() {
        Some(minimal) => (minimal, ""),
        None => (number.polynomial(), ", which may have factors"),
    };
    let polynomial = RationalPolynomial::over(&polynomial, &Integer::one());
    format!("{}{note}", polynomial.describe(parameter))
}

/// Of which polynomials the ends of these sets are roots, of which these texts have decimals that are cut.
pub(crate) fn roots(sets: &[&IntervalSet], variable: &str, texts: &[String]) -> Vec<String> {
    let mut ends: Vec<&RealAlgebraic> =
        sets.iter().flat_map(|set| set.ends()).map(|(end, _)| end).collect();
    ends.sort();
    ends.dedup();
    let root = |end: &RealAlgebraic| {
        let name = number(end);
        let is_said = name.ends_with('…') && texts.iter().any(|text| text.contains(&name));
        let polynomial = polynomial(end, variable);
        // Letters stand beside their coefficients.
        let letter = variable.chars().count() == 1;
        let polynomial = if letter { polynomial.replace('*', "") } else { polynomial };
        is_said.then(|| format!("{name} is a root of {polynomial}."))
    };
    ends.into_iter().filter(|end| end.as_rational().is_none()).filter_map(root).collect()
}
