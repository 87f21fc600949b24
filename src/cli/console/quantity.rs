//! Numbers in answers. An answer holds a number itself; JSON and words are made of it when they are written.

use super::output::with_decimal;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use subcert::exact::{
    Enclosed, Enclosure, Integer, Rational, RealCyclotomic, RealExpression, Scalar as _,
    format::short, parse_rational,
};
use subcert::float::{exact, shortest};
use subcert::report::json::{Exact, HoelderForm};
use subcert::report::{down, up};
use subcert::scheme;

/// A number: in JSON its exact value with a decimal.
#[derive(Clone, PartialEq)]
pub(crate) enum Number {
    Rational(Rational),
    Cyclotomic(RealCyclotomic),
    Expression(RealExpression),
}

/// A rational number that is a [`Number`] in JSON.
#[derive(Clone)]
pub(crate) struct Fraction(pub(crate) Rational);

/// A number that is its exact value alone in JSON.
#[derive(Clone)]
pub(crate) struct Text<V>(pub(crate) V);

/// An f64: in JSON the shortest decimal that is read as it, in words at most nine digits.
#[derive(Clone, Copy)]
pub(crate) struct Float(pub(crate) f64);

/// A number that is a decimal of so many significant digits in JSON.
pub(crate) struct Digits<const DIGITS: u32>(pub(crate) Number);

impl Float {
    /// It exactly, where it is finite.
    pub(crate) fn number(self) -> Option<Number> {
        exact(self.0).map(Number::Rational)
    }
}

/// A number that is above another one, in nine digits, or as many more as the decimal needs to be above it, too.
pub(crate) fn above(number: &(impl Enclosed + Display), other: &Rational) -> String {
    decimal(number, other, |digits| short(number, digits))
}

/// The first text of nine digits or more that is above another number; else the number.
fn decimal(number: &impl Display, other: &Rational, text: impl Fn(u32) -> String) -> String {
    let found = (9..=MOST_DIGITS).map(text);
    let right = |text: &String| parse_rational(text).is_ok_and(|shown| shown > *other);
    found.into_iter().find(right).unwrap_or_else(|| number.to_string())
}

/// The most digits that are tried.
const MOST_DIGITS: u32 = 60;

impl Float {
    /// It as a lower bound that is [`above`] another number: rounded down.
    pub(crate) fn above(self, other: &Rational) -> String {
        match exact(self.0).filter(|bound| bound.sign() > 0) {
            None => self.to_string(),
            Some(bound) => decimal(&bound, other, |digits| self.rounded(digits, Rational::floor)),
        }
    }

    /// Nine digits of it as a lower bound: rounded down.
    pub(crate) fn down(self) -> String {
        self.rounded(9, Rational::floor)
    }

    /// So many digits of it as an upper bound: rounded up.
    pub(crate) fn up(self, digits: u32) -> String {
        self.rounded(digits, Rational::ceil)
    }

    /// So many digits, or one more, with an integer in units of the last one.
    fn rounded(self, digits: u32, to_integer: impl Fn(&Rational) -> Integer) -> String {
        let Some(value) = exact(self.0).filter(|value| !value.is_zero()) else {
            return self.to_string();
        };
        #[expect(clippy::cast_possible_truncation, reason = "a power of ten of an f64")]
        let power = self.0.abs().log10().floor() as i32;
        let unit = Rational::power_of_ten(power + 1 - i32::try_from(digits).unwrap_or(0));
        short(&(Rational::from(to_integer(&(&value / &unit))) * unit), digits + 1)
    }
}

impl Number {
    /// The exact value and its decimal, where they differ.
    pub(crate) fn words(&self) -> String {
        with_decimal(self)
    }

    pub(crate) fn is_zero(&self) -> bool {
        match self {
            Number::Rational(value) => value.is_zero(),
            Number::Cyclotomic(value) => *value == RealCyclotomic::zero(),
            Number::Expression(value) => *value == RealExpression::zero(),
        }
    }

    /// It in so many significant digits.
    pub(crate) fn short(&self, digits: u32) -> String {
        short(self, digits)
    }
}

impl From<&Rational> for Number {
    fn from(value: &Rational) -> Number {
        Number::Rational(value.clone())
    }
}

impl From<&RealCyclotomic> for Number {
    fn from(value: &RealCyclotomic) -> Number {
        Number::Cyclotomic(value.clone())
    }
}

impl From<&RealExpression> for Number {
    fn from(value: &RealExpression) -> Number {
        Number::Expression(value.clone())
    }
}

impl Enclosed for Number {
    fn enclosure(&self, level: u32) -> Enclosure {
        match self {
            Number::Rational(value) => value.enclosure(level),
            Number::Cyclotomic(value) => value.enclosure(level),
            Number::Expression(value) => value.enclosure(level),
        }
    }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Number::Rational(value) => value.fmt(f),
            Number::Cyclotomic(value) => value.fmt(f),
            Number::Expression(value) => value.fmt(f),
        }
    }
}

