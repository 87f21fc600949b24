//! The rule `smoothness`: whether the limits of a scheme are C^m.

use super::kind::{Citation, Kind, Proof};
use crate::claims::Paper;
use crate::formulas::Scope;
use crate::lines::limits::{LimitProof, verdict};
use crate::numbers::Value;
use crate::schemes::{LocalRules, VALENCE_NAMES};
use crate::text::{Block, Checked, Reason, Stop, Toml, Verdict, agree, require};
use crate::vertex::{Found, check_vertex};

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "smoothness",
    fields: "smoothness: claim continuous=text not_continuous=text valences=text absent=text given=%text",
    names: |claim| claim.names("given").collect(),
    check,
};

/// The greatest m of a C^m.
const MAX_ORDER: usize = 64;

/// The greatest valence.
const MAX_VALENCE: i64 = 100;

/// The steps of a vertex.
const VERTEX_STEPS: u64 = 100_000;

/// Checks a claim that all limits are C^m, or not all; gives the statement that is cited, if one is.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Proof> {
    let keys = ["continuous", "not_continuous"];
    if lacking(claim, &keys, block)? {
        return Ok(Proof::Other);
    }
    block.restates("scheme", claim.text("scheme"))?;
    let orders = keys.map(|key| claim.text(key).map(order));
    let [continuous, not_continuous] = orders.map(Option::transpose);
    let (continuous, not_continuous) = (continuous?, not_continuous?);
    block.may_restate("states-continuous", claim.text(keys[0]))?;
    block.may_restate("states-not-continuous", claim.text(keys[1]))?;
    block.may_restate("valences", claim.text("valences"))?;
    let stated = continuous.is_some() || not_continuous.is_some();
    require(stated, Reason::Malformed("continuous or not_continuous"))?;
    if paper.library.is_ring(claim.text("scheme").unwrap_or_default()) {
        if let Some(said) = block.maybe("proved-by") {
            return cited(paper, claim, (continuous, not_continuous), said, block)
                .map(Proof::Cited);
        }
        return vertices(paper, claim, (continuous, not_continuous), block).map(|()| Proof::Other);
    }
    require(claim.get("valences").is_none(), Reason::Malformed("rules around a vertex"))?;
    let shown = LimitProof::read(paper, claim, &scope(paper, claim)?, block)?;
    let found = verdict(
        continuous.is_none_or(|m| shown.continuous(m))
            && not_continuous.is_none_or(|m| shown.not_continuous(m)),
        continuous.is_some_and(|m| shown.not_continuous(m))
            || not_continuous.is_some_and(|m| shown.continuous(m)),
    )?;
    block.verdict(found).map(|()| Proof::Other)
}

/// The schemes of the catalogue of which THEOREMS.md, 133 and 135, say that they are C¹ for all valences.
const FOR_ALL: [&str; 4] = ["catmull-clark", "doo-sabin", "loop", "loop-warren"];

/// A claim about all valences that cites this statement.
fn cited(
    paper: &Paper<'_>,
    claim: &Toml,
    (continuous, not_continuous): (Option<usize>, Option<usize>),
    said: &str,
    block: &mut Block<'_>,
) -> Checked<Citation> {
    agree(said, "THEOREMS 135", Reason::Restated)?;
    let name = claim.text("scheme").unwrap_or_default().trim();
    let known = FOR_ALL.contains(&name) && !paper.library.redefines(name);
    require(known, Reason::Vertex("135 speaks of this scheme"))?;
    let states = claim.text("valences") == Some("all")
        && continuous.is_some_and(|m| m <= 1)
        && not_continuous.is_none();
    require(states, Reason::Vertex("135 says what is stated"))?;
    block.verdict(Verdict::Confirmed)?;
    Ok(Citation { statement: "THEOREMS.md, 135".to_owned(), uses: Vec::new() })
}

/// The valences of which a claim speaks: the first, and the last if there is one.
pub type Valences = Option<(i64, Option<i64>)>;

