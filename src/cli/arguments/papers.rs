//! The arguments of the commands about papers.

use super::{FindingFormat, FindingOutput, Output};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use subcert::audit::{CoverageState, Word};
use subcert::shipped::Outcome;

#[derive(Debug, Args)]
pub(in crate::cli) struct AuditArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(in crate::cli) paper: Option<String>,
    /// Show the whole report of the embedded papers; without it, the findings of each that do most harm
    #[arg(long)]
    pub(in crate::cli) full: bool,
    /// Show every table and equation, also those where nothing is wrong
    #[arg(long)]
    pub(in crate::cli) all: bool,
    /// Say for each claim whether its certificate is valid
    #[arg(long)]
    pub(in crate::cli) certified: bool,
    /// Exit with code 1 when a claim has one of these verdicts, explained below, or a promise is `broken`
    #[arg(long, value_name = "VERDICT,…", value_delimiter = ',', value_parser = verdicts())]
    pub(in crate::cli) deny: Vec<Word>,
    /// Output format; without it, the ending of the file decides
    #[arg(long, value_enum, default_value_t = FindingFormat::Text)]
    pub(in crate::cli) format: FindingFormat,
    /// The file for the results; for `--format html` the folder for a page of each paper, KEY.html, and
    /// index.html [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE|DIR")]
    pub(in crate::cli) file: Option<PathBuf>,
}

/// Whether this is said of claims of papers, and of promises that are broken.
pub(in crate::cli) const fn is_of_papers(verdict: Word) -> bool {
    match verdict {
        Word::Confirmed
        | Word::Reproduced
        | Word::Rounding
        | Word::Misprint
        | Word::OtherReading
        | Word::Refuted
        | Word::NotCheckable
        | Word::Holds
        | Word::Fails
        | Word::Exact
        | Word::Inexact
        | Word::Proved
        | Word::Open
        | Word::Broken => true,
        Word::Kept | Word::Nearest | Word::Cut | Word::Ulps | Word::Otherwise => false,
    }
}

/// The verdicts of claims of papers, then those of constants that programs ship.
fn verdicts() -> impl TypedValueParser<Value = Word> {
    let of_papers = Word::ALL.iter().copied().filter(|word| is_of_papers(*word));
    let shipped = Outcome::ALL.map(Outcome::word).into_iter().filter(|word| !is_of_papers(*word));
    one_of(of_papers.chain(shipped).collect(), Word::name)
}

/// The states of items that are missed.
fn states() -> impl TypedValueParser<Value = CoverageState> {
    one_of(vec![CoverageState::Missing, CoverageState::Unclaimed], CoverageState::name)
}

/// One of these, by its name.
fn one_of<T>(all: Vec<T>, name: fn(T) -> &'static str) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let names = PossibleValuesParser::new(all.iter().map(|one| name(*one)));
    names.map(move |text| {
        let named = all.iter().find(|one| name(**one) == text);
        *named.expect("clap takes no other name")
    })
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExplainArguments {
    /// The id: `key:table-1`, `key:table-1:2:3` (row, column), `key:eq-3.8` or `key:theorem-1`;
    /// a key alone lists the claims of its paper. With the claim file of one paper, `key:` may be left out
    pub(in crate::cli) id: String,
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Show every reading that was tried
    #[arg(long)]
    pub(in crate::cli) all: bool,
    #[command(flatten)]
    pub(in crate::cli) output: FindingOutput,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ErrataArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(in crate::cli) paper: Option<String>,
    /// One table for all papers: where they and the exact values differ, the worst first
    #[arg(long, conflicts_with = "output_folder")]
    pub(in crate::cli) together: bool,
    /// Write one file for each paper into this folder, named by its key
    #[arg(short = 'o', long = "output", alias = "output-folder", value_name = "DIR")]
    pub(in crate::cli) output_folder: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = ErrataFormat::Markdown)]
    pub(in crate::cli) format: ErrataFormat,
}

/// The formats of errata.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ErrataFormat {
    /// For people
    Text,
    /// For programs
    Json,
    /// For pasting into a report
    Markdown,
    /// For spreadsheets
    Csv,
    /// A document of its own, of the class article
    Latex,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct CoverageArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(in crate::cli) paper: Option<String>,
    /// Exit with code 1 when an item is in one of these states
    #[arg(long, value_name = "STATE,…", value_delimiter = ',', value_parser = states())]
    pub(in crate::cli) deny: Vec<CoverageState>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ProveArguments {
    /// Keys of embedded papers, and claim files, `-` for the standard input; without any, all
    /// embedded papers
    #[arg(value_name = "KEY|FILE")]
    pub(in crate::cli) what: Vec<String>,
    /// The folder for the certificates KEY.cert; `-` for one paper to the standard output
    #[arg(short = 'o', long = "output", value_name = "DIR", required_unless_present = "coq")]
    pub(in crate::cli) output: Option<PathBuf>,
    /// The folder for theorems of Coq, KEY/CLAIM.v, which need the library in proofs/coq
    #[arg(long, value_name = "DIR")]
    pub(in crate::cli) coq: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct NewArguments {
    /// The key of the paper, such as doe2026-corner: the ids of its claims begin with it; that of a
    /// paper that comes with the program gives the claim file of this paper
    #[arg(value_name = "KEY")]
    pub(in crate::cli) key: String,
    /// The file to write, which must not exist; `-` for the standard output
    /// [default: KEY.toml]
    #[arg(short = 'o', long, value_name = "FILE")]
    pub(in crate::cli) output: Option<PathBuf>,
}
