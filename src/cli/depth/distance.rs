//! Depths and distances that are known from both sides.

use super::numbers;
use crate::cli::console::output::with_decimal;
use crate::cli::console::quantity::{Text, written};
use serde::Serialize;
use subcert::exact::{Enclosure, Integer, Rational, format::short};
use subcert::limit::{self, LimitError, TwoSidedDepth};
use subcert::patch::GeometricDepth;
use subcert::report::json::Exact;

/// A depth from both sides: the least level that meets the tolerance with all later ones.
#[derive(Clone, Copy, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct TwoSided {
    /// A level that meets the tolerance with all later ones: the upper side.
    pub(super) level: u32,
    /// The depth is at least this: the level before it does not meet the tolerance, or this is 0.
    lower: u32,
    /// The depth is at most this: this level and all later ones meet the tolerance.
    upper: u32,
    /// Whether `lower` and `upper` are the same.
    minimal: bool,
}

impl From<TwoSidedDepth> for TwoSided {
    fn from(TwoSidedDepth { lower, upper }: TwoSidedDepth) -> TwoSided {
        TwoSided { level: upper, lower, upper, minimal: lower == upper }
    }
}

impl TwoSided {
    /// The depth that `whom` has; `caps` are those of the search.
    pub(super) fn words(self, whom: &str, caps: &str) -> String {
        let TwoSided { lower, upper, minimal, .. } = self;
        let below = lower.checked_sub(1).map(numbers::too_few).unwrap_or_default();
        if minimal {
            return format!("{}, for {whom}{below}", numbers::levels(upper));
        }
        format!(
            "from {lower} to {upper} levels, for {whom}{below}; the caps of the search leave it open: {caps}"
        )
    }
}

/// A depth by the Hausdorff distance of a control polygon, a mesh or a net and its limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Sets"))]
pub(super) struct AsSets<P> {
    /// The least level found to be sufficient; null where the search ended before it found one.
    pub(super) level: Option<u32>,
    /// Why the search ended early: it was stopped, or met a cap.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
    /// The greatest level that is certainly not sufficient, with all below it.
    pub(super) too_few: Option<u32>,
    /// A point that shows that `too_few` is not sufficient.
    too_far: Option<P>,
}

impl<P> AsSets<P> {
    pub(super) fn of<Q>(found: GeometricDepth<Q>, place: impl FnOnce(Q) -> P) -> AsSets<P> {
        let GeometricDepth { level, too_few, ended, beyond, .. } = found;
        AsSets { level, ended, too_few, too_far: beyond.map(place) }
    }

    /// The greatest level that is not sufficient, and a point that shows it.
    pub(super) fn beyond(&self) -> Option<(u32, &P)> {
        self.too_few.zip(self.too_far.as_ref())
    }

    /// What the level says, as a sentence.
    pub(super) fn meaning(&self) -> &'static str {
        let below = self.level.and_then(|level| level.checked_sub(1));
        if self.level.is_some() && self.too_few == below {
            "The depth is the least level that is within the tolerance; nothing is said about later ones."
        } else {
            "The depth is the least level that is within the tolerance: it is not known exactly here, and nothing is said \
             about the levels in between and later ones."
        }
    }

    /// The level that is enough, with `more` about it, those that are too few, and why the search ended early.
    pub(super) fn words(&self, more: &str) -> String {
        let text = match (self.level, self.too_few) {
            (Some(level), few) => {
                let most = numbers::at_most(level, few, self.ended.is_some());
                format!("{most}{}{more}{}", numbers::levels(level), numbers::few_text(level, few))
            }
            (None, None) => format!("open{more}"),
            (None, Some(few)) => format!("more than {}{more}", numbers::levels(few)),
        };
        match &self.ended {
            Some(why) => format!("{text}: {why}"),
            None => text,
        }
    }
}

/// An interval that holds a number.
#[derive(Clone)]
pub(super) struct Interval(pub(super) Enclosure);

/// An interval that holds a number.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Ends {
    /// Its lower end.
    lower: Exact,
    /// Its upper end.
    upper: Exact,
}

written!(interval: Interval => Ends, {
    let [lower, upper] = [interval.0.lower(), interval.0.upper()].map(Exact::of);
    Ends { lower, upper }
});

/// The most digits that an end of an interval can have here.
const DIGITS: u32 = 400;

impl Interval {
    /// Both ends as decimals, the lower one rounded down and the upper one up, to a tenth of
    /// the width or less; of a single number its exact value.
    fn words(&self) -> String {
        let Interval(interval) = self;
        let width = interval.width();
        if width.is_zero() {
            return with_decimal(interval.lower());
        }
        let mut places = 0;
        while Rational::power_of_ten(1 - places) > width {
            places += 1;
        }
        let scale = Rational::power_of_ten(places);
        let floor = |value: &Rational| value.numerator().div_floor(&value.denominator());
        let down: Integer = floor(&(interval.lower() * &scale));
        let up: Integer = -floor(&-(interval.upper() * &scale));
        let decimal = |value: Integer| short(&(Rational::from(value) / &scale), DIGITS);
        format!("{} to {}", decimal(down), decimal(up))
    }
}

/// A distance at a level.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Distance {
    /// An interval that holds it; its fields stand here.
    #[serde(flatten)]
    pub(super) interval: Interval,
    /// The level.
    pub(super) level: u32,
    /// Whether the interval is as narrow as was asked for.
    pub(super) within_width: bool,
    /// A parameter at which the distance has the value of the lower end.
    pub(super) parameter: Option<Text<Rational>>,
}

impl Distance {
    /// The distance at a level, also if the caps leave the interval wide.
    pub(super) fn of(
        found: Result<limit::Distance, LimitError>,
        level: u32,
    ) -> Result<Distance, LimitError> {
        let (enclosure, parameter) = match found {
            Ok(found) => (found.enclosure, Some(Text(found.parameter))),
            Err(LimitError::TooFine { reached, .. }) => (*reached, None),
            Err(error) => return Err(error),
        };
        let within_width = parameter.is_some();
        Ok(Distance { interval: Interval(enclosure), level, within_width, parameter })
    }

    /// It in words, with the caps that leave it wide.
    pub(super) fn words(&self, caps: &str) -> String {
        let text = self.interval.words();
        if self.within_width {
            text
        } else {
            format!("{text}, as narrow as the caps allow: {caps}")
        }
    }
}
