//! The evidence of certificates about promises: why a printed number keeps its promise, or breaks
//! it.

use crate::bound::Budget;
use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::CellReading;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evidence::table::{integer, number};
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Broken, CellFinding, Kept, Later, TableFinding};
use crate::judge::distance::{KnownDistances, has_words};
use crate::judge::later::{change, later};
use crate::scheme::Mask;
use std::collections::BTreeSet;

/// The highest level for which a certificate shows a promise.
const MAX_LEVEL: u32 = 10_000;

/// The highest level of a ring for which flows are computed.
const MAX_LOCAL_LEVEL: u32 = 1_000;

/// The most levels between the level of a promise and the level of the sound bound that shows it.
const MAX_LATER: u32 = 8;

/// The evidence that a printed number keeps its promise, or breaks it.
#[derive(Clone, Debug, PartialEq)]
pub enum PromiseEvidence<'f> {
    /// The promise is kept: at a later level, the sound bound and the distance of the two levels
    /// from each other are together small enough.
    Kept(Later),
    /// The promise is kept on a ring: the weights of the limit, and for every point a flow along
    /// the edges that carries the point's error and whose cost is small enough.
    KeptByFlows(Vec<RealCyclotomic>, Vec<Vec<RealCyclotomic>>),
    /// These data break the promise; of a ring, with the weights of its limit.
    Broken(&'f Broken, Vec<RealCyclotomic>),
    /// The first data break the promise; the second do with the points at their natural parameters.
    BrokenNaturally(&'f Broken, &'f Broken),
    /// Neither of these is shown.
    Undecided,
}

/// The evidence for the promises of a table, cell by cell; `None` where a cell makes no promise.
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
            let at = CellReading { row, column, assume: &assume, settings: &Settings::default() };
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
    at: CellReading<'_>,
) -> Result<PromiseEvidence<'f>, Diagnostic> {
    let (Promise::Depth { ring, .. } | Promise::Bound { ring, .. }) = promise;
    let ring = ring.as_ref().map(|ring| judge.ring(ring, at)).transpose()?;
    let ring =
        ring.and_then(Result::ok).map(|(_, ring)| KnownDistances::new(ring, &Budget::unlimited()));
    let ring = ring.as_ref().and_then(|ring| ring.of_ring().ok());
    let weights = ring.map(|ring| ring.limit().weights().to_vec());
    match &cell.kept {
        Some(Kept::Yes) => {
            let kept = match ring.zip(weights) {
                Some((ring, weights)) => {
                    let level = terms(judge, promise, at)?.map(|(level, _)| level);
                    let level = level.filter(|level| *level <= MAX_LOCAL_LEVEL);
                    // A depth is also promised for later levels. With nonnegative weights these are
                    // no farther away.
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

/// Whether the format of certificates can express data that break a promise with the points at
/// their natural parameters: the masks map lines to lines, and the place is i/n^m.
fn certifiable(
    judge: &Evaluator<'_>,
    broken: &Broken,
    at: CellReading<'_>,
) -> Result<bool, Diagnostic> {
    let Ok(quantities) = judge.quantities(at)? else { return Ok(false) };
    let Some(scheme) = quantities.scheme else { return Ok(false) };
    let masks: Vec<&Mask> = scheme.constants.iter().map(|axis| axis.mask()).collect();
    Ok(has_words(&masks, &broken.attained))
}

/// Shows by the sound bound of a later level that a promise is kept: the first such level.
fn kept<'f>(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: CellReading<'_>,
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
    let axes = scheme.constants.map(|axis| &**axis);
    // A depth is promised for all later levels too.
    let last = |later| if matches!(promise, Promise::Depth { .. }) { later } else { level };
    let change = |later| {
        let changes = (level..=last(later)).map(|level| change(&axes, offset, level, later));
        changes.collect::<Option<Vec<Rational>>>()?.into_iter().max()
    };
    let later = later(&bound, level, MAX_LATER, change, |sum| sum * &spread <= most);
    Ok(later.map(PromiseEvidence::Kept))
}

/// The level that a cell is about, and the promised bound of the distance at that level.
pub(super) fn terms(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: CellReading<'_>,
) -> Result<Option<(u32, Rational)>, Diagnostic> {
    let Some(printed) = judge.printed(at) else { return Ok(None) };
    let (level, most) = match promise {
        Promise::Depth { tolerance, .. } => {
            let level = printed.numerator().to_i64().filter(|_| printed.is_integer());
            (level, number(judge, tolerance, at)?)
        }
        Promise::Bound { level, .. } => (integer(judge, level, at)?, Some(printed)),
    };
    Ok(level.and_then(|level| u32::try_from(level).ok()).zip(most))
}
