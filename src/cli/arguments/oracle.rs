//! The arguments of `oracle`.

use super::meshes::{ClosedArgument, Weld};
use super::schemes::{AnyBoundary, Block, count};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use subcert::spectrum::table::Language;

/// A seed.
fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| "a seed is a whole number from 0 to 2^64 − 1".to_owned())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum OracleFormat {
    /// With a header object
    Json,
    /// With header lines that begin with `#`
    Csv,
    /// CSV without header lines, as `readtable` of MATLAB, pandas and spreadsheets take it
    Table,
    /// A function of MATLAB and Octave that tests an implementation
    Matlab,
    /// Arrays in C99 (.c, .h): input, expected values, units in the last place; exact values are comments
    C,
    /// The same in Rust (.rs)
    Rust,
}

impl OracleFormat {
    /// The language of its arrays.
    pub(in crate::cli) fn language(self) -> Option<Language> {
        match self {
            OracleFormat::C => Some(Language::C),
            OracleFormat::Rust => Some(Language::Rust),
            OracleFormat::Json | OracleFormat::Csv | OracleFormat::Table | OracleFormat::Matlab => {
                None
            }
        }
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct OracleArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// How many times the control polygon or the mesh is refined
    #[arg(long, value_name = "K", default_value_t = 2, allow_negative_numbers = true)]
    pub(in crate::cli) level: u32,
    #[command(flatten)]
    pub(in crate::cli) block: Block,
    /// A control polygon: a file with one point on a line, its coordinates separated by commas or
    /// white space, `#` before a comment, or a JSON array of numbers or of points, as `depth` reads it; for a surface, a
    /// grid of numbers, one row on a line; for a ring, one line for each of its points. An empty cell is an error
    /// [default: a polygon of small integers, see --seed]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["seed", "points"])]
    pub(in crate::cli) polygon: Option<std::path::PathBuf>,
    /// A polygon mesh in place of a polygon, as OBJ, OFF, PLY, STL, USD or VTK, a tensor net as CSV or JSON, or a solid
    /// as VTK or MEDIT (bajaj); `-` for the standard input: its refinement, limit points, and for a polygon mesh unit normals,
    /// in all formats but matlab; points and faces are numbered from 0
    #[arg(long, value_name = "FILE", conflicts_with_all = ["polygon", "seed", "points"])]
    pub(in crate::cli) mesh: Option<PathBuf>,
    /// The directions in which a net is closed [default: those in the file, or else none]
    #[arg(long, value_enum, requires = "mesh")]
    pub(in crate::cli) closed: Option<ClosedArgument>,
    #[command(flatten)]
    pub(in crate::cli) weld: Weld,
    /// The seed of a control polygon of small integers, from 0 to 2^64 − 1
    #[arg(long, value_name = "S", default_value_t = 1, allow_negative_numbers = true,
          value_parser = seed)]
    pub(in crate::cli) seed: u64,
    /// How many points that polygon has; a surface, in each direction; not for a ring
    /// [default: 8]
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = count)]
    pub(in crate::cli) points: Option<usize>,
    /// What happens at the ends of a control polygon, not of a ring [default: closed], or the rules at the boundary of a polygon
    /// mesh [default: those in the file, or else edge]
    #[arg(long, value_enum)]
    pub(in crate::cli) boundary: Option<AnyBoundary>,
    /// Output format; without it, the ending of the file decides
    #[arg(long, value_enum, default_value_t = OracleFormat::Json)]
    pub(in crate::cli) format: OracleFormat,
    /// The file for the values [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE")]
    pub(in crate::cli) file: Option<PathBuf>,
}
