//! The rules of `proofs/format`: one place for each kind of claim, and one list of kinds.

pub mod equation;
pub mod exponent;
pub mod function;
pub mod kind;
pub mod range;
pub mod regularity;
pub mod relation;
pub mod smoothness;
pub mod table;
pub mod theorem;

use crate::claims::{Paper, misfit};
use crate::lines::{constant, curve};
use crate::text::{At, Block, Checked, Reason, Toml};
use kind::{Kind, Proof};

/// The kinds of claims.
pub static KINDS: [Kind; 8] = [
    table::KIND,
    equation::KIND,
    relation::KIND,
    function::KIND,
    range::KIND,
    smoothness::KIND,
    exponent::KIND,
    theorem::KIND,
];

/// The claims of a file, each with its kind.
pub fn claims(file: &Toml) -> impl Iterator<Item = (&'static Kind, &Toml)> {
    KINDS.iter().flat_map(|kind| file.list(kind.name).iter().map(move |claim| (kind, claim)))
}

/// The kind of this name.
fn named(name: &str) -> Checked<&'static Kind> {
    Ok(KINDS.iter().find(|kind| kind.name == name).ok_or(Reason::NoSuchClaim)?)
}

/// Checks the fields of a claim. An unknown field could change the meaning of the claim.
pub fn fit(claim: &Toml, kind: &str) -> Checked<()> {
    match misfit(claim, kind, named(kind)?.fields) {
        Some(path) => Err(Reason::Field(path).into()),
        None => Ok(()),
    }
}

/// Checks a block that is about a claim.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    mut block: Block<'_>,
) -> Checked<Proof> {
    paper.library.restart();
    judge(paper, kind, claim, &mut block).at(block.at)
}

fn judge<'a>(
    paper: &'a Paper<'a>,
    kind: &str,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Proof> {
    fit(claim, kind)?;
    while let Some(said) = block.maybe("constant") {
        constant::check(paper, said, block)?;
    }
    if kind == relation::KIND.name {
        while let Some(said) = block.maybe("limits") {
            curve::check(paper, said, block)?;
        }
    }
    let proof = (named(kind)?.check)(paper, claim, block)?;
    block.finished()?;
    Ok(proof)
}
