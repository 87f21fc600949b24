//! The findings that the Coq library of `proofs/coq` covers, as statements about numbers.

use crate::bound::{Operator, Order, SoundBound};
use crate::claim::{Paper, Promise, Quantity, Statement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::CellReading;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evaluation::trace::NotedConstant;
use crate::evidence::drawn::promise_refiner;
use crate::evidence::excess::{exceeds, rationals};
use crate::evidence::table::{integer, number};
use crate::exact::Rational;
use crate::finding::{
    Broken, Kept, KernelFinding, KernelStatement, Naturally, PaperAudit, Refutation, TableFinding,
    TheoremFinding, Violation,
};
use crate::judge::theorem::instance;
use crate::limit::Parametrisation;
use crate::scheme::Axes;
use std::collections::BTreeSet;

/// Constants with more residue classes are left out: `coqc` computes every class.
const MAX_CLASSES: u64 = 1 << 14;

/// Bounds at higher levels are left out.
const MAX_LEVELS: u32 = 200;

/// The findings of a paper that the Coq library covers, claim by claim.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn kernel_findings(audit: &PaperAudit<'_>) -> Result<Vec<KernelFinding>, Diagnostic> {
    let mut found = Vec::new();
    for table in &audit.tables {
        of_table(audit.paper, table, &mut found)?;
    }
    for finding in &audit.theorems {
        let Some(refutation) = &finding.refutation else { continue };
        let Refutation { case, scheme, values, violation, .. } = refutation;
        let limit = rationals(&refutation.limit);
        let stated = (finding.theorem.tried.parametrisation(), limit.as_deref());
        found.extend(refuted(audit, finding, (case, scheme, values), violation, stated)?);
        if let Some(Naturally::Refuted { case, scheme, values, violation, .. }) =
            &refutation.natural
        {
            let natural = (Parametrisation::Natural, None);
            found.extend(refuted(audit, finding, (case, scheme, values), violation, natural)?);
        }
    }
    Ok(found)
}

/// That data refute a theorem in a case, with the points at these parameters.
fn refuted(
    audit: &PaperAudit<'_>,
    finding: &TheoremFinding<'_>,
    (case, scheme, values): (&str, &str, &[(String, Rational)]),
    violation: &Violation,
    (points, limit): (Parametrisation, Option<&[Rational]>),
) -> Result<Option<KernelFinding>, Diagnostic> {
    let (theorem, level) = (finding.theorem, violation.level);
    let Some(bound) = violation.bound.as_rational() else { return Ok(None) };
    let (tolerance, what, by) = match &theorem.statement {
        Statement::Bound { by, .. } => (String::new(), "bound", by),
        Statement::Depth(by) => (format!(" and tolerance {bound}"), "depth", by),
        Statement::Other(_) => return Ok(None),
    };
    let found = instance(audit.paper, theorem, case, (level, &violation.bound))?;
    let Some(instance) = found else { return Ok(None) };
    let statement = exceeds(
        (&instance.refiner, instance.interpolant.as_ref()),
        (violation.quantity, level),
        &violation.attained,
        (bound, limit),
        points,
    );
    let values = values.iter().map(|(name, value)| format!(", {name} = {value}"));
    let values = values.collect::<Vec<String>>().concat();
    let (at, by) = (naturally(points), &by.text);
    Ok(statement.map(|statement| KernelFinding {
        kind: "theorem",
        claim: theorem.id.clone(),
        assumed: Vec::new(),
        place: format!("{}: {}", theorem.locus, theorem.title),
        about: format!(
            "Refuted{at} for {scheme}{values} at level {level}{tolerance}; the {what} is {by}"
        ),
        statement,
    }))
}

/// What a sentence about points at these parameters says of them.
fn naturally(points: Parametrisation) -> &'static str {
    match points {
        Parametrisation::Indexed => "",
        Parametrisation::Natural => " at natural parameters",
    }
}

