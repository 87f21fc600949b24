//! The rule `theorem`: a theorem is open, or control data refute it, or finitely many levels prove
//! it, or a statement of THEOREMS.md decides it.

pub mod growth;
pub mod instance;
pub mod levels;
pub mod shift;
pub mod sides;

use super::kind::{Citation, Kind, Proof};
use crate::claims::{OF_THEOREMS, Paper};
use crate::data::{Points, Witness};
use crate::text::{Block, Checked, Reason, Toml, Verdict, require};
use instance::{Instance, points};
use sides::Stated;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "theorem",
    fields: "theorem: claim bounds=text by=text from=text says=text rests=*text schemes=*text values=%*text \
 offset=text interpolant=text parameters=text supposes=supposes block=text corrections=*correction \
 proved_by=text refuted_by=text proof_uses=*text
supposes: value=text below=text
correction: of=text says=text value=text",
    names,
    check,
};

/// The statements that may be cited.
const THEOREMS: &str = include_str!("../../../THEOREMS.md");

/// Checks a theorem; gives the statement that is cited, if one is.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Proof> {
    require(block.maybe("open").is_none(), Reason::Open)?;
    for key in ["says", "bounds", "by"] {
        block.may_restate(key, claim.text(key))?;
    }
    let next = block.next_word();
    let (word, text, verdict) = match next {
        "proved-by" => ("proved-by", claim.text("proved_by"), Verdict::Proved),
        "refuted-by" => ("refuted-by", claim.text("refuted_by"), Verdict::Refuted),
        _ => {
            let instance = Instance::read(paper, claim, block)?;
            if block.next_word() == "grows" {
                return levels::check(paper, claim, block, instance).map(|()| Proof::Other);
            }
            let points = points(claim)?;
            refuted(paper, claim, block, instance, points)?;
            if points == Points::Indexed && block.next_word() == "naturally" {
                block.word("naturally")?;
                let instance = Instance::read(paper, claim, block)?;
                refuted(paper, claim, block, instance, Points::Natural)?;
            }
            if block.next_word() == "in-every-shift" {
                block.word("in-every-shift")?;
                let instance = Instance::read(paper, claim, block)?;
                shift::check(paper, claim, block, instance)?;
            }
            block.word(Verdict::Refuted.name())?;
            return Ok(Proof::Other);
        }
    };
    block.restates(word, text)?;
    let number = text.and_then(|text| text.strip_prefix("THEOREMS ")).unwrap_or_default();
    let number = number.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    let heading = format!("**{number}. ");
    require(THEOREMS.lines().any(|line| line.starts_with(&heading)), Reason::NoStatement)?;
    block.word(verdict.name())?;
    let uses = claim.texts("proof_uses").map(str::to_owned).collect();
    Ok(Proof::Cited(Citation { statement: format!("THEOREMS.md, {number}"), uses }))
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

/// The parameters of a theorem, and the names that its kind of bound defines.
fn names(claim: &Toml) -> Vec<&str> {
    let of_theorems = OF_THEOREMS.into_iter().filter(|_| claim.get("by").is_some());
    claim.names("values").chain(of_theorems).collect()
}
