//! What a kind of claim is to reports.

use crate::audit::{ByHand, Explanation, Finding, PaperAudit, Standing, Tally, Word, Working};
use crate::claim::{Claim, Kind};
use crate::diagnostic::Diagnostic;
use crate::report::html::context::Context;
use crate::report::html::sheet::{facts, lines};
use crate::report::json;
use crate::report::tables::eye::Eye;
use crate::report::words::sheet::Sheet;
use maud::{Markup, html};
use subcert_claims::with_kinds;

/// A finding of a kind as one of any kind.
pub(crate) trait Found<'a> {
    /// The finding.
    fn finding(&self) -> Finding<'_, 'a>;
}

/// Facts: names and texts.
pub(crate) type Facts = Vec<(String, String)>;

/// A finding of any kind in words, as JSON and on pages.
pub(crate) trait Told<'a>: Found<'a> {
    /// The heading of the claims of its kind, and its anchor on pages.
    fn heading(&self) -> [&'static str; 2];

    /// The claims that it is counted with; cells of tables are counted by themselves.
    fn counted(&self) -> Option<&'static Counted>;

    /// The verdict with its reasons, in lines.
    fn outcome(&self) -> String;

    /// What is stated.
    fn states(&self, audit: &PaperAudit<'_>) -> Facts;

    /// The claims of its JSON form: of a table, its cells.
    fn form<'s>(&'s self, audit: &'s PaperAudit<'_>) -> Vec<json::Claim<'s>>;

    /// Whether it is wrong with points at i/n^k, and not at their natural parameters.
    fn is_right_naturally(&self) -> bool {
        false
    }

    /// What else there is to say where it is shown in full.
    fn details(&self) -> Facts {
        Vec::new()
    }

    /// All of it.
    fn in_full(&self, sheet: &mut Sheet, audit: &PaperAudit<'_>, _: Background<'_>, _all: bool) {
        let word = self.word();
        let mut facts = self.states(audit);
        facts.push((format!("{} {word}", word.mark()), self.outcome()));
        facts.extend(self.details());
        facts.extend(self.claim().note().map(|note| ("note".to_owned(), note.to_owned())));
        sheet.facts(facts);
    }

    /// The lines below its title in the report of an audit.
    fn remarks(&self) -> Vec<String> {
        let note = self.claim().note().map(str::to_owned);
        [self.outcome()].into_iter().chain(note).collect()
    }

    /// Whether the report of an audit has it, also without `--all`.
    fn is_shown(&self) -> bool {
        self.word().standing() != Standing::Holds
    }

    /// What is wrong, and how it came about.
    fn erratum(&self) -> (Facts, Vec<String>) {
        let note = self.claim().note().map(str::to_owned);
        (vec![("verdict".to_owned(), self.outcome())], Vec::from_iter(note))
    }

    /// What is printed and what is exact, each in a line.
    fn difference(&self) -> [String; 2] {
        let outcome = self.outcome();
        [self.claim().title().to_owned(), outcome.lines().next().unwrap_or_default().to_owned()]
    }

    /// How what is printed came about.
    fn origin(&self) -> Option<String> {
        self.claim().note().map(str::to_owned)
    }

    /// Its contents on the page of a paper.
    ///
    /// # Errors
    /// When a formula of the claim file is wrong.
    fn contents(&self, context: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        Ok(html! { (facts(&self.states(context.audit))) p.outcome { (lines(&self.outcome())) } })
    }

    /// The claim.
    fn claim(&self) -> Claim<'a> {
        self.finding().claim()
    }

    /// The word for its verdict.
    fn word(&self) -> Word {
        self.finding().word().unwrap_or(Word::Open)
    }
}

/// The results, beyond those of the audit, that explain a claim.
#[derive(Clone, Copy, Debug, Default)]
pub struct Background<'e> {
    /// The readings of the claim's table, from [`crate::audit::readings`]; empty if it has none.
    pub readings: &'e [Explanation],
    /// The result of [`crate::audit::by_hand`] for a theorem.
    pub by_hand: Option<&'e ByHand>,
    /// The result of [`crate::audit::working`] for a cell.
    pub working: Option<&'e Working>,
    /// The result of [`to_the_eye`](crate::report::to_the_eye) for a cell.
    pub eye: Option<&'e Eye>,
}

/// Claims that are counted together.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Counted {
    /// What they are called.
    pub(crate) several: &'static str,
    /// One of them.
    pub(crate) one: &'static str,
    /// The heading of their column: a name, and the marks of their verdicts.
    pub(crate) column: &'static str,
    /// The verdict of a wrong one.
    pub(crate) wrong: Word,
    /// The words for it in the singular and in the plural.
    pub(crate) words: [&'static str; 2],
    /// Their place among all in the first sentence about a paper: those that weigh most come first.
    pub(crate) place: u8,
}

macro_rules! told {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $finding:ident $claim:ident,)*) => {
        /// A finding in words.
        pub(crate) fn told<'f, 'a>(finding: Finding<'f, 'a>) -> &'f (dyn Told<'a> + 'f) {
            match finding { $(Finding::$kind(finding) => finding,)* }
        }

        $(impl<'a> Found<'a> for crate::audit::$finding<'a> {
            fn finding(&self) -> Finding<'_, 'a> {
                Finding::$kind(self)
            }
        })*
    };
}

with_kinds!(told);

/// The claims of papers that are counted together, in the order of their kinds, and how many have each verdict.
pub(crate) fn counts(audits: &[PaperAudit<'_>]) -> Vec<(&'static Counted, Tally)> {
    let mut kinds: Vec<(Kind, &'static Counted, Tally)> = Vec::new();
    for finding in audits.iter().flat_map(PaperAudit::findings) {
        let Some(counted) = told(finding).counted() else { continue };
        match kinds.iter_mut().find(|(_, known, _)| *known == counted) {
            Some((_, _, tally)) => *tally += &finding.verdicts(),
            None => kinds.push((finding.claim().kind(), counted, finding.verdicts())),
        }
    }
    kinds.sort_by_key(|(kind, _, _)| *kind);
    kinds.into_iter().map(|(_, counted, tally)| (counted, tally)).collect()
}
