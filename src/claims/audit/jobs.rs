//! The parts of papers that are judged independently of each other, on all cores.

use crate::audit::chosen::Chosen;
use crate::claim::Paper;
use crate::diagnostic::{Collected, Diagnostic, Errors};
use crate::digest::{consistency, kernel, offset, premises};
use crate::evaluation::library::Library;
use crate::finding::{
    EquationFinding, FunctionFinding, PaperAudit, RangeFinding, SmoothnessFinding, TableFinding,
    TheoremFinding,
};
use crate::judge::{equation, function, parallel, range, related, smoothness, theorem};
use std::cmp::Reverse;
use std::sync::{Mutex, PoisonError};

/// A part of a paper that one thread judges. Its findings depend neither on the other parts nor on
/// the thread.
enum Part {
    /// The tables at these places, which share schemes.
    Tables(Vec<usize>),
    Formulas,
    /// The claim about smoothness at this place.
    Smoothness(usize),
    Theorems,
}

/// The work of a claim about smoothness, in cells of tables.
const SMOOTHNESS_WORK: usize = 20;

/// The findings of a part, or its errors: of a group of tables or of the theorems only the first
/// error.
enum Found<'a> {
    Tables(Vec<(usize, TableFinding<'a>)>),
    Formulas(Vec<EquationFinding<'a>>, Vec<FunctionFinding<'a>>, Vec<RangeFinding<'a>>),
    Smoothness(usize, Box<SmoothnessFinding<'a>>),
    Theorems(Vec<TheoremFinding<'a>>),
    Errors(Collected),
}

/// Judges the chosen claims of these papers, on all cores; calls `after_claim` after each
/// table and each claim about smoothness.
pub(super) fn judge<'a>(
    papers: &'a [Paper],
    chosen: &dyn Fn(&Paper) -> Chosen,
    after_claim: &(dyn Fn() + Sync),
) -> Result<Vec<PaperAudit<'a>>, Errors> {
    let chosen: Vec<Chosen> = papers.iter().map(chosen).collect();
    let mut jobs: Vec<(usize, Part)> = Vec::new();
    for (at, paper) in papers.iter().enumerate() {
        let has =
            |group: &Vec<usize>| group.iter().any(|&place| chosen[at].has(&paper.tables[place].id));
        let tables = related::related(paper).into_iter().filter(has).map(Part::Tables);
        let smooth = (0..paper.smoothness.len())
            .filter(|&place| chosen[at].has(&paper.smoothness[place].id))
            .map(Part::Smoothness);
        jobs.extend(
            tables.chain(smooth).chain([Part::Theorems, Part::Formulas]).map(|part| (at, part)),
        );
    }
    // The longest first, so that they end together.
    jobs.sort_by_key(|(at, part)| Reverse(part.size(&papers[*at])));
    let found = parallel::map(&jobs, |(at, part)| {
        (*at, part.judge(&papers[*at], &chosen[*at], after_claim))
    });
    let mut parts: Vec<Vec<Found<'a>>> = papers.iter().map(|_| Vec::new()).collect();
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

impl Part {
    /// A rough measure of the work.
    fn size(&self, paper: &Paper) -> usize {
        match self {
            Part::Tables(places) => {
                places.iter().map(|&place| paper.tables[place].cells.iter().flatten().count()).sum()
            }
            Part::Formulas => paper.equations.len(),
            Part::Smoothness(_) => SMOOTHNESS_WORK,
            Part::Theorems => 2 * paper.theorems.len(),
        }
    }

    fn judge<'a>(
        &self,
        paper: &'a Paper,
        chosen: &Chosen,
        after_claim: &(dyn Fn() + Sync),
    ) -> Found<'a> {
        match self {
            Part::Tables(places) => match related::judge_all(paper, places, after_claim) {
                Ok(findings) => Found::Tables(findings),
                Err((_, error)) => Found::error(error),
            },
            Part::Formulas => formulas(paper, chosen),
            Part::Smoothness(place) => {
                let claim = &paper.smoothness[*place];
                let found = smoothness::judge(paper, claim, &Library::new(paper));
                after_claim();
                let found = found.map(|finding| Found::Smoothness(*place, Box::new(finding)));
                found.unwrap_or_else(Found::error)
            }
            Part::Theorems => {
                let theorems = paper.theorems.iter().filter(|theorem| chosen.has(&theorem.id));
                theorem::trials(paper, theorems).map_or_else(Found::error, Found::Theorems)
            }
        }
    }
}

impl Found<'_> {
    fn error(error: Diagnostic) -> Self {
        let mut errors = Collected::default();
        errors.add(error);
        Found::Errors(errors)
    }
}

/// Judges the chosen equations, functions and ranges, each by itself.
fn formulas<'a>(paper: &'a Paper, chosen: &Chosen) -> Found<'a> {
    let library = || Library::new(paper);
    let mut errors = Collected::default();
    let equations = paper.equations.iter().filter(|claim| chosen.has(&claim.id));
    let functions = paper.functions.iter().filter(|claim| chosen.has(&claim.id));
    let ranges = paper.ranges.iter().filter(|claim| chosen.has(&claim.id));
    let equations = errors.all(equations, |claim| equation::judge(paper, claim, &library()));
    let functions = errors.all(functions, |claim| function::judge(paper, claim, &library()));
    let ranges = errors.all(ranges, |claim| range::judge(paper, claim, &library()));
    if errors.is_empty() {
        Found::Formulas(equations, functions, ranges)
    } else {
        Found::Errors(errors)
    }
}

/// Joins the findings of a paper's parts, and computes what follows from all of them. Fails with
/// the errors of the paper, if there are any.
fn together<'a>(paper: &'a Paper, parts: Vec<Found<'a>>) -> Result<PaperAudit<'a>, Errors> {
    let mut audit = PaperAudit {
        paper,
        tables: Vec::new(),
        equations: Vec::new(),
        functions: Vec::new(),
        ranges: Vec::new(),
        smoothness: Vec::new(),
        theorems: Vec::new(),
        contradictions: Vec::new(),
        unstated_offsets: Vec::new(),
    };
    let (mut tables, mut smooth, mut errors) = (Vec::new(), Vec::new(), Collected::default());
    for part in parts {
        match part {
            Found::Tables(findings) => tables.extend(findings),
            Found::Formulas(equations, functions, ranges) => {
                (audit.equations, audit.functions, audit.ranges) = (equations, functions, ranges);
            }
            Found::Smoothness(place, finding) => smooth.push((place, *finding)),
            Found::Theorems(theorems) => audit.theorems = theorems,
            Found::Errors(others) => errors.append(others),
        }
    }
    errors.none()?;
    tables.sort_by_key(|(place, _)| *place);
    audit.tables = tables.into_iter().map(|(_, finding)| finding).collect();
    smooth.sort_by_key(|(place, _)| *place);
    audit.smoothness = smooth.into_iter().map(|(_, finding)| finding).collect();
    related::borrow(paper, &mut audit.tables)?;
    audit.contradictions = consistency::judge(paper, &audit.tables, &Library::new(paper))?;
    audit.unstated_offsets = offset::unstated(paper, &audit.tables)?;
    premises::premises(&mut audit);
    kernel::kernel(&mut audit);
    Ok(audit)
}
