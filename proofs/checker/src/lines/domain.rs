//! Intervals of a free parameter with printed ends, for the rules `function` and `range`.

use super::pieces::Pieces;
use crate::claims::{Paper, printed};
use crate::formulas::formula;
use crate::numbers::{Decimal, Meter, Q, Root, Value, int, is_rounded};
use crate::text::{Checked, Reason, Stop, Toml, require};
use std::cmp::Ordering;

/// The most halvings of an interval.
const MAX_HALVINGS: usize = 1_000;

/// An end of a printed interval, and the unit of its last place if it may be rounded.
struct End {
    value: Value,
    unit: Option<Q>,
}

/// The values of a parameter for which a claim states something.
pub struct Domain {
    ends: [Option<End>; 2],
    closed: bool,
}

/// How rounded ends are taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// As they are printed.
    Printed,
    /// A unit of the last place further in, where they belong to the interval, unless no room is left.
    Least,
}

impl Domain {
    /// Reads `from`, `to` and `closed`.
    pub fn read(paper: &Paper<'_>, claim: &Toml) -> Checked<Domain> {
        let ends = [end(paper, claim, "from")?, end(paper, claim, "to")?];
        if let [Some(from), Some(to)] = &ends {
            // In an empty interval everything holds.
            let ordered = from.value.compare(&to.value)?.is_lt();
            require(ordered, Reason::Malformed("an end `to` above `from`"))?;
        }
        Ok(Domain { ends, closed: claim.is_set("closed") })
    }

    /// Whether there is an end.
    pub fn has_ends(&self) -> bool {
        self.ends.iter().any(Option::is_some)
    }

    /// An end so many units further in.
    fn moved(&self, side: usize, units: i64) -> Result<Option<Value>, Stop> {
        let Some(End { value, unit }) = &self.ends[side] else { return Ok(None) };
        let by = unit.as_ref().map_or_else(|| int(0), |unit| unit * int(units));
        value.plus(if side == 0 { 1 } else { -1 }, &Value::from(by)).map(Some)
    }

    /// Whether each end is taken as a rounded one.
    fn rounded(&self) -> Result<[bool; 2], Stop> {
        let room = match (self.moved(0, 1)?, self.moved(1, 1)?) {
            (Some(from), Some(to)) => from.compare(&to)?.is_lt(),
            _ => true,
        };
        let unit = |end: &Option<End>| end.as_ref().is_some_and(|end| end.unit.is_some());
        Ok(self.ends.each_ref().map(|end| room && unit(end)))
    }

    /// Whether a number is inside the interval, and whether it is outside, whatever its rounded ends stand for.
    pub fn sides(&self, at: &Q) -> Result<[bool; 2], Stop> {
        let rounded = self.rounded()?;
        let (mut inside, mut outside) = (true, false);
        for (side, beyond) in [(0, Ordering::Less), (1, Ordering::Greater)] {
            let rounded = rounded[side];
            let order = |units: i64| {
                let end = self.moved(side, if rounded { units } else { 0 })?;
                end.map(|end| Value::from(at.clone()).compare(&end)).transpose()
            };
            let (Some(least), Some(most)) = (order(1)?, order(-1)?) else { continue };
            inside &= least != beyond && (rounded || self.closed || least.is_ne());
            outside |= most == beyond || most.is_eq() && (rounded || !self.closed);
        }
        Ok([inside, outside])
    }

    /// Whether an interval with both ends has all numbers from one printed end to the other. There are two.
    pub fn is_in(&self, [low, high]: &[Q; 2]) -> Result<bool, Stop> {
        let [Some(from), Some(to)] = &self.ends else { return Ok(false) };
        let [low, high] = [low, high].map(|end| Value::from(end.clone()));
        Ok(low.compare(&from.value)?.is_le() && to.value.compare(&high)?.is_le())
    }

    /// Whether the signs in the whole interval are as `right` says.
    pub fn all(
        &self,
        ends: Ends,
        Pieces { breaks, signs }: &Pieces,
        right: impl Fn(i8) -> bool,
        meter: &Meter,
    ) -> Result<bool, Stop> {
        let inwards = self.rounded()?.map(|rounded| rounded && ends == Ends::Least);
        let [from, to] = [0, 1].map(|side| self.moved(side, i64::from(inwards[side])));
        let (from, to) = (from?, to?);
        for (place, _) in signs.iter().enumerate().filter(|(_, sign)| !right(**sign)) {
            // The break itself, or the piece between the break before it and this one.
            let (at, half) = (place % 2 == 1, place / 2);
            let low =
                if at { Some(&breaks[half]) } else { half.checked_sub(1).map(|i| &breaks[i]) };
            let beyond = |root: Option<&Root>, (end, inwards): (&Option<Value>, bool), side| {
                let Some((root, end)) = root.zip(end.as_ref()) else { return Ok(false) };
                let order = against(root, end, meter)?;
                let belongs = at && (self.closed || inwards);
                Ok::<bool, Stop>(order == side || order.is_eq() && !belongs)
            };
            let below = beyond(breaks.get(half), (&from, inwards[0]), Ordering::Less)?;
            if !below && !beyond(low, (&to, inwards[1]), Ordering::Greater)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

fn end(paper: &Paper<'_>, claim: &Toml, key: &str) -> Checked<Option<End>> {
    let Some((_, read)) = claim.get(key).and_then(printed) else { return Ok(None) };
    Ok(Some(match Decimal::read(read) {
        Some(decimal) => {
            let unit = is_rounded(&decimal).then_some(decimal.unit);
            End { value: decimal.value.into(), unit }
        }
        None => End { value: paper.library.closed().value(&formula(read)?)?, unit: None },
    }))
}

/// How a root compares with a closed value.
fn against(at: &Root, value: &Value, meter: &Meter) -> Result<Ordering, Stop> {
    let mut terms = at.polynomial().iter().rev().cloned().map(Value::from);
    let of_value =
        terms.try_fold(Value::int(0), |sum: Value, term| sum.times(value)?.plus(1, &term))?;
    let mut at = at.clone();
    for _ in 0..MAX_HALVINGS {
        let [low, high] = at.ends().map(|end| Value::from(end.clone()));
        let sides = [low.compare(value)?, high.compare(value)?];
        match sides {
            [low, high] if low.is_eq() && high.is_eq() => return Ok(Ordering::Equal),
            [Ordering::Greater | Ordering::Equal, _] => return Ok(Ordering::Greater),
            [_, Ordering::Less | Ordering::Equal] => return Ok(Ordering::Less),
            // The interval has one root of the polynomial.
            _ if of_value.is_zero() => return Ok(Ordering::Equal),
            _ => at = at.halved(meter)?,
        }
    }
    Err(Stop::Capped("the halvings of an interval"))
}
