//! The audit of shipped constants as JSON.

use super::SCHEMA;
use crate::audit::Word;
use crate::exact::{Rational, format::short};
use crate::report::shipped::shipped_reading;
use crate::shipped::{
    ExactValues, Origin, Outcome, ProjectAudit, ShippedFinding, Verdict, decimal, nearest_text,
};
use serde::Serialize;
use std::collections::BTreeMap;

/// The digits of decimals.
const DIGITS: u32 = 30;

/// The digits of errors.
const ERROR_DIGITS: u32 = 6;

/// What `subcert audit` finds about the constants of projects.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProjectsReport<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The projects.
    pub projects: Vec<ProjectReport<'a>>,
}

/// What is found in a project.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProjectReport<'a> {
    /// Its key.
    pub key: &'a str,
    /// Its name.
    pub name: &'a str,
    /// Where its source is public.
    pub repository: Option<&'a str>,
    /// The commit that was read.
    pub commit: Option<&'a str>,
    /// The licence of the source.
    pub licence: Option<&'a str>,
    /// How many tables have each outcome.
    pub summary: BTreeMap<&'static str, usize>,
    /// Its tables.
    pub tables: Vec<ShippedTable<'a>>,
}

/// What is found of a table.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShippedTable<'a> {
    /// Its id within the project.
    pub id: &'a str,
    /// File and name in the source.
    pub locus: &'a str,
    /// What it is.
    pub title: &'a str,
    /// The type: `f32`, `f64` or `decimal:D`.
    #[serde(rename = "type")]
    pub kind: String,
    /// The formula of all numbers; null where each has its own.
    pub equals: Option<&'a str>,
    /// The source file that was read; null where the numbers are typed into the claim file.
    pub read_from: Option<&'a str>,
    /// The worst that is said of a number, or `otherwise` where a reading explains the table.
    pub outcome: &'static str,
    /// How many numbers have each outcome.
    pub counts: BTreeMap<&'static str, usize>,
    /// How the table came about, in words; null where nothing else than the formula explains it.
    pub reading: Option<String>,
    /// The number with the greatest error, counted from 0; null where all are exact.
    pub farthest: Option<usize>,
    /// The error that is accepted, and whether none is greater; null where none is stated.
    pub tolerance: Option<Tolerance<'a>>,
    /// Lines whose sums are not kept; null where they are.
    pub sums: Option<Sums>,
    /// Equal values that are shipped differently; null where none are.
    pub split_equals: Option<SplitValues>,
    /// The numbers, in order.
    pub numbers: Vec<Number<'a>>,
}

/// An error that is accepted.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Tolerance<'a> {
    /// As written.
    pub value: &'a str,
    /// Whether no error is greater.
    pub kept: bool,
}

/// Lines along the last index whose sums are not the exact one.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sums {
    /// The exact sum, a fraction.
    pub exact: String,
    /// How many lines are farther from it than those of the nearest numbers.
    pub lines: usize,
    /// The place of the first number of the farthest line, counted from 0.
    pub first: usize,
    /// The sum of this line as shipped.
    pub shipped: String,
    /// The greatest distance of a sum of the nearest numbers of the type.
    pub nearest_error: String,
}

/// Equal values that are shipped differently.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SplitValues {
    /// How many exact values.
    pub values: usize,
    /// Two places of one of them, counted from 0.
    pub pair: [usize; 2],
}

/// A number.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Number<'a> {
    /// The values of the indices.
    pub at: BTreeMap<&'a str, i64>,
    /// The number as in the source.
    pub shipped: &'a str,
    /// Its line in the source file; null where it is typed into the claim file.
    pub line: Option<usize>,
    /// `nearest`, `rounded`, `cut`, `ulps`, `misprint`, `refuted` or `open`.
    pub verdict: &'static str,
    /// The digits that are written, of `rounded` and `cut`; those that agree, of `refuted`; null otherwise.
    pub digits: Option<u64>,
    /// How many units in the last place, of `ulps`; null otherwise.
    pub ulps: Option<u64>,
    /// `sign`, `point`, `digit`, `exchanged` or `dropped`, of `misprint`; null otherwise.
    pub slip: Option<&'static str>,
    /// The exact value as a decimal of 30 significant digits; null beyond a cap.
    pub exact: Option<String>,
    /// The cap that the exact value is beyond; null where it is known.
    pub cap: Option<String>,
    /// What one would write so that the program holds the nearest number; null where it is not decided.
    pub nearest: Option<String>,
    /// How far the number that the program holds is from the exact one; null beyond a cap.
    pub error: Option<String>,
}

impl<'a> ProjectsReport<'a> {
    /// The JSON form of these audits.
    #[must_use]
    pub fn of(audits: &'a [ProjectAudit<'_>]) -> ProjectsReport<'a> {
        ProjectsReport { schema: SCHEMA, projects: audits.iter().map(ProjectReport::of).collect() }
    }
}

