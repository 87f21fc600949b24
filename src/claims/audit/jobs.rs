//! The parts of papers that are judged independently of each other, on all cores.

use crate::audit::chosen::Chosen;
use crate::claim::{Claim, Paper};
use crate::diagnostic::{Collected, Diagnostic, Errors};
use crate::digest::{consistency, kernel, offset, premises};
use crate::evaluation::library::Library;
use crate::finding::PaperAudit;
use crate::judge::{equation, function, parallel, range, related, smoothness, theorem};
use std::cmp::Reverse;
use std::sync::{Mutex, PoisonError};

/// A part of a paper that one thread judges. Its findings depend neither on the other parts nor on
/// the thread.
enum Part<'a> {
    /// The tables at these places, which share schemes.
    Tables(Vec<usize>),
    /// A claim that is judged by itself.
    Alone(Claim<'a>),
    Theorems,
}

/// The work of a claim about smoothness, in cells of tables.
const SMOOTHNESS_WORK: usize = 20;

/// Judges the chosen claims of these papers, on all cores; calls `after_claim` after each
/// table and each claim about smoothness.
pub(super) fn judge<'a>(
    papers: &'a [Paper],
    chosen: &dyn Fn(&Paper) -> Chosen,
    after_claim: &(dyn Fn() + Sync),
) -> Result<Vec<PaperAudit<'a>>, Errors> {
    let chosen: Vec<Chosen> = papers.iter().map(chosen).collect();
    let mut jobs: Vec<(usize, Part<'a>)> = Vec::new();
    for (at, paper) in papers.iter().enumerate() {
        let has =
            |group: &Vec<usize>| group.iter().any(|&place| chosen[at].has(&paper.tables[place].id));
        let tables = related::related(paper).into_iter().filter(has).map(Part::Tables);
        let alone = paper.claims().filter(|claim| {
            !matches!(claim, Claim::Table(_) | Claim::Theorem(_)) && chosen[at].has(claim.id())
        });
        let parts = tables.chain(alone.map(Part::Alone)).chain([Part::Theorems]);
        jobs.extend(parts.map(|part| (at, part)));
    }
    // The longest first, so that they end together.
    jobs.sort_by_key(|(at, part)| Reverse(part.size(&papers[*at])));
    let found = parallel::map(&jobs, |(at, part)| {
        (*at, part.judge(&papers[*at], &chosen[*at], after_claim))
    });
    let mut parts: Vec<Vec<Judged<'a>>> = papers.iter().map(|_| Vec::new()).collect();
    for (at, found) in found {
        parts[at].push(found);
    }
    let parts: Vec<_> = papers.iter().zip(parts.into_iter().map(Mutex::new)).collect();
    let audits = parallel::map(&parts, |(paper, parts)| {
        let parts = std::mem::take(&mut *parts.lock().unwrap_or_else(PoisonError::into_inner));
        together(paper, parts)
    });
    audits.into_iter().collect()
}

/// The findings of a part, or its error: of a group of tables or of the theorems the first one.
type Judged<'a> = Result<PaperAudit<'a>, Diagnostic>;

impl<'a> Part<'a> {
    /// A rough measure of the work.
    fn size(&self, paper: &Paper) -> usize {
        match self {
            Part::Tables(places) => {
                places.iter().map(|&place| paper.tables[place].cells.iter().flatten().count()).sum()
            }
            Part::Alone(Claim::Smoothness(_)) => SMOOTHNESS_WORK,
            Part::Alone(_) => 1,
            Part::Theorems => 2 * paper.theorems.len(),
        }
    }

    fn judge(
        &self,
        paper: &'a Paper,
        chosen: &Chosen,
        after_claim: &(dyn Fn() + Sync),
    ) -> Judged<'a> {
        let (mut audit, library) = (PaperAudit::new(paper), || Library::new(paper));
        match self {
            Part::Tables(places) => {
                audit.tables = related::judge_all(paper, places, after_claim)?;
            }
            Part::Alone(Claim::Equation(claim)) => {
                audit.equations.push(equation::judge(paper, claim, &library())?);
            }
            Part::Alone(Claim::Function(claim)) => {
                audit.functions.push(function::judge(paper, claim, &library())?);
            }
            Part::Alone(Claim::Range(claim)) => {
                audit.ranges.push(range::judge(paper, claim, &library())?);
            }
            Part::Alone(Claim::Smoothness(claim)) => {
                let found = smoothness::judge(paper, claim, &library());
                after_claim();
                audit.smoothness.push(found?);
            }
            Part::Theorems | Part::Alone(Claim::Table(_) | Claim::Theorem(_)) => {
                let theorems = paper.theorems.iter().filter(|theorem| chosen.has(&theorem.id));
                audit.theorems = theorem::trials(paper, theorems)?;
            }
        }
        Ok(audit)
    }
}

/// Joins the findings of a paper's parts, and computes what follows from all of them. Fails with
/// the errors of the paper, if there are any.
fn together<'a>(paper: &'a Paper, parts: Vec<Judged<'a>>) -> Result<PaperAudit<'a>, Errors> {
    let (mut audit, mut errors) = (PaperAudit::new(paper), Collected::default());
    for part in parts {
        if let Some(part) = errors.take(part) {
            audit.append(part);
        }
    }
    errors.none()?;
    audit.sort();
    related::borrow(paper, &mut audit.tables)?;
    audit.contradictions = consistency::judge(paper, &audit.tables, &Library::new(paper))?;
    audit.unstated_offsets = offset::unstated(paper, &audit.tables)?;
    premises::premises(&mut audit);
    kernel::kernel(&mut audit);
    Ok(audit)
}
