//! Exact numbers against the numbers of a type.

use super::claim::NumberType;
use crate::exact::{Rational, RealCyclotomic, RealExpression, format};
use crate::float::{exact, nearest, nearest_f32, shortest};
use std::cmp::Ordering;

/// How many binary digits are computed to decide about a number.
pub const DECIDING_BITS: u64 = 10_000;

/// The levels of enclosures of up to that many digits.
pub(super) const LEVELS: std::ops::Range<u32> = 0..8;

/// Questions about an exact number that end within the caps, perhaps without an answer.
pub(super) trait Settled {
    /// The order of this number and another one.
    fn against(&self, other: &Rational) -> Option<Ordering>;
    /// The value of a step function of this number.
    fn settled<T: PartialEq>(&self, step: impl Fn(&Rational) -> T) -> Option<T>;

    /// Whether this lies in a closed interval.
    fn lies_in(&self, lower: &Rational, upper: &Rational) -> Option<bool> {
        Some(self.against(lower)?.is_ge() && self.against(upper)?.is_le())
    }

    /// Whether |self − other| ≤ `distance`.
    fn is_near(&self, other: &Rational, distance: &Rational) -> Option<bool> {
        self.lies_in(&(other - distance), &(other + distance))
    }
}

impl Settled for RealExpression {
    fn against(&self, other: &Rational) -> Option<Ordering> {
        self.compare_within(other, DECIDING_BITS)
    }

    fn settled<T: PartialEq>(&self, step: impl Fn(&Rational) -> T) -> Option<T> {
        if let Some(value) = self.as_number().and_then(RealCyclotomic::as_rational) {
            return Some(step(value));
        }
        LEVELS.map(|level| self.near(level)).find_map(|near| {
            let (lower, upper) = (step(near.lower()), step(near.upper()));
            (lower == upper).then_some(lower)
        })
    }
}

/// 10^−`places`.
pub(super) fn unit(places: i64) -> Rational {
    Rational::power_of_ten(i32::try_from(-places).unwrap_or(0))
}

/// The f32 nearest to a number, if it is finite.
pub(super) fn nearest_single(value: &Rational) -> Option<Rational> {
    exact(f64::from(nearest_f32(value)))
}

impl NumberType {
    /// The number of this type that is nearest to `value`; `None` beyond the greatest one.
    pub(super) fn nearest(self, value: &Rational) -> Option<Rational> {
        match self {
            NumberType::Single => nearest_single(value),
            NumberType::Double => exact(nearest(value)),
            NumberType::Decimal(digits) => {
                let scale = Rational::power_of_ten(i32::try_from(digits).unwrap_or(0));
                Some(Rational::from((value * &scale).round_half_even()) / scale)
            }
        }
    }

    /// The interval of all numbers to which none of this type is nearer than `held`, which is one of this type.
    /// Of decimals, `held` may be any number.
    pub(super) fn cell(self, held: &Rational) -> (Rational, Rational) {
        let half = Rational::new(1, 2);
        if let NumberType::Decimal(digits) = self {
            let unit = Rational::power_of_ten(-i32::try_from(digits).unwrap_or(0));
            return (held - &unit * &half, held + &unit * &half);
        }
        let middle = |other: Option<Rational>, back: Option<Rational>| {
            // Beyond the greatest number, the distance to the next one is that to the last one.
            let other = other.unwrap_or_else(|| {
                let back = back.unwrap_or_else(|| held.clone());
                held + held - back
            });
            (held + other) * &half
        };
        let (below, above) = self.neighbours(held);
        (middle(below.clone(), above.clone()), middle(above, below))
    }

    /// The next numbers of this type below and above one of it.
    fn neighbours(self, held: &Rational) -> (Option<Rational>, Option<Rational>) {
        if self == NumberType::Single {
            let held = nearest_f32(held);
            let of = |value: f32| exact(f64::from(value));
            (of(held.next_down()), of(held.next_up()))
        } else {
            let held = nearest(held);
            (exact(held.next_down()), exact(held.next_up()))
        }
    }

    /// How many steps two numbers of this type are apart.
    pub(super) fn steps(self, one: &Rational, other: &Rational) -> Option<u64> {
        let place = |value: &Rational| -> i128 {
            let (bits, negative) = if self == NumberType::Single {
                let value = nearest_f32(value);
                (u64::from(value.abs().to_bits()), value < 0.0)
            } else {
                let value = nearest(value);
                (value.abs().to_bits(), value < 0.0)
            };
            if negative { -i128::from(bits) } else { i128::from(bits) }
        };
        match self {
            NumberType::Decimal(digits) => {
                let scale = Rational::power_of_ten(i32::try_from(digits).unwrap_or(0));
                let steps = (one - other).abs() * scale;
                let whole = steps.is_integer().then(|| steps.numerator().to_i128())??;
                u64::try_from(whole).ok()
            }
            _ => u64::try_from((place(one) - place(other)).abs()).ok(),
        }
    }
}

/// A number as one would type it, so that a program holds the nearest of the type: the fewest digits that do, or all
/// digits of a decimal. `None` where it is not decided which number is nearest.
///
/// ```
/// use subcert::exact::{Rational, RealExpression};
/// use subcert::shipped::{NumberType, nearest_text};
///
/// let third = RealExpression::from(Rational::new(1, 3));
/// let text = |kind| nearest_text(&third, kind);
/// assert_eq!(text(NumberType::Single).as_deref(), Some("0.33333334"));
/// assert_eq!(text(NumberType::Double).as_deref(), Some("0.3333333333333333"));
/// assert_eq!(text(NumberType::Decimal(4)).as_deref(), Some("0.3333"));
/// ```
#[must_use]
pub fn nearest_text(value: &RealExpression, kind: NumberType) -> Option<String> {
    match kind {
        NumberType::Single => {
            let bits = value.settled(|value| nearest_f32(value).to_bits())?;
            Some(format!("{:?}", f32::from_bits(bits)))
        }
        NumberType::Double => {
            let bits = value.settled(|value| nearest(value).to_bits())?;
            Some(shortest(f64::from_bits(bits)))
        }
        NumberType::Decimal(digits) => value.settled(|value| format::fixed(value, digits)),
    }
}

/// The decimal of a number with so many significant digits, rounded to the nearest; shorter where it ends. Of a number
/// that is not told apart from a tie of two decimals, one of them.
///
/// ```
/// use subcert::exact::{Rational, RealExpression};
/// use subcert::shipped::decimal;
///
/// assert_eq!(decimal(&RealExpression::from(Rational::new(2, 3)), 5), "0.66667");
/// assert_eq!(decimal(&RealExpression::from(Rational::new(1, 4)), 5), "0.25");
/// ```
#[must_use]
pub fn decimal(value: &RealExpression, digits: u32) -> String {
    value.settled(|value| format::short(value, digits)).unwrap_or_else(|| {
        let near = value.near(LEVELS.end - 1);
        if near.contains(&Rational::zero()) {
            return "0".to_owned();
        }
        format::short(near.lower(), digits)
    })
}
