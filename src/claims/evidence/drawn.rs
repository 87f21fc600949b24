//! What pictures of promises are drawn from: what refines the data, and the sound bound level by level.

use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::CellReading;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evidence::promise::terms;
use crate::evidence::table::{integer, number};
use crate::exact::Rational;
use crate::finding::{Refiner, Sound, TableFinding};
use std::collections::BTreeSet;

/// The most levels.
const MAX_LEVELS: u32 = 60;

/// How many levels after the printed and the sound depth are shown.
const AFTER: u32 = 2;

/// How the sound bound of a printed depth falls from level to level.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthLevels {
    /// C_0 = 1, C_1, …: the contraction constants T_c of a curve, T_c·Λ_c of a net.
    pub constants: Vec<Rational>,
    /// The sound bound of the distance of the levels 0, 1, …
    pub bounds: Vec<Rational>,
    /// ε.
    pub tolerance: Rational,
    /// The printed depth.
    pub printed: u32,
    /// The least level at which the bound meets the tolerance.
    pub sound: u32,
}

/// How the sound bound falls from level to level, to where it meets the tolerance of a cell that prints a
/// depth, and beyond the printed depth; `None` of other cells, of rings, and of more than 60 levels.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn depth_levels(
    paper: &Paper,
    finding: &TableFinding<'_>,
    (row, column): (usize, usize),
) -> Result<Option<DepthLevels>, Diagnostic> {
    let Some(promise @ Promise::Depth { spread, offset, ring: None, .. }) = &finding.table.promise
    else {
        return Ok(None);
    };
    let Some(Sound::Depth { level: sound, .. }) = finding.cells[row][column].sound else {
        return Ok(None);
    };
    let library = Library::new(paper);
    let judge = Evaluator::new(paper, finding.table, &library, &finding.values())?;
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let at = CellReading { row, column, assume: &assume, settings: &Settings::default() };
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let offset = offset.as_ref().map(|offset| integer(&judge, offset, at)).transpose()?.flatten();
    let Some(spread) = number(&judge, spread, at)? else { return Ok(None) };
    let Some((printed, tolerance)) = terms(&judge, promise, at)? else { return Ok(None) };
    let last = printed.max(sound) + AFTER;
    let Ok(bound) = library.sound_bound(&scheme, offset) else { return Ok(None) };
    let bounds = (last <= MAX_LEVELS).then(|| bound.levels(last)).flatten();
    let Some(bounds) = bounds else { return Ok(None) };
    Ok(Some(DepthLevels {
        constants: bound.constants().to_vec(),
        bounds: bounds.iter().map(|bound| bound * &spread).collect(),
        tolerance,
        printed,
        sound,
    }))
}

/// What refines the data of the promise of a cell, masks at the offset at which the paper compares points and
/// limit; `None` where the cell has no scheme.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn promise_refiner(
    paper: &Paper,
    finding: &TableFinding<'_>,
    (row, column): (usize, usize),
) -> Result<Option<Refiner>, Diagnostic> {
    let Some(promise) = &finding.table.promise else { return Ok(None) };
    let library = Library::new(paper);
    let judge = Evaluator::new(paper, finding.table, &library, &finding.values())?;
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let at = CellReading { row, column, assume: &assume, settings: &Settings::default() };
    let (Promise::Depth { offset, ring, .. } | Promise::Bound { offset, ring, .. }) = promise;
    if let Some(ring) = ring {
        return Ok(judge.ring(ring, at)?.ok().map(|(_, ring)| Refiner::Ring(ring)));
    }
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let offset = offset.as_ref().map(|offset| integer(&judge, offset, at)).transpose()?.flatten();
    Ok(Some(Refiner::Masks(scheme.at(offset).iter().cloned().collect())))
}
