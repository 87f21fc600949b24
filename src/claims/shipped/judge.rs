//! Judging the tables of a project.

use super::claim::{NumberType, Project, ShippedClaim};
use super::exact::Values;
use super::finding::{Outcome, ProjectAudit, ShippedCell, ShippedFinding, Verdict};
use super::verdict::verdict;
use super::{follows, reading};
use crate::diagnostic::{Collected, Diagnostic, Errors};
use crate::exact::{Rational, RealExpression};

/// Judges every table of a project.
///
/// # Errors
/// When a formula has no value for some number: all such errors, one of each table.
pub fn audit_project(project: &Project) -> Result<ProjectAudit<'_>, Errors> {
    audit_with(project, &|| {})
}

/// Judges every table of several projects; calls `after_table` after each.
///
/// # Errors
/// As [`audit_project`], of the first project that has errors.
pub fn audit_projects<'a>(
    projects: &'a [Project],
    after_table: &dyn Fn(),
) -> Result<Vec<ProjectAudit<'a>>, Errors> {
    projects.iter().map(|project| audit_with(project, after_table)).collect()
}

fn audit_with<'a>(
    project: &'a Project,
    after_table: &dyn Fn(),
) -> Result<ProjectAudit<'a>, Errors> {
    let mut errors = Collected::default();
    let findings = errors.all(&project.shipped, |claim| {
        let finding = audit_shipped(project, claim);
        after_table();
        finding
    });
    errors.none()?;
    Ok(ProjectAudit { project, findings })
}

/// Judges one table of a project.
///
/// # Errors
/// When a formula has no value for some number.
pub fn audit_shipped<'a>(
    project: &'a Project,
    claim: &'a ShippedClaim,
) -> Result<ShippedFinding<'a>, Diagnostic> {
    let values = Values::new(project, claim, None);
    let cell = |place: usize| {
        let exact = Diagnostic::or_cap(values.at(&claim.exact, place))?;
        let (number, kind) = (&claim.numbers[place], claim.kind);
        let known = exact.as_ref().ok();
        let verdict = known.map_or(Verdict::Open, |exact| verdict(exact, number, kind));
        let error = known.map(|exact| error(exact, &number.held, kind));
        Ok(ShippedCell { exact, verdict, error })
    };
    let cells = (0..claim.numbers.len()).map(cell).collect::<Result<Vec<_>, Diagnostic>>()?;
    let worst = cells.iter().map(|cell| cell.verdict.outcome()).max().unwrap_or(Outcome::Nearest);
    let needs_reading = cells.iter().any(|cell| {
        !matches!(cell.verdict, Verdict::Nearest | Verdict::Rounded(_) | Verdict::Cut(_))
    });
    let reading = needs_reading.then(|| reading::reading(project, claim, &cells)).flatten();
    let farthest = farthest(&cells);
    Ok(ShippedFinding {
        id: format!("{}:{}", project.key, claim.id),
        claim,
        outcome: if reading.is_some() { Outcome::Otherwise } else { worst },
        reading,
        farthest,
        sums: follows::sums(claim, &cells),
        equals: follows::equals(claim, &cells),
        cells,
    })
}

/// |held − x|, from an enclosure that is much finer than the type.
fn error(x: &RealExpression, held: &Rational, kind: NumberType) -> Rational {
    let bits = match kind {
        NumberType::Single | NumberType::Double => 128,
        NumberType::Decimal(digits) => 4 * digits + 64,
    };
    let level = (0..8).find(|level| 64 << level >= bits).unwrap_or(8);
    let near = x.near(level);
    let middle = (near.lower() + near.upper()) * Rational::new(1, 2);
    (held - middle).abs()
}

/// The place of the greatest error.
fn farthest(cells: &[ShippedCell]) -> Option<usize> {
    let away = |place: &usize| cells[*place].error.as_ref().is_some_and(|error| !error.is_zero());
    let mut places = (0..cells.len()).filter(away);
    let first = places.next()?;
    Some(places.fold(
        first,
        |best, place| {
            if cells[place].error > cells[best].error { place } else { best }
        },
    ))
}
