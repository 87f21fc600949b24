//! The parts of papers that are judged independently of each other, on all cores.

use crate::audit::chosen::Chosen;
use crate::claim::{self, Paper, with_kinds};
use crate::cores;
use crate::diagnostic::{Collected, Diagnostic, Errors};
use crate::digest::{consistency, kernel, offset, premises};
use crate::evaluation::library::Library;
use crate::finding::PaperAudit;
use crate::judge::kind::Judge as _;
use crate::judge::related;
use std::cmp::Reverse;
use std::sync::{Mutex, PoisonError};

macro_rules! parts {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $claim:ident $f:ident $c:ident,)*) => {
        /// Claims of a paper that one thread judges. Their findings depend neither on the other parts nor on the
        /// thread.
        enum Part<'a> { $($(#[$doc])* $kind(Vec<&'a claim::$claim>),)* }

        impl<'a> Part<'a> {
            /// The parts of the chosen claims.
            fn all(paper: &'a Paper, chosen: &Chosen) -> Vec<Part<'a>> {
                let mut parts = Vec::new();
                $(for mut group in claim::$claim::groups(&paper.$field) {
                    group.retain(|claim| chosen.has(&claim.id));
                    if !group.is_empty() {
                        parts.push(Part::$kind(group));
                    }
                })*
                parts
            }

            /// A rough measure of the work.
            fn work(&self) -> usize {
                match self { $(Part::$kind(group) => group.iter().map(|claim| claim.work()).sum(),)* }
            }

            fn judge(&self, paper: &'a Paper, after_claim: &(dyn Fn() + Sync)) -> Judged<'a> {
                let mut audit = PaperAudit::new(paper);
                match self {
                    $(Part::$kind(group) => audit.$field = claim::$claim::judge(paper, group, after_claim)?,)*
                }
                Ok(audit)
            }
        }
    };
}

with_kinds!(parts);

/// Judges the chosen claims of these papers, on all cores; calls `after_claim` after each. Claims with errors are left out.
pub(super) fn judge<'a>(
    papers: &'a [Paper],
    chosen: &dyn Fn(&Paper) -> Chosen,
    after_claim: &(dyn Fn() + Sync),
) -> Vec<(PaperAudit<'a>, Result<(), Errors>)> {
    let chosen: Vec<Chosen> = papers.iter().map(chosen).collect();
    let mut jobs: Vec<(usize, Part<'a>)> = Vec::new();
    for (at, paper) in papers.iter().enumerate() {
        jobs.extend(Part::all(paper, &chosen[at]).into_iter().map(|part| (at, part)));
    }
    // The longest first, so that they end together.
    jobs.sort_by_key(|(_, part)| Reverse(part.work()));
    let found = cores::map(&jobs, |(at, part)| (*at, part.judge(&papers[*at], after_claim)));
    let mut parts: Vec<Vec<Judged<'a>>> = papers.iter().map(|_| Vec::new()).collect();
    for (at, found) in found {
        parts[at].push(found);
    }
    let parts: Vec<_> = papers.iter().zip(parts.into_iter().map(Mutex::new)).collect();
    cores::map(&parts, |(paper, parts)| {
        let parts = std::mem::take(&mut *parts.lock().unwrap_or_else(PoisonError::into_inner));
        together(paper, parts)
    })
}

/// The findings of a part, or its error: of a group of tables or of the theorems the first one.
type Judged<'a> = Result<PaperAudit<'a>, Diagnostic>;

/// Joins the findings of a paper's parts, and computes what follows from all of them. The errors are those of the other
/// parts.
fn together<'a>(paper: &'a Paper, parts: Vec<Judged<'a>>) -> (PaperAudit<'a>, Result<(), Errors>) {
    let (mut audit, mut errors) = (PaperAudit::new(paper), Collected::default());
    for part in parts {
        if let Some(part) = errors.take(part) {
            audit.append(part);
        }
    }
    audit.sort();
    errors.take(related::borrow(paper, &mut audit.tables));
    let found = consistency::judge(paper, &audit.tables, &Library::new(paper));
    audit.contradictions = errors.take(found).unwrap_or_default();
    audit.unstated_offsets =
        errors.take(offset::unstated(paper, &audit.tables)).unwrap_or_default();
    premises::premises(&mut audit);
    kernel::kernel(&mut audit);
    (audit, errors.none())
}