impl<'a> ProjectReport<'a> {
    fn of(audit: &'a ProjectAudit<'_>) -> ProjectReport<'a> {
        let project = audit.project;
        ProjectReport {
            key: &project.key,
            name: &project.name,
            repository: project.repository.as_deref(),
            commit: project.commit.as_deref(),
            licence: project.licence.as_deref(),
            summary: tally(audit.findings.iter().map(|finding| finding.outcome)),
            tables: audit.findings.iter().map(ShippedTable::of).collect(),
        }
    }
}

/// How often each outcome occurs.
fn tally(outcomes: impl Iterator<Item = Outcome>) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for outcome in outcomes {
        *counts.entry(outcome.word().name()).or_insert(0) += 1;
    }
    counts
}

/// What `subcert explain` says of a table of a project.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExplainedTable<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The table; its fields stand here.
    #[serde(flatten)]
    pub table: ShippedTable<'a>,
}

impl<'a> ExplainedTable<'a> {
    /// The form of what is found of a table.
    #[must_use]
    pub fn of(finding: &'a ShippedFinding<'_>) -> ExplainedTable<'a> {
        ExplainedTable { schema: SCHEMA, table: ShippedTable::of(finding) }
    }
}

impl<'a> ShippedTable<'a> {
    /// The JSON form of a finding.
    #[must_use]
    pub fn of(finding: &'a ShippedFinding<'_>) -> ShippedTable<'a> {
        let claim = finding.claim;
        let kept = |tolerance: &Rational| {
            let within = |place| finding.is_within(place, tolerance) == Some(true);
            (0..finding.cells.len()).all(within)
        };
        ShippedTable {
            id: &claim.id,
            locus: &claim.locus,
            title: &claim.title,
            kind: claim.kind.name(),
            equals: match &claim.exact {
                ExactValues::Formula(formula) => Some(&formula.text),
                ExactValues::Each(_) => None,
            },
            read_from: match &claim.origin {
                Origin::Source { file, .. } => Some(file),
                Origin::Typed(_) => None,
            },
            outcome: finding.outcome.word().name(),
            counts: tally(finding.cells.iter().map(|cell| cell.verdict.outcome())),
            reading: finding.reading.as_ref().map(|reading| shipped_reading(claim, reading)),
            farthest: finding.farthest,
            tolerance: claim
                .tolerance
                .as_ref()
                .map(|(value, tolerance)| Tolerance { value, kept: kept(tolerance) }),
            sums: finding.sums.as_ref().map(|sums| Sums {
                exact: sums.exact.to_string(),
                lines: sums.lines,
                first: sums.first,
                shipped: short(&sums.held, DIGITS),
                nearest_error: error(&sums.nearest),
            }),
            split_equals: finding
                .equals
                .as_ref()
                .map(|equals| SplitValues { values: equals.values, pair: equals.pair }),
            numbers: (0..finding.cells.len()).map(|place| Number::of(finding, place)).collect(),
        }
    }
}

impl<'a> Number<'a> {
    fn of(finding: &'a ShippedFinding<'_>, place: usize) -> Number<'a> {
        let (claim, cell) = (finding.claim, &finding.cells[place]);
        let (number, exact) = (&claim.numbers[place], cell.exact.as_ref().ok());
        let (verdict, digits, ulps, slip) = parts(cell.verdict);
        Number {
            at: claim.at(place).into_iter().collect(),
            shipped: &number.text,
            line: number.line,
            verdict,
            digits,
            ulps,
            slip,
            exact: exact.map(|exact| decimal(exact, DIGITS)),
            cap: cell.exact.as_ref().err().map(ToString::to_string),
            nearest: exact.and_then(|exact| nearest_text(exact, claim.kind)),
            error: cell.error.as_ref().map(error),
        }
    }
}

/// The name of a verdict, and its digits, units or slip.
fn parts(verdict: Verdict) -> (&'static str, Option<u64>, Option<u64>, Option<&'static str>) {
    match verdict {
        Verdict::Nearest => ("nearest", None, None, None),
        Verdict::Rounded(digits) => ("rounded", u64::try_from(digits).ok(), None, None),
        Verdict::Cut(digits) => ("cut", u64::try_from(digits).ok(), None, None),
        Verdict::Ulps(units) => ("ulps", None, Some(units), None),
        Verdict::Misprint(slip) => (Word::Misprint.name(), None, None, Some(slip.name())),
        Verdict::Refuted(agree) => (Word::Refuted.name(), Some(u64::from(agree)), None, None),
        Verdict::Open => (Word::Open.name(), None, None, None),
    }
}

fn error(error: &Rational) -> String {
    short(error, ERROR_DIGITS)
}
