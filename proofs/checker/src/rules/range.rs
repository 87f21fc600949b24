//! Rule `range`: where a value keeps a limit, against the printed ends.

use super::pieces::{Free, Pieces, verdict};
use crate::certificate::Block;
use crate::decimal::{Decimal, Q, read_rational};
use crate::paper::{Paper, formula_of, printed, restates};
use crate::reject::{Checked, Reason};
use crate::rounding::{Rounding, rounding};
use crate::toml::Toml;
use crate::value::{Stop, Value};
use num_traits::Signed;

/// An end of an interval: `None` if it is infinite, and whether it belongs to the set.
type End = (Option<Q>, bool);

/// Checks a range.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let free = Free::read(paper, claim, block)?;
    let head = block.head;
    let stopped = |stop| head.reject(Reason::Stopped(stop));
    let (line, said) = block.take("value")?;
    restates(line, "value", said, claim.text("value"))?;
    let below = claim.get("below").is_some();
    let (word, key) = if below { ("below", "below") } else { ("at-most", "at_most") };
    let (line, said) = block.take(word)?;
    restates(line, word, said, claim.text(key))?;
    let value = formula_of(claim, "value").map_err(stopped)?;
    let limit = formula_of(claim, key).and_then(|limit| paper.nothing().value(&limit));
    let limit = limit.map_err(stopped)?;
    let pieces = free.pieces(block, |scope| scope.value(&value)?.plus(-1, &limit))?;
    let set = intervals(&pieces, below);
    let mut relations = Vec::new();
    for (side, name) in ["from", "to"].into_iter().enumerate() {
        let Some(field) = claim.get(name) else {
            relations.push(match &set[..] {
                [only] if only[side].0.is_none() => "equal",
                _ => "apart",
            });
            continue;
        };
        let (line, said) = block.take("end")?;
        let (text, read) = printed(field).unwrap_or_default();
        let decimal = Decimal::read(read).ok_or(line.reject(Reason::Ends))?;
        let said = said.strip_prefix(&format!("{name} \"{text}\" "));
        let said = said.ok_or(line.reject(Reason::Ends))?;
        let (exact, relation) = said.split_once(' ').ok_or(line.reject(Reason::Ends))?;
        let ends = set.iter().map(|interval| &interval[side]);
        let ends = ends.filter_map(|(end, belongs)| Some((end.clone()?, *belongs)));
        let at = decimal.value();
        let nearest = ends.min_by_key(|(end, _)| (end - &at).abs());
        let found = match &nearest {
            None => exact == "none",
            Some((end, _)) => read_rational(exact).as_ref() == Some(end),
        };
        if !found {
            return Err(line.reject(Reason::ExactEnd));
        }
        let closed = match claim.get("closed") {
            Some(Toml::Flag(closed)) => Some(*closed),
            _ => None,
        };
        let end = PrintedEnd { decimal, closed, outwards: if side == 0 { -1 } else { 1 } };
        let expected = end.relation(nearest.as_ref(), &set);
        let expected = expected.map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        if relation.trim() != expected {
            return Err(line.reject(Reason::Relation));
        }
        relations.push(expected);
    }
    let expected = match &set[..] {
        [_] if relations.iter().all(|relation| *relation == "equal") => "exact",
        [_] if relations.iter().all(|word| !["belonging", "apart"].contains(word)) => "rounding",
        _ => "inexact",
    };
    let (line, found, rest) = verdict(block)?;
    if found == expected && rest.is_empty() { Ok(()) } else { Err(line.reject(Reason::Verdict)) }
}

/// The intervals of the set where the sign is −1, or, unless `below`, 0 too.
fn intervals(pieces: &Pieces, below: bool) -> Vec<[End; 2]> {
    let mut intervals: Vec<[End; 2]> = Vec::new();
    let inside =
        |at: usize| pieces.signs.get(at).is_some_and(|sign| *sign < 0 || *sign == 0 && !below);
    for at in (0..pieces.signs.len()).filter(|at| inside(*at)) {
        // Odd places are breaks, and even ones the pieces between.
        let (odd, half) = (at % 2 == 1, at / 2);
        let low = if odd { Some(half) } else { half.checked_sub(1) };
        let high = (pieces.breaks.get(half).cloned(), odd);
        match intervals.last_mut().filter(|_| at > 0 && inside(at - 1)) {
            Some(last) => last[1] = high,
            None => intervals.push([(low.and_then(|i| pieces.breaks.get(i).cloned()), odd), high]),
        }
    }
    intervals
}

struct PrintedEnd {
    decimal: Decimal,
    closed: Option<bool>,
    /// −1 for a lower end, 1 for an upper one.
    outwards: i64,
}

impl PrintedEnd {
    fn relation(&self, exact: Option<&(Q, bool)>, set: &[[End; 2]]) -> Result<&'static str, Stop> {
        let Some((end, belongs)) = exact else { return Ok("apart") };
        let at = self.decimal.value();
        if at == *end {
            let same = self.closed.is_none_or(|closed| closed == *belongs);
            return Ok(if same { "equal" } else { "belonging" });
        }
        Ok(match rounding(&self.decimal, &Value::from(end.clone()))? {
            Rounding::Nearest => "nearest",
            Rounding::Cut => "cut",
            Rounding::Away => "away",
            Rounding::Neither => {
                let inside = set.iter().any(|[low, high]| {
                    low.0.as_ref().is_none_or(|low| *low < at)
                        && high.0.as_ref().is_none_or(|high| at < *high)
                });
                let next = at + self.decimal.unit() * Q::from_integer(self.outwards.into());
                let last = inside && next == *end && !belongs && self.closed != Some(false);
                if last { "last-inside" } else { "apart" }
            }
        })
    }
}
