//! The rule `table`: the readings and cells of a table, and what follows them.

use super::reading::Reads;
use super::{attained, cell, family, promise, sound};
use crate::certificate::Block;
use crate::paper::Paper;
use crate::reject::{Checked, Reason, require};
use crate::table::{Read, Table};
use crate::toml::Toml;

/// Checks a table.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let table = Table::new(paper, claim)?;
    if claim.text("scheme").is_some() {
        block.restates("scheme", claim.text("scheme"))?;
    }
    block.restates("value", claim.text("value"))?;
    let reads = Reads::new(&table, block)?;
    let (mut places, mut refuted) = (table.places(), Vec::new());
    while let Some(said) = block.maybe("cell") {
        let place = places.next().ok_or(Reason::Cell)?;
        if cell::check(&table, &reads, place, said)? {
            refuted.push(place);
        }
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
    family::check(&table, &reads, &refuted, block)
}