impl<V: Display> Display for Text<V> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Display for Float {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.number().map_or_else(|| shortest(self.0), |value| value.short(9)))
    }
}

/// In JSON, and in its schema, an answer or a part of it is this form.
macro_rules! written {
    ($([$($generics:tt)*])? $this:ident: $name:ty => $form:ty, $value:expr) => {
        impl$(<$($generics)*>)? serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let $this = self;
                $value.serialize(serializer)
            }
        }
        #[cfg(feature = "schema")]
        impl$(<$($generics)*>)? schemars::JsonSchema for $name {
            fn inline_schema() -> bool {
                <$form>::inline_schema()
            }
            fn schema_name() -> std::borrow::Cow<'static, str> {
                <$form>::schema_name()
            }
            fn schema_id() -> std::borrow::Cow<'static, str> {
                <$form>::schema_id()
            }
            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                <$form>::json_schema(generator)
            }
        }
    };
}
pub(crate) use written;

written!(number: Number => Exact, Exact::of(number));
written!(number: Fraction => Exact, Exact::of(&number.0));
written!([V: Display] text: Text<V> => String, text.0.to_string());
written!(float: Float => String, shortest(float.0));
written!([const DIGITS: u32] number: Digits<DIGITS> => String, number.0.short(DIGITS));

/// An enclosure as decimals that are rounded outwards, or the number that it is.
pub(crate) fn between(enclosure: &Enclosure) -> String {
    let [low, high] = [enclosure.lower(), enclosure.upper()];
    if low == high { low.to_string() } else { format!("from {} to {}", down(low), up(high)) }
}

/// A Hölder exponent in words.
pub(crate) fn exponent(found: &HoelderForm) -> String {
    let HoelderForm { lower, upper, exact, .. } = found;
    match exact {
        Some(exact) if is_fraction(exact) => exact.clone(),
        Some(exact) => format!("{exact}\nfrom {lower} to {upper}"),
        None => format!("from {lower} to {upper}"),
    }
}

/// The longest exact value that is shown.
pub(crate) const LONGEST: usize = 32;

/// A Hölder exponent in a line.
pub(crate) fn exponent_in_short(found: &HoelderForm) -> String {
    let not = if found.attained == Some(false) { ", not attained" } else { "" };
    match &found.exact {
        Some(exact) if is_fraction(exact) => format!("{exact}{not}"),
        Some(exact) if exact.len() <= LONGEST => format!("{exact} = {}…{not}", found.lower),
        Some(_) => format!("{}…{not}", found.lower),
        None => format!("open: from {} to {}", found.lower, found.upper),
    }
}

/// Whether this is an integer or p/q.
pub(crate) fn is_fraction(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_digit() || matches!(c, '-' | '/'))
}

/// Points that are alike.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Orbit {
    /// Their name.
    pub name: String,
    /// Their number.
    pub count: usize,
}

impl Orbit {
    pub(crate) fn all(orbits: &[scheme::Orbit]) -> Vec<Orbit> {
        orbits.iter().map(|one| Orbit { name: one.name.clone(), count: one.count }).collect()
    }

    /// `1 vertex, 5 edge`.
    pub(crate) fn words(orbits: &[Orbit]) -> String {
        let orbits = orbits.iter().map(|one| format!("{} {}", one.count, one.name));
        orbits.collect::<Vec<String>>().join(", ")
    }
}

/// Which rows of a mask belong so many places further, and what holds then; `None` where there are none.
pub(crate) fn misplaced_rows(rows: &[(usize, i64)]) -> Option<String> {
    let one = |&(row, places): &(usize, i64)| {
        let far = match places.unsigned_abs() {
            1 => "one place".to_owned(),
            far => format!("{far} places"),
        };
        format!("row {row} belongs {far} {}", if places > 0 { "further" } else { "back" })
    };
    let all: Vec<String> = rows.iter().map(one).collect();
    let then = "then the sum rules hold up to order 2 at least";
    (!all.is_empty()).then(|| format!("{}: {then}", all.join(", and ")))
}

/// For which m the limits are proven to be C^m, and for which not.
pub(crate) fn proved_continuity(continuity: Option<usize>, fails: Option<usize>) -> String {
    match (continuity, fails) {
        (_, Some(0)) => "diverges".to_owned(),
        (Some(m), Some(fails)) if fails == m + 1 => format!("C^{m}, not C^{fails}"),
        (Some(m), Some(fails)) => format!("C^{m}, not C^{fails}; between is open"),
        (Some(m), None) => format!("C^{m} at least"),
        (None, Some(fails)) => format!("convergence is open, not C^{fails}"),
        (None, None) => "open".to_owned(),
    }
}
