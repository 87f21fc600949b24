//! `subcert audit`.

use super::audit_output::Destination;
use super::certified::Certified;
use super::claim_files::{Claims, claims};
use super::judged::{files_of, judge_partly, select};
use super::pages;
use super::projects;
use crate::cli::arguments::{AuditArguments, FindingFormat, Format, Output, is_of_papers};
use crate::cli::console::answer::{Answer, show};
use crate::cli::console::output::{Failure, Outcome, none_denied};
use crate::cli::console::quantity::written;
use crate::cli::console::terminal;
use std::path::PathBuf;
use subcert::audit::{CellFinding, PaperAudit, TableFinding, Word};
use subcert::exact::format::short;
use subcert::report::json::AuditReport;
use subcert::report::{Grid, Sheet, audit_sheet, brief_sheet, legend, overview_sheet};

/// How many significant digits a decimal for spreadsheets has.
const DIGITS: u32 = 17;

pub(crate) fn audit(arguments: &AuditArguments) -> Outcome {
    let to = Destination::of(arguments)?;
    let papers = match claims(&arguments.files)? {
        Claims::Papers(papers) => select(papers, arguments.paper.as_deref())?,
        Claims::Projects(projects) => return projects::audit(arguments, to, projects),
    };
    if let Some(word) = arguments.deny.iter().find(|word| !is_of_papers(**word)) {
        let message = format!("--deny {word}: this is said only of constants that programs ship");
        return Err(Failure::Input(message));
    }
    let (audits, errors) = judge_partly(&papers, arguments.format != FindingFormat::Json);
    // Nothing is written of a file with errors, but what can be judged is shown on the screen.
    if errors.is_err() {
        if let Destination::Output(to) = &to
            && to.format == Format::Text
            && to.file.is_none()
            && audits.iter().any(|audit| !audit.claims().is_empty())
        {
            let shown = Shown::of(arguments, to);
            let files = &arguments.files;
            let partly = true;
            show(to, &Audit { audits: &audits, files, shown, certified: None, partly })?;
        }
        return errors;
    }
    let certified = if arguments.certified { Some(Certified::of(&audits)?) } else { None };
    match to {
        Destination::Output(to) => {
            let shown = Shown::of(arguments, &to);
            let files = &arguments.files;
            let partly = false;
            show(&to, &Audit { audits: &audits, files, shown, certified, partly })?;
        }
        Destination::Pages(folder) => {
            pages::pages(&audits, certified.as_ref(), arguments.files.is_empty(), folder)?;
        }
    }
    none_denied(&arguments.deny, Word::name, |verdict| {
        let count = audits.iter().map(|audit| count(audit, verdict)).sum();
        let is_promise = verdict == Word::Broken;
        (count, if is_promise { ["promise", "promises"] } else { ["claim", "claims"] })
    })
}

/// The audits of papers.
pub(crate) struct Audit<'a> {
    audits: &'a [PaperAudit<'a>],
    /// The claim files; none for embedded papers.
    files: &'a [PathBuf],
    shown: Shown,
    certified: Option<Certified>,
    /// Whether claims with errors are left out.
    partly: bool,
}

/// How much of an audit is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shown {
    /// What does most harm in each paper.
    Brief,
    Report {
        /// Every table and claim, also the right ones.
        all: bool,
        /// Whether it goes to the standard output.
        on_screen: bool,
    },
}

impl Shown {
    fn of(arguments: &AuditArguments, to: &Output) -> Shown {
        let AuditArguments { files, paper, full, all, .. } = arguments;
        let on_screen = to.format == Format::Text && to.file.is_none();
        if files.is_empty() && paper.is_none() && !full && !all {
            Shown::Brief
        } else {
            Shown::Report { all: *all, on_screen }
        }
    }
}

written!(audit: Audit<'_> => AuditReport<'_>, {
    let mut report = AuditReport::of(audit.audits);
    if let Some(certified) = &audit.certified {
        certified.mark(&mut report);
    }
    report
});

impl Answer for Audit<'_> {
    const NAME: &'static str = "audit";

    fn sheet(&self) -> Sheet {
        let (mut sheet, more) = match self.shown {
            Shown::Brief => (
                brief_sheet(self.audits, terminal::width()),
                "`subcert audit --full` is the whole report, `subcert explain KEY` lists the claims of a paper, \
                 and `subcert explain KEY:ID` says how one was judged. `subcert audit FILE` judges a paper of yours, \
                 and `subcert new` begins its claim file."
                    .to_owned(),
            ),
            Shown::Report { all, .. } => (
                audit_sheet(self.audits, all),
                format!(
                    "Under a cell: the exact value of the printed definition, of a promise rounded up, and the sound \
                     value where the printed one is not shown to keep its promise. `--all` shows every table, \
                     `{}` one claim, whose ID ends its heading.",
                    self.explain()
                ),
            ),
        };
        sheet.text(format!("{}. {more}", legend()));
        if self.partly {
            sheet.text("Claims with errors are left out here; the errors follow.");
        }
        if let Some(certified) = &self.certified {
            certified.section(&mut sheet);
        }
        let on_screen = matches!(self.shown, Shown::Report { on_screen: true, .. });
        if on_screen && self.audits.len() > 1 && is_longer_than_a_screen(&sheet) {
            // The summary has scrolled off the screen, and is repeated at the end.
            sheet.heading(1, "All papers");
            sheet.blocks.extend(overview_sheet(self.audits).blocks);
        }
        sheet
    }

    /// The cells of the tables: one row for each, with its verdict.
    fn grid(&self) -> Option<Grid> {
        let row = |audit: &PaperAudit<'_>, table: &TableFinding<'_>, cell: &CellFinding| {
            let printed = cell.printed.clone().unwrap_or_default();
            let exact = cell.exact.as_ref();
            let decimal = exact.map(|exact| short(exact, DIGITS)).unwrap_or_default();
            let exact = exact.map(ToString::to_string).unwrap_or_default();
            let verdict = cell.verdict.word().name().to_owned();
            let certificate =
                self.certified.as_ref().map(|all| all.of_claim(audit, &table.table.id).certificate);
            [vec![cell.id.clone(), printed, exact, decimal, verdict], Vec::from_iter(certificate)]
                .concat()
        };
        let mut rows = Vec::new();
        for audit in self.audits {
            for table in &audit.tables {
                rows.extend(table.claiming().map(|cell| row(audit, table, cell)));
            }
        }
        let mut header = vec!["id", "printed", "exact", "decimal", "verdict"];
        header.extend(self.certified.as_ref().map(|_| "certificate"));
        Some(Grid::of(header, rows, 5))
    }
}

impl Audit<'_> {
    /// The command that shows one claim.
    fn explain(&self) -> String {
        let file = match (self.audits, self.files) {
            (_, []) => return "subcert explain KEY:ID".to_owned(),
            ([audit], _) => files_of(audit.paper, self.files),
            _ => return "subcert explain KEY:ID FILE".to_owned(),
        };
        format!("subcert explain ID{file}")
    }
}

fn is_longer_than_a_screen(sheet: &Sheet) -> bool {
    sheet.to_text(terminal::width()).lines().count() > terminal::height()
}

/// How many claims, or cells of tables, have this verdict; for [`Word::Broken`], how many promises are
/// broken.
fn count(audit: &PaperAudit<'_>, verdict: Word) -> usize {
    if verdict == Word::Broken {
        return audit.promise_counts().broken;
    }
    let claims = audit.claims();
    let verdicts = claims.iter().flat_map(|claim| claim.verdicts.iter());
    verdicts.filter(|(word, _)| *word == verdict).map(|(_, count)| count).sum()
}
