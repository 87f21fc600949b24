//! The arguments.

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;
use subcert::audit::Verdict;

const AFTER_HELP: &str = "\
SCHEME is a catalogue name with parameters (`six-point:w=3/256`, `newton:j=1,n=3`,
`doo-sabin:n=5`), the path of a TOML file (`mine.toml:w=1/16`), or two of these with
` x ` between them for their tensor product. `subcert schemes` lists the catalogue;
`range` needs a mask, the other commands also take the rings around an extraordinary
vertex or face.

Exit codes: 0 done (findings are no failures), 1 a stated expectation failed,
2 bad usage or input, 3 an internal fault.";

/// Exact constants of subdivision schemes, and audits of the papers that publish them.
#[derive(Debug, Parser)]
#[command(name = "subcert", version, after_help = AFTER_HELP, arg_required_else_help = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Judge every claim of papers: the embedded ones, or claim files
    Audit(AuditArguments),
    /// Show one claim, table or equation in full
    Explain(ExplainArguments),
    /// What is wrong in papers, as one could send it to a journal
    Errata(ErrataArguments),
    /// What papers number, and the claims that cover it
    Coverage(CoverageArguments),
    /// The exact constants of a scheme: difference mask, T_c, Λ_c, σ
    Constants(ConstantsArguments),
    /// The subdivision depth for a tolerance: exactly, soundly, and as papers compute it
    Depth(DepthArguments),
    /// Where in a parameter of the mask T_c < 1
    Range(RangeArguments),
    /// The f64 path of a scheme against the exact one
    Certify(CertifyArguments),
    /// Write certificates of the verdicts, for subcert-check
    Prove(ProveArguments),
    /// Write a claim file to start from, with comments
    New(NewArguments),
    /// Reference values for other programs' tests
    Oracle(OracleArguments),
    /// List the schemes of the catalogue
    Schemes(SchemesArguments),
    /// Write a completion script for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people
    Text,
    /// For programs
    Json,
    /// For pasting into a report
    Markdown,
}

/// How results are written.
#[derive(Debug, Args)]
pub(super) struct Output {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
}

/// How many levels at a time.
#[derive(Debug, Args)]
pub(super) struct Block {
    /// The greatest number of levels c
    #[arg(short = 'c', long = "levels", value_name = "MAX", default_value_t = 4,
          value_parser = clap::value_parser!(u32).range(1..=24))]
    pub(super) levels: u32,
}

/// How many levels at a time, where branch and bound finds the constants.
#[derive(Debug, Args)]
pub(super) struct DeepBlock {
    /// The greatest number of levels c
    #[arg(short = 'c', long = "levels", value_name = "MAX", default_value_t = 4,
          value_parser = clap::value_parser!(u32).range(1..=256))]
    pub(super) levels: u32,
}

/// How far neighbouring control points are apart.
#[derive(Debug, Args)]
pub(super) struct Spread {
    /// The spread β: the largest difference of neighbouring control points
    #[arg(long, value_name = "B", default_value = "1", allow_hyphen_values = true)]
    pub(super) spread: String,
}

#[derive(Debug, Args)]
pub(super) struct AuditArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(super) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(super) paper: Option<String>,
    /// Show every table and equation, also those where nothing is wrong
    #[arg(long)]
    pub(super) all: bool,
    /// Say of each claim whether its certificate is valid
    #[arg(long)]
    pub(super) certified: bool,
    /// Exit with code 1 when a claim has one of these verdicts, or a promise is `broken`
    #[arg(long, value_name = "VERDICT,…", value_delimiter = ',', value_parser = verdicts())]
    pub(super) deny: Vec<String>,
    #[command(flatten)]
    pub(super) output: Output,
}

/// The value of `--deny` for promises of tables that are not kept.
pub(super) const BROKEN: &str = "broken";

/// The verdicts of numbers, then those of equations, ranges and theorems, and of promises.
fn verdicts() -> PossibleValuesParser {
    let others = ["holds", "fails", "exact", "inexact", "proved", "open", BROKEN];
    PossibleValuesParser::new(Verdict::NAMES.into_iter().chain(others))
}

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// The id: `key:table-1`, `key:table-1:2:3` (row, column), `key:eq-3.8` or `key:theorem-1`;
    /// a key alone lists the claims of its paper
    pub(super) id: String,
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(super) files: Vec<PathBuf>,
    /// Show every reading that was tried
    #[arg(long)]
    pub(super) all: bool,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct ErrataArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(super) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(super) paper: Option<String>,
    /// Write one file for each paper into this folder, named by its key
    #[arg(short = 'o', long, value_name = "DIR")]
    pub(super) output_folder: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Markdown)]
    pub(super) format: Format,
}

