//! The report about the tables of projects.

use super::table::section;
use super::words::{count, is_wrong};
use crate::report::words::sheet::{Grid, Sheet};
use crate::shipped::{Outcome, Project, ProjectAudit, ShippedFinding, Verdict};

/// The text in place of a count of 0.
const NONE: &str = "·";

/// The report about projects: what is found in each, then table by table; with `all`, with every number, and tables in which
/// nothing is wrong have a section too.
#[must_use]
pub fn projects_sheet(audits: &[ProjectAudit<'_>], all: bool) -> Sheet {
    let mut sheet = Sheet::default();
    for audit in audits {
        sheet.text(sentence(audit));
    }
    if audits.iter().map(|audit| audit.findings.len()).sum::<usize>() > 1 {
        sheet.grid(counts(audits));
    }
    for audit in audits {
        project(&mut sheet, audit, all);
    }
    sheet
}

/// `opensubdiv (OpenSubdiv): of 4 tables, 2 are right, …`.
pub(crate) fn sentence(audit: &ProjectAudit<'_>) -> String {
    let Project { key, name, .. } = audit.project;
    let all = audit.findings.len();
    let states = Outcome::ALL.into_iter().flat_map(|outcome| [(outcome, false), (outcome, true)]);
    let parts: Vec<String> = states
        .filter_map(|(outcome, wrong)| {
            let is = |finding: &&ShippedFinding<'_>| {
                finding.outcome == outcome && has_wrong(finding) == wrong
            };
            let found = audit.findings.iter().filter(is).count();
            (found > 0).then(|| format!("{found} {}", outcome_text(outcome, wrong, found)))
        })
        .collect();
    let key = if key == name { String::new() } else { format!(" ({key})") };
    format!("{name}{key}: of {}, {}.", count(all, "table", "tables"), parts.join(", "))
}

/// Whether a refuted table has numbers of which few digits are right, and not only some that are right to fewer digits than
/// are written.
fn has_wrong(finding: &ShippedFinding<'_>) -> bool {
    finding.outcome == Outcome::Refuted && finding.count(is_wrong) > 0
}

fn outcome_text(outcome: Outcome, wrong: bool, count: usize) -> &'static str {
    match (outcome, count) {
        (Outcome::Nearest, 1) => "is right to the last bit",
        (Outcome::Nearest, _) => "are right to the last bit",
        (Outcome::Cut, 1) => "is right to the digits that are written",
        (Outcome::Cut, _) => "are right to the digits that are written",
        (Outcome::Ulps, 1) => "is right but for the last places",
        (Outcome::Ulps, _) => "are right but for the last places",
        (Outcome::Otherwise, 1) => "is another table than it is said to be",
        (Outcome::Otherwise, _) => "are other tables than they are said to be",
        (Outcome::Open, 1) => "is not decided",
        (Outcome::Open, _) => "are not decided",
        (Outcome::Misprint, 1) => "has misprints",
        (Outcome::Misprint, _) => "have misprints",
        (Outcome::Refuted, 1) if !wrong => "is right to fewer digits than are written",
        (Outcome::Refuted, _) if !wrong => "are right to fewer digits than are written",
        (Outcome::Refuted, 1) => "has wrong numbers",
        (Outcome::Refuted, _) => "have wrong numbers",
    }
}

/// A count of verdicts: its heading, and whether a verdict is counted.
type Column = (&'static str, fn(Verdict) -> bool);

const COLUMNS: [Column; 7] = [
    ("✓ nearest", |verdict| verdict == Verdict::Nearest),
    ("≈ rounded", |verdict| matches!(verdict, Verdict::Rounded(_))),
    ("≈ cut", |verdict| matches!(verdict, Verdict::Cut(_))),
    ("≈ last\nplaces", |verdict| matches!(verdict, Verdict::Ulps(_))),
    ("± mis-\nprint", |verdict| matches!(verdict, Verdict::Misprint(_))),
    ("✗ other", |verdict| matches!(verdict, Verdict::Refuted(_))),
    ("? open", |verdict| verdict == Verdict::Open),
];

/// The numbers of each table by verdict.
pub(crate) fn counts(audits: &[ProjectAudit<'_>]) -> Grid {
    let header = ["table", "numbers"].into_iter().chain(COLUMNS.iter().map(|(name, _)| *name));
    let row = |finding: &ShippedFinding<'_>| {
        let counted = COLUMNS.iter().map(|(_, is)| match finding.count(is) {
            0 => NONE.to_owned(),
            count => count.to_string(),
        });
        let name = format!("{} {}", finding.outcome.word().mark(), finding.id);
        [name, finding.cells.len().to_string()].into_iter().chain(counted).collect()
    };
    Grid::of(header, audits.iter().flat_map(|audit| &audit.findings).map(row), 1)
}

fn project(sheet: &mut Sheet, audit: &ProjectAudit<'_>, all: bool) {
    let Project { key, name, note, .. } = audit.project;
    sheet.heading(1, format!("{key} · {name}"));
    let source = audit.project.source_words();
    if !source.is_empty() {
        sheet.text(format!("{}.", source.join(", ")));
    }
    if let Some(note) = note {
        sheet.text(note.clone());
    }
    let is_shown = |finding: &&ShippedFinding<'_>| all || !finding.is_right();
    let (shown, right): (Vec<_>, Vec<_>) = audit.findings.iter().partition(is_shown);
    for finding in shown {
        section(sheet, 2, audit.project, finding, all);
    }
    if !right.is_empty() {
        sheet.heading(2, "Right to the last bit");
        let row = |finding: &&ShippedFinding<'_>| {
            let claim = finding.claim;
            let numbers = claim.numbers.len().to_string();
            vec![claim.id.clone(), claim.locus.clone(), claim.title.clone(), numbers]
        };
        sheet.grid(Grid::of(["id", "where", "what", "numbers"], right.iter().map(row), 3));
    }
}
