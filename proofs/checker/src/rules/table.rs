//! The rule `table`: the readings and cells of a table, and what follows them.

use super::cell::Kind;
use super::reading::Reads;
use super::recovered::{self, Recovered};
use super::{attained, cell, family, promise, sound};
use crate::certificate::Block;
use crate::paper::Paper;
use crate::reject::{Checked, Reason, require};
use crate::table::{Read, Table};
use crate::toml::Toml;

/// Checks a table. Gives the recovered values that it takes from other tables, and those that its own
/// numbers give.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Recovered> {
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
    let gives = kinds.iter().any(|(_, kind)| matches!(kind, Kind::AsPrinted | Kind::Reproduced));
    if let Some((name, _)) = recovered.own.first().filter(|_| !gives) {
        return Err(Reason::Undetermined(name.clone()).into());
    }
    Ok(recovered)
}
