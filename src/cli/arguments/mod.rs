//! The arguments.

mod examples;
mod findings;
mod groups;
mod hints;
mod meshes;
mod oracle;
mod papers;
mod schemes;
mod smoothness;
mod spectrum;
mod time;

use clap::{Args, Parser, Subcommand, ValueEnum};
pub(super) use findings::{FindingFormat, FindingOutput};
pub(super) use groups::grouped;
pub(super) use hints::{with_hint, with_masks};
pub(super) use meshes::{
    ClosedArgument, IsolatedArgument, LimitArguments, MeshBoundary, MeshOutput, MeshOutputFormat,
    RefineArguments,
};
pub(super) use oracle::{OracleArguments, OracleFormat};
pub(super) use papers::{
    AuditArguments, CoverageArguments, ErrataArguments, ErrataFormat, ExplainArguments,
    NewArguments, ProveArguments, is_of_papers,
};
pub(super) use schemes::{
    AnyBoundary, AtlasArguments, BOXES, BestArgument, BoundaryArgument, CertifyArguments,
    ConstantsArguments, DepthArguments, DistanceArgument, FacesArgument, PlotArguments,
    RangeArguments, SchemeArguments, SchemesArguments,
};
pub(super) use smoothness::{JsrArguments, SmoothnessArguments, Valences};
pub(super) use spectrum::{SpectrumArguments, TableArguments};
use std::path::PathBuf;

const AFTER_HELP: &str = "\
SCHEME is a name from the catalogue with parameters (`six-point:w=3/256`, `newton:j=1,n=3`), a
mask (`'[1, 3, 3, 1]/4'`), the path of a TOML file (`mine.toml:w=1/16`), or two of these with
` x ` between them for their tensor product. Names such as `doo-sabin:n=5` stand for the rules
around an extraordinary vertex or on a face. `subcert schemes` lists the catalogue.

Exit codes: 0 done, whatever was found; 1 a verdict or a state that --deny names; 2 bad usage or
input, or too little time (--seconds); 3 an internal fault.";

