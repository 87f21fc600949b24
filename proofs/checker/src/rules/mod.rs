//! The rules of FORMAT.md. Each has a file.

mod attained;
mod cell;
mod constant;
mod copied;
mod degree;
mod equation;
mod family;
mod function;
mod growth;
mod hypotheses;
mod instance;
mod levels;
mod limits;
mod listed;
mod luck;
mod members;
mod pieces;
mod promise;
mod range;
mod reading;
mod recovered;
mod scale;
mod shift;
mod sides;
mod smooth_range;
mod smoothness;
mod sound;
mod table;
mod theorem;

use crate::certificate::Block;
use crate::paper::Paper;
use crate::reject::{At, Checked, Reason};
use crate::shape::misfit;
use crate::toml::Toml;
pub use instance::{Instance, first_level};
pub use recovered::{Given, Recovered};
pub use sides::Stated;
pub use sound::{Promised, level as promised_level};
use theorem::Citation;

/// The verdict that a valid certificate proves.
pub enum Verdict {
    /// An identity, a closed form, a range or a claim about smoothness holds.
    Holds,
    /// Another verdict that needs no other claim.
    Other,
    /// A theorem is proved or refuted by a statement of THEOREMS.md.
    Cited(Citation),
    /// A table rests on recovered values, or gives them to others.
    Recovers(Recovered),
}

/// Checks a block that is about a claim.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    mut block: Block<'_>,
) -> Checked<Verdict> {
    paper.library.restart();
    judge(paper, kind, claim, &mut block).at(block.at)
}

fn judge<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Verdict> {
    // An unknown field could change the meaning of the claim.
    if let Some(path) = misfit(claim, kind) {
        return Err(Reason::Field(path).into());
    }
    while let Some(said) = block.maybe("constant") {
        constant::check(paper, said, block)?;
    }
    let (mut cited, mut recovered) = (None, None);
    match kind {
        "table" => recovered = Some(table::check(paper, claim, block)?),
        "equation" => equation::check(paper, claim, block)?,
        "function" => function::check(paper, claim, block)?,
        "range" if claim.get("smoothness").is_some() => smooth_range::check(paper, claim, block)?,
        "range" => range::check(paper, claim, block)?,
        "smoothness" => cited = smoothness::check(paper, claim, block)?,
        "exponent" => smoothness::exponent(paper, claim, block)?,
        "theorem" => cited = theorem::check(paper, claim, block)?,
        _ => return Err(Reason::NoSuchClaim.into()),
    }
    block.finished()?;
    let holds = ["holds", "exact", "confirmed"].contains(&block.last().word().0);
    let table = recovered.map(Verdict::Recovers);
    let other = cited.map(Verdict::Cited).or(table).unwrap_or(Verdict::Other);
    let holds = holds && !matches!(other, Verdict::Cited(_));
    Ok(if holds { Verdict::Holds } else { other })
}
