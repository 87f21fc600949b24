//! Theorems of Coq: whether they are about the masks, numbers and places of a claim file. Whether they are
//! true, Coq checks (proofs/format/coq.md).

mod cell;
mod read;
mod stated;
mod statement;
mod theorem;

pub use cell::Given;

use crate::claims::Paper;
use crate::kinds;
use crate::numbers::Q;
use crate::text::{At, Checked, Reason, Rejection, compare};
use statement::Theorem;

/// A file of theorems that agrees with the claim file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Agreement {
    /// `table` or `theorem`.
    pub kind: String,
    /// The id of the claim.
    pub id: String,
    /// The number of theorems.
    pub theorems: usize,
    /// The values of parameters that certificates recover and that the theorems use.
    pub recovered: Vec<(String, Q)>,
}

/// Compares a file of theorems with the claim file.
pub fn agree<'a>(
    paper: &'a Paper<'a>,
    key: &str,
    recovered: &[Given],
    text: &str,
) -> Checked<Agreement> {
    paper.library.restart();
    let file = read::read(text)?;
    let agreement = || -> Checked<Agreement> {
        compare(file.key == key, &file.key, key, Reason::Stated)?;
        let mut claims = paper.file.list(&file.kind).iter();
        let claim = claims.find(|claim| claim.text("id") == Some(&file.id));
        let claim = claim.ok_or(Reason::NoSuchClaim)?;
        kinds::fit(claim, &file.kind)?;
        once(&file.statements)?;
        let recovered = match &file.kind[..] {
            "table" => cell::agree(paper, claim, recovered, &file)?,
            _ => theorem::agree(paper, claim, &file).map(|()| Vec::new())?,
        };
        Ok(Agreement {
            kind: file.kind.clone(),
            id: file.id.clone(),
            theorems: file.statements.len(),
            recovered,
        })
    };
    // What is wrong with all theorems stands in the first lines.
    agreement().at(1)
}

/// Checks that no two theorems say the same of the same place, whatever their second comments call it: they are one
/// finding, and so are sufficient depths of one cell, whatever their levels. The names of theorems are their numbers, in order.
fn once(theorems: &[Theorem]) -> Checked<()> {
    for (number, theorem) in theorems.iter().enumerate() {
        let same = |earlier: &&Theorem| {
            (&earlier.place, &earlier.statement) == (&theorem.place, &theorem.statement)
                && (theorem.statement == "sufficient_depth"
                    || earlier.arguments == theorem.arguments)
        };
        if let Some(earlier) = theorems[..number].iter().find(same) {
            return Err(Rejection {
                line: theorem.line,
                reason: Reason::TwiceStated(earlier.line),
            });
        }
    }
    Ok(())
}
