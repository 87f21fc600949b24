//! The blocks of certificates, each with the claim that it is about.

use crate::text::{About, At, Block, Checked, Reason, Rejection, Toml, blocks, require};
use std::collections::BTreeMap;

/// A claim and its block of a certificate.
pub struct Task<'t> {
    /// The index of the certificate.
    pub place: usize,
    /// The kind of the claim.
    pub kind: &'t str,
    /// Its id.
    pub id: &'t str,
    /// The claim.
    pub claim: &'t Toml,
    /// The block.
    pub block: Block<'t>,
    /// Whether other blocks are about the same claim. Of several none counts, neither for this claim nor for others.
    twice: bool,
}

impl<'t> Task<'t> {
    /// The block, if it is the only one about its claim.
    pub fn once(&self) -> Checked<Block<'t>> {
        let once = require(!self.twice, Reason::Twice).at(self.block.head.number);
        once.map(|()| self.block.clone())
    }
}

/// The blocks of certificates about claims of these kinds, and the rejections of whole certificates.
pub fn tasks<'t>(
    file: &'t Toml,
    about: About<'_>,
    kinds: &[&str],
    certificates: &[&'t str],
) -> (Vec<Task<'t>>, Vec<(usize, Rejection)>) {
    let (mut tasks, mut broken, mut counts) = (Vec::new(), Vec::new(), BTreeMap::new());
    for (place, text) in certificates.iter().enumerate() {
        let blocks = blocks(text, about).unwrap_or_else(|rejection| {
            broken.push((place, rejection));
            Vec::new()
        });
        for block in blocks {
            let (kind, id) = block.head.word();
            let claim = file.list(kind).iter().find(|claim| claim.text("id") == Some(id));
            let Some(claim) = claim.filter(|_| kinds.contains(&kind)) else {
                broken.push((place, block.head.reject(Reason::NoSuchClaim)));
                continue;
            };
            *counts.entry((kind, id)).or_insert(0) += 1;
            tasks.push(Task { place, kind, id, claim, block, twice: false });
        }
    }
    for task in &mut tasks {
        task.twice = counts[&(task.kind, task.id)] > 1;
    }
    (tasks, broken)
}