#[derive(Debug, Args)]
pub(super) struct CoverageArguments {
    /// Claim files, `-` for the standard input; without any, the embedded papers
    pub(super) files: Vec<PathBuf>,
    /// Only the paper of this key
    #[arg(long, value_name = "KEY")]
    pub(super) paper: Option<String>,
    /// Exit with code 1 when an item is in one of these states
    #[arg(long, value_name = "STATE,…", value_delimiter = ',', value_parser = ["missing", "unclaimed"])]
    pub(super) deny: Vec<String>,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct NewArguments {
    /// The key of the paper, such as doe2026-corner: the ids of its claims begin with it
    #[arg(value_name = "KEY")]
    pub(super) key: String,
    /// The file to write, which must not be there yet; `-` for the standard output
    /// [default: KEY.toml]
    #[arg(short = 'o', long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct ProveArguments {
    /// Keys of embedded papers, and claim files, `-` for the standard input; without any, every
    /// embedded paper
    #[arg(value_name = "KEY|FILE")]
    pub(super) what: Vec<String>,
    /// The folder for the certificates KEY.cert; `-` for one paper to the standard output
    #[arg(short = 'o', long = "output", value_name = "DIR")]
    pub(super) output: PathBuf,
}

#[derive(Debug, Args)]
pub(super) struct ConstantsArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(super) scheme: String,
    #[command(flatten)]
    pub(super) block: DeepBlock,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct DepthArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(super) scheme: String,
    /// The tolerance ε, an exact number such as 1/1000 or 4.35e-5
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(super) tolerance: String,
    #[command(flatten)]
    pub(super) spread: Spread,
    /// A control polygon, for the depth that it needs: a file with one point on a line, its
    /// coordinates separated by commas or white space, or a JSON array of numbers or of
    /// points. β is its largest difference
    #[arg(long, value_name = "FILE", conflicts_with = "spread")]
    pub(super) polygon: Option<PathBuf>,
    /// What happens at its ends [default: closed]
    #[arg(long, value_enum, requires = "polygon")]
    pub(super) boundary: Option<BoundaryArgument>,
    /// How narrow the intervals around exact distances are [default: ε/1000]
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    pub(super) width: Option<String>,
    #[command(flatten)]
    pub(super) block: Block,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct RangeArguments {
    /// The scheme, without a value for the parameter
    #[arg(value_name = "SCHEME")]
    pub(super) scheme: String,
    /// The parameter, in which the mask is polynomial
    #[arg(long, value_name = "NAME")]
    pub(super) param: String,
    #[command(flatten)]
    pub(super) block: Block,
    /// Show T_c itself, a piecewise polynomial function of the parameter
    #[arg(long)]
    pub(super) function: bool,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct SchemesArguments {
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Debug, Args)]
pub(super) struct CertifyArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(super) scheme: String,
    #[command(flatten)]
    pub(super) block: Block,
    /// A tolerance ε for the depths (may be repeated)
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(super) tolerance: Vec<String>,
    /// The spread β of the depths: the largest difference of neighbouring control points
    /// [default: 1]
    #[arg(long, value_name = "B", allow_hyphen_values = true)]
    pub(super) spread: Option<String>,
    #[command(flatten)]
    pub(super) output: Output,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum OracleFormat {
    /// With a header object
    Json,
    /// With header lines that begin with `#`
    Csv,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum BoundaryArgument {
    /// The last point is followed by the first
    Closed,
    /// Only rules whose points all exist are applied
    Open,
}

#[derive(Debug, Args)]
pub(super) struct OracleArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(super) scheme: String,
    /// How many times the control polygon is refined
    #[arg(long, value_name = "K", default_value_t = 2)]
    pub(super) level: u32,
    #[command(flatten)]
    pub(super) block: Block,
    /// A control polygon: a file with one point on a line, its coordinates separated by commas or
    /// white space, or a JSON array of numbers or of points, as `depth` reads it; for a surface, a
    /// grid of numbers, one row on a line; for a ring, one line for each of its points
    #[arg(long, value_name = "FILE", conflicts_with_all = ["seed", "points"])]
    pub(super) polygon: Option<std::path::PathBuf>,
    /// The seed of a control polygon of small integers
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub(super) seed: u64,
    /// How many points that polygon has; a surface, in each direction; not of a ring
    /// [default: 8]
    #[arg(long, value_name = "M")]
    pub(super) points: Option<usize>,
    /// What happens at the ends; not of a ring [default: closed]
    #[arg(long, value_enum)]
    pub(super) boundary: Option<BoundaryArgument>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OracleFormat::Json)]
    pub(super) format: OracleFormat,
}
