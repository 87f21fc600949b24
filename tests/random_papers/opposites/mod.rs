//! No two certificates of opposite verdicts are both accepted.
//!
//! The program's own block stands against those that a second, unscrupulous writer makes up.

mod flipped;
mod promise;
mod theorem;

use crate::random_papers::draft::{Claim, Draft, Known};
use crate::random_papers::failure::{Checked, Failure};
use crate::random_papers::program::{Block, accepts, blocks, written};

/// A verdict and its opposite, each with the blocks that may show it.
struct Sides {
    one: Vec<Block>,
    other: Vec<Block>,
}

pub fn excluded(draft: &Draft) -> Checked {
    for claim in &draft.claims {
        let text = draft.with([claim]);
        let Some(certificate) = written(&text) else { continue };
        let Some(own) = blocks(&certificate).pop() else { continue };
        let mut sides = Vec::new();
        if let Known::Bound(bound) = &claim.known {
            sides.push(theorem::sides(draft, claim, bound, &own));
        } else if accepts(&text, &own) {
            let against = flipped::against(&own).into_iter();
            let against = against.chain(promise::against(draft, claim, &own));
            sides.push(Sides { one: vec![own], other: against.collect() });
        }
        for Sides { one, other } in sides {
            both(claim, &text, &one, &other)?;
        }
    }
    Ok(())
}

fn both(claim: &Claim, text: &str, one: &[Block], other: &[Block]) -> Checked {
    let Some(one) = one.iter().find(|block| accepts(text, block)) else { return Ok(()) };
    let Some(other) = other.iter().find(|block| accepts(text, block)) else { return Ok(()) };
    let what = format!("a {} is certified with opposite verdicts", claim.kind);
    Err(Failure::new(what, text, format!("{}\n{}", one.text, other.text)))
}
