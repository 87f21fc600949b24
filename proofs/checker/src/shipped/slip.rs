//! Slips by which the digits of a number may have come from those of the exact value.

use super::decided::{Ends, decided, is_rounded, within};
use super::number::Written;
use super::rounding::{Type, half_even, ten};
use crate::numbers::{Q, differing, is_exchanged};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// The fewest digits of a number with another sign, with the point elsewhere, and with other digits.
const SIGN: usize = 3;
const POINT: usize = 4;
const DIGITS: usize = 5;

/// How many of the last digits are not changed by a slip in one digit, and not left out.
const LAST: usize = 2;

/// The name of a slip in digits, the digits after the point that are needed beyond those written, and
/// whether the slip leads from the right digits to the typed ones, which come first.
type Kind = (&'static str, i64, fn(&str, &str) -> bool);

/// The first slip that leads from x to what is written. `turned` is the number of the type nearest to −w.
pub fn slip(
    x: &Ends,
    written: &Written,
    turned: Option<Q>,
    of: Type,
) -> Result<Option<&'static str>, Stop> {
    if written.digits >= SIGN {
        if let Some(turned) = turned {
            let (low, high) = of.cell(&turned);
            if within(x, &low, &high, "whether the sign is wrong")? {
                return Ok(Some("sign"));
            }
        }
        if is_rounded(&(-&x.1, -&x.0), written)? {
            return Ok(Some("sign"));
        }
    }
    if written.digits >= POINT {
        for shift in [-3, -2, -1, 1, 2, 3] {
            let moved = (&x.0 * ten(shift), &x.1 * ten(shift));
            if is_rounded(&moved, written)? {
                return Ok(Some("point"));
            }
        }
    }
    if written.digits < DIGITS {
        return Ok(None);
    }
    let zero = Q::zero();
    let negative = decided(x.1 < zero, x.0 >= zero, "a sign")?;
    if negative != written.value.is_negative() {
        return Ok(None);
    }
    let typed = digits_of(&(&written.value * ten(written.places)).to_integer());
    let kinds: [Kind; 3] =
        [("digit", 0, is_digit), ("exchanged", 0, is_exchanged), ("dropped", 1, is_dropped)];
    for (kind, more, test) in kinds {
        let found = candidates(x, written.places + more)?.map(|right| test(&typed, &right));
        if decided(found[0] && found[1], !found[0] && !found[1], "which digits are right")? {
            return Ok(Some(kind));
        }
    }
    Ok(None)
}

/// The digits of x rounded to so many places after the point, for both ends. Between the ends there are
/// no other integers than theirs, or the slip is not decided.
fn candidates(x: &Ends, places: i64) -> Result<[String; 2], Stop> {
    let [low, high] = [&x.0, &x.1].map(|end| half_even(&(end * ten(places))));
    if &high - &low > BigInt::from(1) {
        return Err(Stop::Undecided("which digits are right"));
    }
    Ok([digits_of(&low), digits_of(&high)])
}

fn digits_of(n: &BigInt) -> String {
    n.abs().to_string()
}

/// Whether one digit is another one, which is not among the last.
fn is_digit(typed: &str, right: &str) -> bool {
    matches!(differing(typed, right)[..], [at] if at + LAST < typed.len())
}

/// Whether a digit is missing that is not among the last.
fn is_dropped(typed: &str, longer: &str) -> bool {
    let without = |at: usize| {
        let kept = longer.bytes().enumerate().filter(move |(place, _)| *place != at);
        kept.map(|(_, digit)| digit)
    };
    let places = 0..longer.len().saturating_sub(LAST);
    typed.len() + 1 == longer.len() && places.into_iter().any(|at| without(at).eq(typed.bytes()))
}
