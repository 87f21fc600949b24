//! The rule `theorem`: a theorem is open, or control data refute it, or finitely many levels prove
//! it, or a statement of THEOREMS.md decides it.

pub mod growth;
pub mod instance;
pub mod levels;
pub mod shift;
pub mod sides;

use crate::claims::paper::Paper;
use crate::data::witness::{Points, Witness};
use crate::text::certificate::Block;
use crate::text::reject::{Checked, Reason, require};
use crate::text::toml::Toml;
use instance::Instance;
use sides::Stated;

/// The statements that may be cited.
const THEOREMS: &str = include_str!("../../../THEOREMS.md");

/// A statement of THEOREMS.md that decides a theorem, if some claims hold.
pub struct Citation {
    /// The statement.
    pub statement: String,
    /// The ids of the claims.
    pub uses: Vec<String>,
}

/// Checks a theorem; gives the statement that is cited, if one is.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Option<Citation>> {
    require(block.maybe("open").is_none(), Reason::Open)?;
    for key in ["says", "bounds", "by"] {
        block.may_restate(key, claim.text(key))?;
    }
    let next = block.next_word();
    let (word, text, verdict) = match next {
        "proved-by" => ("proved-by", claim.text("proved_by"), "proved"),
        "refuted-by" => ("refuted-by", claim.text("refuted_by"), "refuted"),
        _ => {
            let instance = Instance::read(paper, claim, block)?;
            if block.next_word() == "grows" {
                return levels::check(paper, claim, block, instance).map(|()| None);
            }
            refuted(paper, claim, block, instance, Points::Indexed)?;
            if block.next_word() == "naturally" {
                block.word("naturally")?;
                let instance = Instance::read(paper, claim, block)?;
                refuted(paper, claim, block, instance, Points::Natural)?;
            }
            if block.next_word() == "in-every-shift" {
                block.word("in-every-shift")?;
                let instance = Instance::read(paper, claim, block)?;
                shift::check(paper, claim, block, instance)?;
            }
            block.word("refuted")?;
            return Ok(None);
        }
    };
    block.restates(word, text)?;
    let number = text.and_then(|text| text.strip_prefix("THEOREMS ")).unwrap_or_default();
    let number = number.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    let heading = format!("**{number}. ");
    require(THEOREMS.lines().any(|line| line.starts_with(&heading)), Reason::NoStatement)?;
    block.word(verdict)?;
    let uses = claim.texts("proof_uses").map(str::to_owned).collect();
    Ok(Some(Citation { statement: format!("THEOREMS.md, {number}"), uses }))
}

/// Checks control data that violate the bound, with the points of a level at these parameters.
fn refuted<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    Instance { scope, setting, .. }: Instance<'a>,
    points: Points,
) -> Checked<()> {
    let stated = Stated::read(claim, block)?;
    let witness = Witness::read(paper, block)?;
    let spreads = witness.spreads(&setting)?;
    let left = witness.value(&setting, stated.quantity, (stated.level, points))?;
    stated.violated((paper, claim), scope, block, &spreads, &left)
}
