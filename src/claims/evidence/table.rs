//! The evidence of certificates about tables: the scale of a table, its constants, and the blocks
//! of its sound bounds.

use crate::bound::{Budget, SoundBound};
use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::library::Library;
use crate::evaluation::quantity::Quantities;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evidence::constants;
use crate::evidence::constants::{AttainedConstant, SearchedConstant};
use crate::exact::Rational;
use crate::finding::{Kept, TableFinding};
use crate::formula::LocatedFormula;
use crate::judge::reading::search;
use std::collections::BTreeSet;

/// The highest level whose bound is shown.
const MAX_LEVEL: u32 = 1_000;

/// The evidence for the verdicts of a table.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    /// The stated parameter to which every value is proportional, if there is one.
    pub scale: Option<String>,
    /// The constants of the values whose residue classes can all be computed.
    pub attained: Vec<AttainedConstant>,
    /// The constants with too many residue classes for that.
    pub searched: Vec<SearchedConstant>,
    /// The sound bounds of the cells, where there are any.
    pub sound: Vec<SoundCell>,
}

/// A sound bound of a cell, with the block that gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SoundCell {
    /// The row, counted from 0.
    pub row: usize,
    /// The column, counted from 0.
    pub column: usize,
    /// The greatest level m whose constant C_m is computed.
    pub levels: usize,
    /// The block length c.
    pub block: u32,
    /// The bound, or the depth.
    pub value: Rational,
}

/// The evidence for a table. If the table is `read_otherwise`, the evidence also has the constants
/// that other readings may need.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn evidence(
    paper: &Paper,
    finding: &TableFinding<'_>,
    read_otherwise: bool,
) -> Result<Evidence, Diagnostic> {
    let (library, table) = (Library::new(paper), finding.table);
    let judge = Evaluator::new(paper, table, &library, &finding.values())?;
    let budget = Budget::new(constants::MAX_STEPS);
    let (attained, mut searched) = constants::constants(&judge, read_otherwise, &budget)?;
    for constant in convergence(&judge, finding, &budget)? {
        if !searched.contains(&constant) {
            searched.push(constant);
        }
    }
    let scale = search::scale(&judge, &finding.cells);
    let mut sound = Vec::new();
    if let Some(promise) = &table.promise {
        for row in 0..table.cells.len() {
            for column in 0..table.cells[row].len() {
                sound.extend(sound_cell(&judge, promise, row, column)?);
            }
        }
    }
    Ok(Evidence { scale, attained, searched, sound })
}

/// The constants that show the convergence of those schemes whose control data break promises.
fn convergence(
    judge: &Evaluator<'_>,
    finding: &TableFinding<'_>,
    budget: &Budget,
) -> Result<Vec<SearchedConstant>, Diagnostic> {
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let (mut known, mut constants) = (BTreeSet::new(), Vec::new());
    for (row, cells) in finding.cells.iter().enumerate() {
        for column in (0..cells.len()).filter(|&i| matches!(cells[i].kept, Some(Kept::No(_)))) {
            let at = CellReading { row, column, assume: &assume, settings: &Settings::default() };
            if let Ok(Quantities { scheme: Some(scheme), .. }) = judge.quantities(at)?
                && known.insert(scheme.instances.clone())
            {
                constants.extend(constants::convergence(&scheme, budget));
            }
        }
    }
    Ok(constants)
}

fn sound_cell(
    judge: &Evaluator<'_>,
    promise: &Promise,
    row: usize,
    column: usize,
) -> Result<Option<SoundCell>, Diagnostic> {
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let at = CellReading { row, column, assume: &assume, settings: &Settings::default() };
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) = promise;
    let offset = match offset {
        None => None,
        Some(formula) => match integer(judge, formula, at)? {
            None => return Ok(None),
            offset => offset,
        },
    };
    let Ok(bound) = judge.library.sound_bound(&scheme, offset) else { return Ok(None) };
    let Some(spread) = number(judge, spread, at)? else { return Ok(None) };
    let found = match promise {
        Promise::Depth { tolerance, .. } => {
            let tolerance = number(judge, tolerance, at)?;
            let depth = tolerance.and_then(|tolerance| bound.depth(&spread, &tolerance).ok());
            depth.map(|depth| (Rational::from(depth.level), depth.block))
        }
        Promise::Bound { level, .. } => {
            let level = integer(judge, level, at)?.and_then(|level| u32::try_from(level).ok());
            let level = level.filter(|level| *level <= MAX_LEVEL);
            level
                .and_then(|level| bound.level(level))
                .map(|(value, block)| (value * &spread, block))
        }
    };
    let levels = levels(&bound);
    Ok(found.map(|(value, block)| SoundCell { row, column, levels, block, value }))
}

fn levels(bound: &SoundBound) -> usize {
    bound.constants().len() - 1
}

/// The value of a formula at a cell; `None` if it is irrational or missing.
pub(crate) fn number(
    judge: &Evaluator<'_>,
    formula: &LocatedFormula,
    at: CellReading<'_>,
) -> Result<Option<Rational>, Diagnostic> {
    Ok(match judge.evaluate(formula, at)? {
        Outcome::Value(value) => value.as_rational().cloned(),
        _ => None,
    })
}

pub(crate) fn integer(
    judge: &Evaluator<'_>,
    formula: &LocatedFormula,
    at: CellReading<'_>,
) -> Result<Option<i64>, Diagnostic> {
    let value = number(judge, formula, at)?.filter(Rational::is_integer);
    Ok(value.and_then(|value| value.numerator().within(10_000)))
}
