//! The rule `range`: the set on which a value keeps a limit, and its printed ends.

mod convex;
mod polygon;
mod region;
pub mod smooth;
mod triangles;

use super::kind::{Kind, Proof};
use crate::claims::{Paper, printed};
use crate::formulas::formula_of;
use crate::lines::pieces::{Free, Pieces};
use crate::numbers::{Decimal, Meter, Piece, Root, Value, int, is_rounded, rounding_on};
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, Verdict, agree, compare, require};

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "range",
    fields: "range: claim variable=text value=text below=text at_most=text smoothness=text from=number \
 to=number closed=flag only=flag valences=text variables=*text where=text|*text",
    names: |claim| claim.text("variable").into_iter().chain(claim.texts("variables")).collect(),
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// An end of an interval, `None` if it is infinite, and whether the end belongs to the set.
type End = (Option<Root>, bool);

/// Checks a range.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if ["variables", "where"].iter().any(|key| claim.get(key).is_some()) {
        return region::check(paper, claim, block);
    }
    if claim.get("smoothness").is_some() {
        return smooth::check(paper, claim, block);
    }
    require(claim.get("valences").is_none(), Reason::Malformed("`valences` beside `smoothness`"))?;
    let free = Free::read(paper, claim, block)?;
    block.restates("value", claim.text("value"))?;
    let below = claim.get("below").is_some();
    if below && claim.get("at_most").is_some() {
        return Err(Stop::Wrong("the claim has both `below` and `at_most`".into()).into());
    }
    let (word, key) = if below { ("below", "below") } else { ("at-most", "at_most") };
    block.restates(word, claim.text(key))?;
    let value = formula_of(claim, "value")?;
    let limit = paper.library.closed().value(&formula_of(claim, key)?)?;
    let pieces = free.pieces(block, &|scope| scope.value(&value)?.minus(&limit))?;
    let set = intervals(&pieces, below);
    let (mut relations, meter) = (Vec::new(), paper.library.meter);
    for (side, name, outwards) in [(0, "from", -1), (1, "to", 1)] {
        let Some(field) = claim.get(name) else {
            let infinite = matches!(&set[..], [only] if only[side].0.is_none());
            relations.push(if infinite { "equal" } else { "apart" });
            continue;
        };
        let said = block.after("end")?;
        let (text, read) = printed(field).unwrap_or_default();
        let claimed = format!("{name} \"{text}\"");
        let other = || Reason::Ends(Text(said.to_string()), Text(claimed.clone()));
        let decimal = Decimal::printed(read).ok_or_else(other)?;
        let rest = said.strip_prefix(&claimed).and_then(|rest| rest.strip_prefix(' '));
        let rest = rest.and_then(|rest| rest.split_once(' '));
        let (exact, relation) = rest.ok_or_else(other)?;
        let ends = set.iter().map(|interval| &interval[side]);
        let ends = ends.filter_map(|(end, belongs)| Some((end.as_ref()?, *belongs)));
        let mut nearest: Option<(&Root, bool)> = None;
        for (end, belongs) in ends {
            let nearer = match nearest {
                Some((other, _)) => end.nearer(other, &decimal.value, meter)?.is_lt(),
                None => true,
            };
            nearest = if nearer { Some((end, belongs)) } else { nearest };
        }
        let found = match (&nearest, Root::read(exact, meter)?) {
            (None, _) => exact == "none",
            (Some((end, _)), Some(exact)) => end.compare(&exact, meter)?.is_eq(),
            _ => false,
        };
        let end = nearest.map_or("none".to_owned(), |(end, _)| end.to_string());
        compare(found, exact, &end, Reason::ExactEnd)?;
        let closed = match claim.get("closed") {
            Some(Toml::Flag(closed)) => Some(*closed),
            _ => None,
        };
        let expected = self::relation(&decimal, closed, outwards, nearest, &set, meter)?;
        agree(relation.trim(), expected, Reason::Relation)?;
        relations.push(expected);
    }
    // Between ends in the wrong order there is nothing, however near they are to the exact ones; nor between equal
    // ends, unless they belong to the range.
    let [from, to] = ["from", "to"].map(|name| {
        let (_, read) = claim.get(name).and_then(printed)?;
        Some(Decimal::printed(read)?.value)
    });
    let closed = claim.is_set("closed");
    let reversed = from.zip(to).is_some_and(|(from, to)| from > to || from == to && !closed);
    let expected = match &set[..] {
        [_] if reversed => Verdict::Inexact,
        [_] if relations.iter().all(|relation| *relation == "equal") => Verdict::Exact,
        [_] if relations.iter().all(|word| !["belonging", "apart"].contains(word)) => {
            Verdict::Rounding
        }
        _ => Verdict::Inexact,
    };
    block.verdict(expected)
}

/// The intervals on which the sign is −1, or 0 unless `below`.
fn intervals(pieces: &Pieces, below: bool) -> Vec<[End; 2]> {
    let mut intervals: Vec<[End; 2]> = Vec::new();
    let inside =
        |at: usize| pieces.signs.get(at).is_some_and(|sign| *sign < 0 || *sign == 0 && !below);
    for at in (0..pieces.signs.len()).filter(|at| inside(*at)) {
        // The signs with odd indices are at breaks, the others on pieces.
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

/// The relation of a printed end to the exact one. `closed` says whether the printed end belongs
/// to the set; `outwards` is −1 for a lower end and 1 for an upper one.
fn relation(
    printed: &Decimal,
    closed: Option<bool>,
    outwards: i64,
    exact: Option<(&Root, bool)>,
    set: &[[End; 2]],
    meter: &Meter,
) -> Result<&'static str, Stop> {
    let Some((end, belongs)) = exact else { return Ok("apart") };
    let at = Root::from(printed.value.clone());
    if at.compare(end, meter)?.is_eq() {
        let same = closed.is_none_or(|closed| closed == belongs);
        return Ok(if same { "equal" } else { "belonging" });
    }
    // The end is a symbol that has this value alone.
    let piece = Piece::new("x", [Some(end.clone()), Some(end.clone())], meter);
    let found = rounding_on(printed, &Value::symbol("x"), Some(&piece))?;
    if found != "neither" {
        return Ok(if is_rounded(printed) { found } else { "apart" });
    }
    let next = Root::from(&printed.value + &printed.unit * int(outwards));
    if belongs || closed == Some(false) || !next.compare(end, meter)?.is_eq() {
        return Ok("apart");
    }
    for [low, high] in set {
        let above = low.0.as_ref().map_or(Ok(true), |low| Ok(low.compare(&at, meter)?.is_lt()))?;
        let below =
            high.0.as_ref().map_or(Ok(true), |high| Ok(at.compare(high, meter)?.is_lt()))?;
        if above && below {
            return Ok("last-inside");
        }
    }
    Ok("apart")
}
