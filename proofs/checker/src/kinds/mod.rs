//! The rules of FORMAT.md: one place for each kind of claim.

pub mod equation;
pub mod function;
pub mod range;
pub mod regularity;
pub mod smoothness;
pub mod table;
pub mod theorem;

use crate::claims::paper::Paper;
use crate::claims::shape::misfit;
use crate::lines::constant;
use crate::text::certificate::Block;
use crate::text::reject::{At, Checked, Reason};
use crate::text::toml::Toml;
use range::smooth;
use table::recovered::Recovered;
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
        "range" if claim.get("smoothness").is_some() => smooth::check(paper, claim, block)?,
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