/// Exact constants of subdivision schemes, and audits of the papers that publish them.
#[derive(Debug, Parser)]
#[command(name = "subcert", version, after_help = AFTER_HELP, arg_required_else_help = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
    /// When to write colours; `auto` writes them to terminals only
    #[arg(long, global = true, value_enum, default_value_t = Colour::Auto, value_name = "WHEN")]
    pub(super) color: Colour,
    /// Write no results to the standard output and show no progress: only errors, files and the exit
    /// code
    #[arg(short, long, global = true)]
    pub(super) quiet: bool,
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u32).range(1..),
          help = seconds_help())]
    pub(super) seconds: Option<u32>,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Judge every claim of papers: the embedded ones, or claim files
    #[command(after_help = examples::AUDIT)]
    Audit(AuditArguments),
    /// Show one claim, table or equation in full
    #[command(after_help = examples::EXPLAIN)]
    Explain(ExplainArguments),
    /// Write errata, ready to send to a journal
    #[command(after_help = examples::ERRATA)]
    Errata(ErrataArguments),
    /// The numbered items of a paper, and which claims cover them
    #[command(after_help = examples::COVERAGE)]
    Coverage(CoverageArguments),
    /// The exact constants of a scheme: difference mask, T_c, Λ_c, σ
    #[command(after_help = examples::CONSTANTS)]
    Constants(ConstantsArguments),
    /// The subdivision depth for a tolerance: exactly, soundly, and as papers compute it
    #[command(after_help = examples::DEPTH)]
    Depth(DepthArguments),
    /// Find the values of a parameter with T_c < 1, or for which the limits are Cᵐ
    #[command(after_help = examples::RANGE)]
    Range(RangeArguments),
    /// How smooth the limits of a scheme are: Cᵐ, and the Hölder exponent from both sides
    #[command(after_help = examples::SMOOTHNESS)]
    Smoothness(SmoothnessArguments),
    /// The eigenvalues of the rules around a vertex or on a face, exactly, and the stencils of limits and
    /// tangents
    #[command(after_help = examples::SPECTRUM)]
    Spectrum(SpectrumArguments),
    /// Weights and stencils by valence as source code, correctly rounded
    #[command(after_help = examples::TABLE)]
    Table(TableArguments),
    /// The joint spectral radius of matrices, from both sides
    #[command(after_help = examples::JSR)]
    Jsr(JsrArguments),
    /// Compare the constants of a scheme in f64 with the exact ones
    #[command(after_help = examples::CERTIFY)]
    Certify(CertifyArguments),
    /// Write certificates of the verdicts, for subcert-check
    #[command(after_help = examples::PROVE)]
    Prove(ProveArguments),
    /// Write a claim file to start from, with comments
    #[command(after_help = examples::NEW)]
    New(NewArguments),
    /// Reference values for other programs' tests
    #[command(after_help = examples::ORACLE)]
    Oracle(OracleArguments),
    /// Refine a polygon mesh, a net or a solid exactly
    #[command(after_help = examples::REFINE)]
    Refine(RefineArguments),
    /// The limit points of the vertices of a mesh, a net or a solid, and the normals of a limit surface
    #[command(after_help = examples::LIMIT)]
    Limit(LimitArguments),
    /// List the schemes of the catalogue
    #[command(after_help = examples::SCHEMES)]
    Schemes(SchemesArguments),
    /// All facts of one scheme: polynomials, smoothness, constants, depths, values of the limit
    #[command(after_help = examples::SCHEME)]
    Scheme(SchemeArguments),
    /// The facts of all schemes of the catalogue at once
    #[command(after_help = examples::ATLAS)]
    Atlas(AtlasArguments),
    /// The pictures of one scheme as SVG: basic limit function and derivatives, a refined polygon, the
    /// parameters for which it is smooth, characteristic rings
    #[command(after_help = examples::PLOT)]
    Plot(PlotArguments),
    /// Open a page that does all of this, on this machine alone
    #[cfg(not(target_family = "wasm"))]
    #[command(after_help = examples::SERVE)]
    Serve(ServeArguments),
    /// Write a completion script for a shell
    #[command(after_help = examples::COMPLETIONS)]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Which command takes which flags
    #[command(hide = true)]
    Flags(Output),
    /// Write the JSON schemas of all answers
    #[cfg(feature = "schema")]
    #[command(hide = true)]
    Schemas {
        /// The folder for a file for each form
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
    /// Write man pages
    #[command(after_help = examples::MAN)]
    Man {
        /// The folder for subcert.1 and the pages of the commands, made if it is missing
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
}

/// The server of the page.
#[cfg(not(target_family = "wasm"))]
#[derive(Debug, clap::Args)]
pub(super) struct ServeArguments {
    /// The port on 127.0.0.1; 0 for any that is free
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub(super) port: u16,
    /// Print the address, and open no browser
    #[arg(long)]
    pub(super) no_open: bool,
}

/// When to write colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Colour {
    /// To terminals
    Auto,
    /// Also to files and pipes
    Always,
    /// Not at all
    Never,
}

/// The formats of what is written to the standard output, or into a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people
    Text,
    /// For programs
    Json,
    /// For pasting into a report
    Markdown,
    /// For spreadsheets
    Csv,
    /// Tables for a paper, with the packages amssymb and booktabs
    Latex,
}

impl Format {
    /// That of the same name, if there is one.
    pub(super) fn named(other: &impl ValueEnum) -> Option<Format> {
        Format::from_str(other.to_possible_value()?.get_name(), false).ok()
    }
}

/// How results are written. Every command that answers with a report takes these flags.
#[derive(Clone, Debug, PartialEq, Eq, Args)]
pub(super) struct Output {
    /// Output format; without it, the ending of the file decides
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    /// The file for the results [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE")]
    pub(super) file: Option<PathBuf>,
}

/// The seconds of a command that answers about one scheme, one set of matrices or one mesh.
const SECONDS: u32 = 60;

/// What `--seconds` is, for help texts.
fn seconds_help() -> String {
    format!(
        "End after so many seconds: print what is proved by then, or, where a part is no answer, an error that says what \
         takes less time [default: {SECONDS}; none for commands about papers, `oracle` and `atlas`]"
    )
}
