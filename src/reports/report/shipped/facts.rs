//! What follows from the numbers of a table, in sentences.

use super::words::{after_at, at, error, type_name};
use crate::exact::{Rational, RealExpression, format::short};
use crate::shipped::{BrokenSums, DECIDING_BITS, ShippedFinding, SplitEquals};

/// The digits of a sum.
const SUM_DIGITS: u32 = 12;

/// The greatest error, with its place.
pub(super) fn greatest_error(finding: &ShippedFinding<'_>) -> Option<String> {
    let place = finding.farthest?;
    let cell = &finding.cells[place];
    let (size, exact) = (cell.error.as_ref()?, cell.exact.as_ref().ok()?);
    let relative = relative(size, exact);
    let relative = relative.map(|relative| format!(", {relative} of the value"));
    Some(format!(
        "{}{}{}",
        error(size),
        relative.unwrap_or_default(),
        after_at(finding.claim, place)
    ))
}

/// The error as a part of the value, where this is not 0 and not decided to be less than the error.
fn relative(size: &Rational, exact: &RealExpression) -> Option<String> {
    exact.sign_within(DECIDING_BITS).filter(|sign| *sign != 0)?;
    let part = |x: &Rational| (*size < x.abs()).then(|| error(&(size / &x.abs())));
    (0..8).map(|level| exact.near(level)).filter(|near| near.sign().is_some()).find_map(|near| {
        let [lower, upper] = [near.lower(), near.upper()].map(part);
        (lower == upper).then_some(lower)
    })?
}

/// What the project accepts, against the greatest error.
pub(super) fn tolerance(finding: &ShippedFinding<'_>) -> Option<String> {
    let (text, tolerance) = finding.claim.tolerance.as_ref()?;
    let all = 0..finding.cells.len();
    let within: Vec<bool> = all.filter_map(|place| finding.is_within(place, tolerance)).collect();
    let greater = within.iter().filter(|within| !**within).count();
    match (greater, within.len(), finding.cells.len()) {
        (0, known, all) if known < all => None,
        (0, ..) => Some(format!(
            "The project accepts errors of {text}, and none is greater: a note, not a bug."
        )),
        (_, _, of) => {
            Some(format!("The project accepts errors of {text}; {greater} of {of} are greater."))
        }
    }
}

/// Sums that are not kept, with control data that show it.
pub(super) fn sums(finding: &ShippedFinding<'_>) -> Option<String> {
    let BrokenSums { exact, first, held, nearest, lines } = finding.sums.as_ref()?;
    let claim = finding.claim;
    let index = claim.indices.last()?;
    let mut outer = claim.at(*first);
    outer.pop();
    let place: Vec<String> =
        outer.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let place = if place.is_empty() { String::new() } else { format!(" at {}", place.join(", ")) };
    let all = claim.numbers.len() / claim.line();
    let lost = error(&(held - exact).abs());
    let sum = short(exact, SUM_DIGITS);
    let which = if all == 1 {
        format!("The exact values have the sum {sum}; the shipped ones miss it by {lost}")
    } else {
        let which =
            if *lines == 1 { "1 line misses".to_owned() } else { format!("{lines} lines miss") };
        format!(
            "Over {}, the exact values of each line have the sum {sum}; as shipped, {which} it, by \
             up to {lost}{place}",
            index.name
        )
    };
    let held = short(held, SUM_DIGITS);
    let witness = if exact.is_zero() {
        format!("data that are 1 everywhere give {held} there, and not 0")
    } else {
        format!("data that are 1 everywhere become {held} there, and not {sum}")
    };
    let nearest = if nearest.is_zero() { "0".to_owned() } else { error(nearest) };
    let kind = type_name(claim.kind);
    Some(format!("{which}: {witness}. The nearest numbers ({kind}) miss it by {nearest} at most."))
}

/// Equal values that are shipped differently, with a pair of them.
pub(super) fn equals(finding: &ShippedFinding<'_>) -> Option<String> {
    let SplitEquals { values, pair: [one, other] } = finding.equals.as_ref()?;
    let claim = finding.claim;
    let shipped = |place: usize| format!("{} at {}", claim.numbers[place].text, at(claim, place));
    let pair = format!("{} and {}", shipped(*one), shipped(*other));
    Some(match values {
        1 => format!("One exact value is shipped in two ways, up to its sign: {pair}."),
        _ => format!(
            "{values} exact values are shipped in different ways, up to their signs, such as {pair}."
        ),
    })
}
