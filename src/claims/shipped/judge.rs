//! Judging the tables of a project.

use super::claim::{Project, ShippedClaim};
use super::exact::Values;
use super::finding::{Outcome, ProjectAudit, ShippedCell, ShippedFinding, Verdict};
use super::number::{LEVELS, Settled as _};
use super::verdict::verdict;
use super::{follows, reading};
use crate::diagnostic::{Collected, Diagnostic, Errors};
use crate::exact::{Rational, RealCyclotomic, RealExpression, format::short};

/// The digits of an error that are right, as it is printed and as it is compared.
const ERROR_DIGITS: [u32; 2] = [3, 20];

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
        let error = known.and_then(|exact| error(exact, &number.held));
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

/// |held − x|: 0 where they are equal, and else so near that its leading digits are right. `None` where it is not decided
/// whether they are equal.
fn error(x: &RealExpression, held: &Rational) -> Option<Rational> {
    if let Some(x) = x.as_number().and_then(RealCyclotomic::as_rational) {
        return Some((held - x).abs());
    }
    if x.against(held)?.is_eq() {
        return Some(Rational::zero());
    }
    // Texts of both lengths, as rounding twice is not rounding once.
    let digits = |x: &Rational| {
        let error = (held - x).abs();
        (x.cmp(held), ERROR_DIGITS.map(|digits| short(&error, digits)))
    };
    let near = LEVELS.map(|level| x.near(level));
    let known = near.into_iter().find(|near| digits(near.lower()) == digits(near.upper()));
    Some((held - known.unwrap_or_else(|| x.near(LEVELS.end - 1)).middle()).abs())
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
