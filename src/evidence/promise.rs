//! What certificates say of promises: why a printed number keeps its promise, or does not.

use crate::bound::{Budget, Constants};
use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::At;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evidence::table::{integer, number};
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Broken, CellFinding, Kept, Later, TableFinding};
use crate::judge::distance::{Compared, KnownDistances, has_words};
use crate::judge::later::{change, later};
use crate::scheme::Mask;
use std::collections::BTreeSet;

/// The deepest level that a certificate speaks of.
const MAX_LEVEL: u32 = 10_000;

/// The deepest level of a ring for which flows are computed.
const MAX_LOCAL_LEVEL: u32 = 1_000;

/// The most levels by which a bound is taken later than at the level that is promised.
const MAX_LATER: u32 = 8;

/// What shows whether a printed number keeps its promise.
#[derive(Clone, Debug, PartialEq)]
pub enum PromiseEvidence<'f> {
    /// It does: the sound bound at a level, and how far that level is from the one that
    /// is promised, are together small enough.
    Kept(Later),
    /// It does on a ring: the weights of its limit, and for every point a flow along the edges
    /// that carries its error and costs little enough.
    KeptByFlows(Vec<RealCyclotomic>, Vec<Vec<RealCyclotomic>>),
    /// It does not for these data; of a ring, with the weights of its limit.
    Broken(&'f Broken, Vec<RealCyclotomic>),
    /// It does not for these data, nor with the points at their natural parameters for those.
    BrokenNaturally(&'f Broken, &'f Broken),
    /// Neither is shown.
    Undecided,
}

/// The evidence for the promises of a table: `None` for cells of which there is none.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn promise_evidence<'f>(
    paper: &Paper,
    finding: &'f TableFinding<'_>,
) -> Result<Vec<Vec<Option<PromiseEvidence<'f>>>>, Diagnostic> {
    let library = Library::new(paper);
    let judge = Evaluator::new(paper, finding.table, &library, &finding.values())?;
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let mut rows = Vec::new();
    for (row, cells) in finding.cells.iter().enumerate() {
        let mut evidence = Vec::new();
        for (column, cell) in cells.iter().enumerate() {
            let at = At { row, column, assume: &assume, settings: &Settings::default() };
            let promise = finding.table.promise.as_ref().filter(|_| cell.printed.is_some());
            let of = promise.map(|promise| of_cell(&judge, promise, cell, at));
            evidence.push(of.transpose()?);
        }
        rows.push(evidence);
    }
    Ok(rows)
}

fn of_cell<'f>(
    judge: &Evaluator<'_>,
    promise: &Promise,
    cell: &'f CellFinding,
    at: At<'_>,
) -> Result<PromiseEvidence<'f>, Diagnostic> {
    let (Promise::Depth { ring, .. } | Promise::Bound { ring, .. }) = promise;
    let ring = ring.as_ref().map(|ring| judge.ring(ring, at)).transpose()?;
    let ring = ring
        .and_then(Result::ok)
        .map(|(_, ring)| KnownDistances::new(Compared::LocalRules(ring), &Budget::unlimited()));
    let ring = ring.as_ref().and_then(|ring| ring.of_ring().ok());
    let weights = ring.map(|ring| ring.limit().weights().to_vec());
    match &cell.kept {
        Some(Kept::Yes) => {
            let kept = match ring.zip(weights) {
                Some((ring, weights)) => {
                    let level = terms(judge, promise, at)?.map(|(level, _)| level);
                    let level = level.filter(|level| *level <= MAX_LOCAL_LEVEL);
                    // A depth is promised for later levels too: averages are no farther away.
                    let lasts = matches!(promise, Promise::Bound { .. }) || ring.averages();
                    let level = level.filter(|_| lasts);
                    let flows = level.and_then(|level| ring.flows(level).ok());
                    flows.map(|flows| PromiseEvidence::KeptByFlows(weights, flows))
                }
                None => kept(judge, promise, at)?,
            };
            Ok(kept.unwrap_or(PromiseEvidence::Undecided))
        }
        Some(Kept::No(broken)) => match &cell.kept_naturally {
            Some(Kept::No(natural)) if certifiable(judge, natural, at)? => {
                Ok(PromiseEvidence::BrokenNaturally(broken, natural))
            }
            _ => Ok(PromiseEvidence::Broken(broken, weights.unwrap_or_default())),
        },
        Some(Kept::Open(_)) | None => Ok(PromiseEvidence::Undecided),
    }
}

/// Whether certificates have words for data that are too far with the points at their natural
/// parameters: the masks take lines to lines, and the place is i/n^m.
fn certifiable(judge: &Evaluator<'_>, broken: &Broken, at: At<'_>) -> Result<bool, Diagnostic> {
    let Ok(quantities) = judge.quantities(at)? else { return Ok(false) };
    let Some(scheme) = quantities.scheme else { return Ok(false) };
    let masks: Vec<&Mask> = scheme.constants.iter().map(|axis| axis.mask()).collect();
    Ok(has_words(&masks, &broken.attained))
}

/// The first level whose sound bound shows that a promise is kept.
fn kept<'f>(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: At<'_>,
) -> Result<Option<PromiseEvidence<'f>>, Diagnostic> {
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) = promise;
    let offset = offset.as_ref().map(|offset| integer(judge, offset, at)).transpose()?.flatten();
    let spread = number(judge, spread, at)?.filter(|spread| spread.sign() >= 0);
    let Some(spread) = spread else { return Ok(None) };
    let terms = terms(judge, promise, at)?.filter(|(level, _)| *level <= MAX_LEVEL);
    let Some((level, most)) = terms else { return Ok(None) };
    let Ok(bound) = judge.library.sound_bound(&scheme, offset) else { return Ok(None) };
    let axes: Vec<&Constants> = scheme.constants.iter().map(|axis| &**axis).collect();
    // A depth is promised for all later levels too.
    let last = |later| if matches!(promise, Promise::Depth { .. }) { later } else { level };
    let change = |later| {
        let changes = (level..=last(later)).map(|level| change(&axes, offset, level, later));
        changes.collect::<Option<Vec<Rational>>>()?.into_iter().max()
    };
    let later = later(&bound, level, MAX_LATER, change, |sum| sum * &spread <= most);
    Ok(later.map(PromiseEvidence::Kept))
}

/// The level that a cell speaks of, and what the distance there is promised to be at most.
pub(super) fn terms(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: At<'_>,
) -> Result<Option<(u32, Rational)>, Diagnostic> {
    let Some(printed) = judge.printed(at) else { return Ok(None) };
    let (level, most) = match promise {
        Promise::Depth { tolerance, .. } => {
            (printed.numerator().to_i64(), number(judge, tolerance, at)?)
        }
        Promise::Bound { level, .. } => (integer(judge, level, at)?, Some(printed)),
    };
    Ok(level.and_then(|level| u32::try_from(level).ok()).zip(most))
}
