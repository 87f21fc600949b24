//! One file for each rule of FORMAT.md.

mod attained;
mod cell;
mod constant;
mod equation;
mod family;
mod function;
mod growth;
mod hypotheses;
mod levels;
mod members;
mod pieces;
mod promise;
mod range;
mod reading;
mod scale;
mod sound;
mod table;
mod theorem;

use crate::certificate::Block;
use crate::paper::Paper;
use crate::reject::{Checked, Reason};
use crate::shape::misfit;
use crate::table::{Place, Table};
use crate::toml::Toml;

/// What a valid certificate proves of a claim.
pub enum Verdict {
    /// An identity, a closed form or a range holds.
    Holds,
    /// Something else that needs no other claim.
    Other,
    /// A theorem is proved or refuted by a statement of THEOREMS.md, if these claims hold.
    Cited {
        /// The statement.
        statement: String,
        /// The ids of the claims.
        uses: Vec<String>,
    },
}

/// Checks a block that is about a claim.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    mut block: Block<'_>,
) -> Checked<Verdict> {
    paper.library.restart();
    judge(paper, kind, claim, &mut block).map_err(|rejection| rejection.at(block.at))
}

fn judge<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Verdict> {
    // What else the claim file says could change what the claim means.
    if let Some(path) = misfit(claim, kind) {
        return Err(Reason::Field(path).into());
    }
    while let Some(said) = block.maybe("constant") {
        constant::check(paper, said, block)?;
    }
    let mut verdict = Verdict::Other;
    match kind {
        "table" => table::check(paper, claim, block)?,
        "equation" => equation::check(paper, claim, block)?,
        "function" => function::check(paper, claim, block)?,
        "range" => range::check(paper, claim, block)?,
        "theorem" => verdict = theorem::check(paper, claim, block)?,
        _ => return Err(Reason::NoSuchClaim.into()),
    }
    block.finished()?;
    let holds = ["holds", "exact"].contains(&block.last().word().0);
    Ok(if holds { Verdict::Holds } else { verdict })
}

/// The place of a cell that a line begins with, and what follows.
fn place<'l>(table: &Table<'_>, said: &'l str) -> Checked<(Place, &'l str)> {
    let mut words = said.splitn(3, ' ');
    let mut next = |count: usize| {
        let place: usize = words.next()?.parse().ok()?;
        place.checked_sub(1).filter(|place| *place < count)
    };
    let (rows, columns) = table.size();
    let place = next(rows).and_then(|row| Some((row, next(columns)?)));
    Ok((place.ok_or(Reason::Cell)?, words.next().unwrap_or_default()))
}