fn of_table(
    paper: &Paper,
    finding: &TableFinding<'_>,
    found: &mut Vec<KernelFinding>,
) -> Result<(), Diagnostic> {
    let (library, table) = (Library::new(paper), finding.table);
    let judge = Evaluator::new(paper, table, &library, &finding.values())?;
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let settings = Settings::default();
    let assumed: Vec<_> =
        judge.assumed.iter().map(|(name, value)| (name.clone(), value.clone())).collect();
    let new = |place: &str, about: &str, statement| KernelFinding {
        kind: "table",
        claim: table.id.clone(),
        assumed: assumed.clone(),
        place: place.to_owned(),
        about: about.to_owned(),
        statement,
    };
    let mut known = BTreeSet::new();
    for (row, cells) in finding.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            let at = CellReading { row, column, assume: &assume, settings: &settings };
            let printed = cell.printed.as_deref().unwrap_or("nothing");
            let place =
                format!("row {}, column {}: {} prints {printed}", row + 1, column + 1, cell.locus);
            for noted in judge.constants(at)?.constants {
                let key = (noted.instance.clone(), noted.operator, noted.order, noted.levels);
                if known.contains(&key) {
                    continue;
                }
                if let Some((statement, value)) = constant(&noted) {
                    known.insert(key);
                    let is_value = cell.exact.as_ref() == Some(&value.into());
                    let how = if is_value { "is" } else { "rests on" };
                    found.push(new(&place, &format!("It {how} this constant."), statement));
                }
            }
            if let Some(promise) = &table.promise
                && let Some(statement) = sound(&judge, promise, at)?
            {
                let what = match statement {
                    KernelStatement::Depth { .. } => "This depth suffices.",
                    _ => "This bound holds.",
                };
                found.push(new(&place, what, statement));
            }
            for (kept, points) in [
                (&cell.kept, Parametrisation::Indexed),
                (&cell.kept_naturally, Parametrisation::Natural),
            ] {
                let Some(Kept::No(broken)) = kept else { continue };
                let Some(refiner) = promise_refiner(paper, finding, (row, column))? else {
                    continue;
                };
                let Broken { attained, spread, level, most, .. } = &**broken;
                let of = (Quantity::Distance, *level);
                let bound = (&(most / spread), None);
                if let Some(statement) = exceeds((&refiner, None), of, attained, bound, points) {
                    let at = naturally(points);
                    let scaled = format!(
                        "Broken{at} at level {level}: {most} for points of spread {spread}"
                    );
                    found.push(new(&place, &scaled, statement));
                }
            }
        }
    }
    Ok(())
}

fn constant(noted: &NotedConstant) -> Option<(KernelStatement, Rational)> {
    let NotedConstant { constants, operator, levels, order, .. } = noted;
    let mask = constants.mask().clone();
    let classes = (mask.arity() as u64).checked_pow(*levels)?;
    if *levels == 0 || classes > MAX_CLASSES {
        return None;
    }
    let value = constants.norm(*operator, *levels, *order).ok()?;
    // For c = 1 the order does not matter.
    let backwards = (*order == Order::Forward && *levels > 1).then(|| match operator {
        Operator::Difference => constants.difference().clone(),
        Operator::Scheme => mask.rules().clone(),
    });
    let (operator, levels) = (*operator, *levels);
    Some((
        KernelStatement::Constant { mask, operator, backwards, levels, value: value.clone() },
        value,
    ))
}

/// The sound bound of a cell about a curve, by as few constants as give it.
fn sound(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: CellReading<'_>,
) -> Result<Option<KernelStatement>, Diagnostic> {
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let Axes::Curve(axis) = &scheme.constants else { return Ok(None) };
    let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) = promise;
    let offset = offset.as_ref().map(|offset| integer(judge, offset, at)).transpose()?.flatten();
    let mask = axis.mask().with_offset(offset.unwrap_or(axis.mask().offset()));
    let Ok(bound) = judge.library.sound_bound(&scheme, offset) else { return Ok(None) };
    let Some(spread) = number(judge, spread, at)? else { return Ok(None) };
    match promise {
        Promise::Depth { tolerance, .. } => {
            let Some(tolerance) = number(judge, tolerance, at)? else { return Ok(None) };
            let Ok(depth) = bound.depth(&spread, &tolerance) else { return Ok(None) };
            let found = fewest(&bound, |bound| {
                let less = bound.depth(&spread, &tolerance).ok()?;
                (less.level == depth.level).then_some(less.block)
            });
            let level = depth.level;
            Ok(found.map(|block| KernelStatement::Depth { mask, level, spread, tolerance, block }))
        }
        Promise::Bound { level, .. } => {
            let level = integer(judge, level, at)?.and_then(|level| u32::try_from(level).ok());
            let Some(level) = level.filter(|level| *level <= MAX_LEVELS) else { return Ok(None) };
            let Some((value, _)) = bound.level(level) else { return Ok(None) };
            let found = fewest(&bound, |bound| {
                bound.level(level).filter(|(less, _)| *less == value).map(|(_, block)| block)
            });
            let bound = value;
            Ok(found.map(|block| KernelStatement::Distance { mask, level, bound, block }))
        }
    }
}

/// The least M whose constants T_1, …, T_M serve, with the block length.
fn fewest(bound: &SoundBound, serves: impl Fn(&SoundBound) -> Option<u32>) -> Option<(usize, u32)> {
    (1..bound.constants().len()).find_map(|most| {
        let less = SoundBound::of(bound.factor().clone(), bound.constants()[..=most].to_vec());
        Some((most, serves(&less)?))
    })
}
