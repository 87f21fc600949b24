//! Rule `table`: what the claim says, how it is read, and every cell.

use super::reading::Reads;
use super::{attained, cell, family, promise, sound};
use crate::certificate::Block;
use crate::paper::{Paper, restates};
use crate::reject::{Checked, Reason};
use crate::table::Table;
use crate::toml::Toml;

/// Checks a table.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let table = Table::new(paper, claim);
    let table = table.map_err(|stop| block.head.reject(Reason::Stopped(stop)))?;
    if claim.text("scheme").is_some() {
        let (line, said) = block.take("scheme")?;
        restates(line, "scheme", said, claim.text("scheme"))?;
    }
    let (line, said) = block.take("value")?;
    restates(line, "value", said, claim.text("value"))?;
    let reads = Reads::new(&table, block)?;
    let (rows, columns) = table.size();
    let mut places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let mut refuted = false;
    while let Some((line, said)) = block.optional("cell") {
        let place = places.next().ok_or(line.reject(Reason::Cell))?;
        refuted |= cell::check(&table, &reads, place, line, said)?;
    }
    if places.next().is_some() {
        return Err(block.peek().unwrap_or(block.head).reject(Reason::CellsMissing));
    }
    while let Some((line, said)) = block.optional("attained") {
        attained::check(&table, line, said)?;
    }
    while let Some((line, said)) = block.optional("sound") {
        sound::check(&table, line, said)?;
    }
    promise::check(&table, block)?;
    if refuted { family::check(&table, reads.table.as_ref(), block) } else { Ok(()) }
}