/// Reads them.
pub fn valences(claim: &Toml) -> Checked<Valences> {
    let number = |text: &str| {
        let number: Option<i64> = text.parse().ok();
        number.filter(|n| (3..=MAX_VALENCE).contains(n)).ok_or(Reason::Malformed("valences"))
    };
    let ends = match claim.text("valences").map(|said| (said, said.split_once(".."))) {
        None => None,
        Some(("all", _)) => Some((3, None)),
        Some((one, None)) => Some((number(one)?, Some(number(one)?))),
        Some((_, Some((first, last)))) => Some((number(first)?, Some(number(last)?))),
    };
    // Of no valence everything would hold.
    let ordered = ends.is_none_or(|(first, last)| last.is_none_or(|last| first <= last));
    require(ordered, Reason::Malformed("valences, of which the first is not above the last"))?;
    Ok(ends)
}

/// Reads the lines about the valence that is said, which is one of these; the names of the scope have values. In the formulas of the reference, names of
/// a valence without another meaning stand for it.
pub fn vertex(
    paper: &Paper<'_>,
    claim: &Toml,
    (said, ends): (&str, Valences),
    scope: &mut Scope<'_>,
    block: &mut Block<'_>,
) -> Checked<(i64, Found)> {
    let valence: i64 =
        said.parse().ok().filter(|n| *n >= 3).ok_or(Reason::Malformed("a valence"))?;
    let within = ends
        .is_none_or(|(first, last)| first <= valence && last.is_none_or(|last| valence <= last));
    require(within, Reason::Vertex("the claim speaks of this valence"))?;
    let reference = claim.text("scheme").unwrap_or_default();
    let free = |name: &&str| ends.is_some() && scope.is_unknown(name);
    let free: Vec<&str> = VALENCE_NAMES.into_iter().filter(free).collect();
    for name in &free {
        scope.values.insert((*name).to_owned(), Value::int(valence));
    }
    let ring = LocalRules::of_valence(paper.library, reference, scope, ends.map(|_| valence))?;
    for name in free {
        scope.values.remove(name);
    }
    paper.library.meter.spend(VERTEX_STEPS)?;
    let found = check_vertex(&ring, usize::try_from(valence).unwrap_or(0), block)?;
    Ok((valence, found))
}

/// Checks a claim that surfaces at a vertex or on a face are C^m, or are not.
fn vertices<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    (continuous, not_continuous): (Option<usize>, Option<usize>),
    block: &mut Block<'_>,
) -> Checked<()> {
    let mut scope = scope(paper, claim)?;
    let ends = valences(claim)?;
    let (mut refuted, mut next) = (false, ends.map_or(0, |(first, _)| first));
    let (mut complete, mut confirmed) = (true, true);
    while let Some(said) = block.maybe("vertex") {
        let (valence, found) = vertex(paper, claim, (said, ends), &mut scope, block)?;
        if ends.is_some() {
            complete &= valence == next;
            next = valence + 1;
        }
        let holds = |m: usize| matches!(found, Found::Smooth(most) if m <= most);
        let fails = |m: usize| found == Found::Rough && m >= 1;
        confirmed &= continuous.is_none_or(holds) && not_continuous.is_none_or(fails);
        refuted |= continuous.is_some_and(fails) || not_continuous.is_some_and(holds);
        complete &= ends.is_some() || next == 0;
        next = if ends.is_some() { next } else { 1 };
    }
    complete &= match ends {
        None => next == 1,
        Some((_, last)) => last.is_some_and(|last| next == last + 1),
    };
    let found = verdict(complete && confirmed, refuted)?;
    block.verdict(found)
}

/// Whether the paper lacks what the claim would need. Then the claim states nothing.
pub fn lacking(claim: &Toml, stated: &[&str], block: &mut Block<'_>) -> Checked<bool> {
    if claim.get("absent").is_none() {
        return Ok(false);
    }
    let none = stated.iter().all(|key| claim.get(key).is_none());
    require(none, Reason::Malformed("a statement, or what is absent, but not both"))?;
    block.restates("absent", claim.text("absent"))?;
    Ok(true)
}

/// m of C^m.
pub fn order(text: &str) -> Checked<usize> {
    let order = text.parse().ok().filter(|order| *order <= MAX_ORDER);
    Ok(order.ok_or_else(|| Stop::Wrong(format!("`{text}` is no order of smoothness")))?)
}

/// The scope of a claim: the values of the paper, and its own, which hide those.
pub fn scope<'a>(paper: &'a Paper<'a>, claim: &Toml) -> Checked<Scope<'a>> {
    let mut scope = paper.stated();
    scope.values.extend(paper.constants(claim.entries("given"))?);
    Ok(scope)
}
