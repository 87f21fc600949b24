//! The rule `table`: the readings and cells of a table, and what follows them.

pub mod attained;
pub mod cell;
pub mod claim;
pub mod copied;
pub mod elsewhere;
pub mod family;
pub mod promise;
pub mod reading;
pub mod recovered;
pub mod sound;

use super::kind::{Kind, Proof};
use crate::claims::Paper;
use crate::text::{Block, Checked, Reason, Toml, require};
use cell::Standing;
use claim::{Read, Table};
use reading::Reads;
use recovered::Recovered;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "table",
    fields: "table: claim value=text promise=promise rows=axis columns=axis \
 cells=text|**number given=%text unstated=%text|*text figures=*figure
promise: tolerance=text level=text spread=text offset=text ring=text
figure: locus=text lines=*text",
    names,
    check: |paper, claim, block| check(paper, claim, block).map(Proof::Recovers),
};

/// Checks a table. Gives the recovered values that it takes from other tables, and those that its own
/// numbers give.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Recovered> {
    let mut table = Table::new(paper, claim)?;
    block.may_restate("scheme", claim.text("scheme"))?;
    block.restates("value", claim.text("value"))?;
    let recovered = recovered::read(&mut table, block)?;
    let reads = Reads::new(&table, block)?;
    let (mut places, mut kinds) = (table.places(), Vec::new());
    while let Some(said) = block.maybe("cell") {
        let place = places.next().ok_or(Reason::Cell)?;
        kinds.push((place, cell::check(&table, &reads, place, said)?));
    }
    block.look();
    require(places.next().is_none(), Reason::CellsMissing)?;
    let read = Read::default();
    while let Some(said) = block.maybe("attained") {
        attained::check(&table, &read, said)?;
    }
    while let Some(said) = block.maybe("sound") {
        sound::check(&table, said)?;
    }
    promise::check(&table, block)?;
    family::check(&table, &reads, &kinds, block)?;
    // Only what they reproduce gives a value: without it, promises and theorems could rest on any.
    let gives =
        kinds.iter().any(|(_, kind)| matches!(kind, Standing::AsPrinted | Standing::Reproduced));
    if let Some((name, _)) = recovered.own.first().filter(|_| !gives) {
        return Err(Reason::Undetermined(name.clone()).into());
    }
    Ok(recovered)
}

/// The parameters of a table.
fn names(claim: &Toml) -> Vec<&str> {
    let axes = ["rows", "columns"].iter().filter_map(|key| claim.get(key));
    let axes = axes.filter_map(|axis| axis.text("name"));
    let open = claim.names("unstated").chain(claim.texts("unstated"));
    axes.chain(claim.names("given")).chain(open).collect()
}
