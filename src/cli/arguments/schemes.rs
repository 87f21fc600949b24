//! The arguments of the commands about schemes.

use super::meshes::{ClosedArgument, MeshBoundary, Weld};
use super::{FindingFormat, FindingOutput, Output, Valences};
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use subcert::bound::{MAX_CLASSES, MAX_LEVELS};
use subcert::lattice::MAP_BOXES;
use subcert::smoothness::MAX_BOXES;

/// How many there are of something.
pub(super) fn count(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "this is not a whole number from 0 on".to_owned())
}

/// How many boxes of two parameters are examined unless another number is asked for.
pub(in crate::cli) const BOXES: usize = 1_000;

/// Other names of `--tolerance`.
const TOLERANCE: [&str; 3] = ["tol", "eps", "epsilon"];

/// The most levels where classes are visited one by one: a binary scheme has so many then.
const FEW_LEVELS: u32 = MAX_CLASSES.ilog2();

/// What `-c` is.
fn levels(most: u32) -> String {
    format!("The greatest number of levels c, up to {most}")
}

/// How many levels at a time.
#[derive(Debug, Args)]
pub(in crate::cli) struct Block {
    #[arg(short = 'c', long = "levels", value_name = "MAX", default_value_t = 4, allow_negative_numbers = true,
          help = levels(FEW_LEVELS), value_parser = clap::value_parser!(u32).range(1..=i64::from(FEW_LEVELS)))]
    pub(in crate::cli) levels: u32,
}

/// How many levels at a time, where branch and bound finds the constants.
#[derive(Debug, Args)]
pub(in crate::cli) struct DeepBlock {
    #[arg(short = 'c', long = "levels", value_name = "MAX", default_value_t = 4, allow_negative_numbers = true,
          help = levels(MAX_LEVELS), value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_LEVELS)))]
    pub(in crate::cli) levels: u32,
}

/// How far neighbouring control points are apart.
#[derive(Debug, Args)]
pub(in crate::cli) struct Spread {
    /// The spread β: the largest difference of neighbouring control points
    #[arg(long, alias = "beta", value_name = "B", default_value = "1", allow_hyphen_values = true)]
    pub(in crate::cli) spread: String,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ConstantsArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    #[command(flatten)]
    pub(in crate::cli) block: DeepBlock,
    /// Add the constants of papers that read the masks forwards. They bound nothing
    #[arg(long)]
    pub(in crate::cli) forward: bool,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct DepthArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The tolerance ε in the unit of the coordinates, an exact number such as 1/1000 or 4.35e-5; with --relative a share of the
    /// diagonal
    #[arg(long, aliases = TOLERANCE, value_name = "E", allow_hyphen_values = true)]
    pub(in crate::cli) tolerance: String,
    #[command(flatten)]
    pub(in crate::cli) spread: Spread,
    /// A control polygon, for the depth that it needs: a file with one point on a line, its
    /// coordinates separated by commas or white space, `#` before a comment, or a JSON array of numbers or of
    /// points, such as [[0, "1/3"], [1, 0.5]]; an empty cell is an error. A closed polygon does not have its first point again at the
    /// end. β is its largest difference
    #[arg(long, value_name = "FILE", conflicts_with = "spread")]
    pub(in crate::cli) polygon: Option<PathBuf>,
    /// What happens at the ends of a control polygon [default: closed], or the rules at the boundary of a polygon mesh
    /// [default: those in the file, or else edge]
    #[arg(long, value_enum)]
    pub(in crate::cli) boundary: Option<AnyBoundary>,
    /// A polygon mesh as OBJ, OFF, PLY, STL, USD (usda) or VTK, a tensor net as CSV or JSON, or a solid as VTK or MEDIT
    /// (ascii), for the depth that it needs; `-` for the standard input. The scheme is catmull-clark,
    /// doo-sabin, loop, or loop-warren; for a net a curve, or two with ` x ` between them; for a solid
    /// bajaj
    #[arg(long, value_name = "FILE", conflicts_with_all = ["spread", "polygon", "width", "levels"])]
    pub(in crate::cli) mesh: Option<PathBuf>,
    /// The directions in which a net is closed [default: those in the file, or else none]
    #[arg(long, value_enum, requires = "mesh")]
    pub(in crate::cli) closed: Option<ClosedArgument>,
    #[command(flatten)]
    pub(in crate::cli) weld: Weld,
    /// Compute only what the longest edge and the valences of the mesh guarantee
    #[arg(long, requires = "mesh")]
    pub(in crate::cli) a_priori: bool,
    /// Write the distance of every face of the mesh at the level found, and its own least level where the
    /// distance is that of sets: .csv, .json, or .ply with colours; faces are numbered from 0
    #[arg(long, value_name = "FILE", requires = "mesh", conflicts_with = "a_priori")]
    pub(in crate::cli) per_face: Option<PathBuf>,
    /// How the distance from the limit is measured: as sets of points, which for a solid is that of its boundary, or at equal
    /// parameters, which for a solid is that of all its cells [default: as sets of points, and for a polygon of points both]
    #[arg(long, value_enum)]
    pub(in crate::cli) distance: Option<DistanceArgument>,
    /// What a face of a polygon mesh is between its vertices; triangles are flat
    #[arg(long, value_enum, default_value_t = FacesArgument::Bilinear, requires = "mesh")]
    pub(in crate::cli) faces: FacesArgument,
    /// Write a certificate of the depth of a control polygon or a net as a set of points, for subcert-check --depth
    #[arg(long, value_name = "FILE", conflicts_with = "a_priori")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    /// The tolerance is a share of the diagonal of the box around the mesh, the net, the solid or the control polygon
    #[arg(long)]
    pub(in crate::cli) relative: bool,
    /// The greatest width of the intervals around exact distances, in the unit of ε [default: ε/1000]
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    pub(in crate::cli) width: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) block: Block,
    #[command(flatten)]
    pub(in crate::cli) output: FindingOutput,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct RangeArguments {
    /// The scheme, without a value for the parameter: a mask, or with `--smoothness 1` rules around a vertex or on a
    /// face, where the statement is about surfaces with generic data
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The parameter, in which the mask is polynomial, if the scheme has several; two of them, with
    /// `--smoothness`, for a map
    #[arg(value_name = "PARAM", conflicts_with = "param")]
    pub(in crate::cli) names: Vec<String>,
    /// The same as PARAM
    #[arg(long, aliases = ["parameter", "params", "parameters"], value_name = "NAME")]
    pub(in crate::cli) param: Vec<String>,
    #[command(flatten)]
    pub(in crate::cli) block: Block,
    /// Where the limits are C^M, and where they are not, in place of T_c < 1
    #[arg(long, alias = "continuity", value_name = "M", conflicts_with = "function", allow_negative_numbers = true, value_parser = count)]
    pub(in crate::cli) smoothness: Option<usize>,
    /// Rules around a vertex or on a face, with `--smoothness 1`: the valences [default: as in SCHEME]
    #[arg(long, alias = "valence", value_name = "FIRST..LAST", value_parser = super::smoothness::valences, requires = "smoothness")]
    pub(in crate::cli) valences: Option<Valences>,
    /// The values for which the Hölder exponent is greatest, or T_c is least, of one parameter or two
    #[arg(long, value_enum, value_name = "WHAT", conflicts_with_all = ["smoothness", "function", "valences"])]
    pub(in crate::cli) best: Option<BestArgument>,
    /// The region of `--best`, or of a map of two parameters, such as a=-1..1,b=0..1/2 [default: from -1 to 1]
    #[arg(long, aliases = ["box", "region"], value_name = "BOX", allow_hyphen_values = true)]
    pub(in crate::cli) bounds: Option<String>,
    #[arg(long, value_name = "N",
          help = format!("The number of boxes to examine for a map, or for the best exponent, up to {MAX_BOXES} [default: {BOXES}, and {MAP_BOXES} of masks on Z^d]"))]
    pub(in crate::cli) boxes: Option<usize>,
    /// Show T_c itself, a piecewise polynomial function of the parameter
    #[arg(long)]
    pub(in crate::cli) function: bool,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct CertifyArguments {
    /// The scheme
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    #[command(flatten)]
    pub(in crate::cli) block: Block,
    /// A tolerance ε for the depth by a formula, the least k with σβCᵏ/(1 − C) ≤ ε (may be repeated)
    #[arg(long, aliases = TOLERANCE, value_name = "E", allow_hyphen_values = true)]
    pub(in crate::cli) tolerance: Vec<String>,
    /// The spread β in that formula: the largest difference of neighbouring control points
    /// [default: 1]
    #[arg(long, alias = "beta", value_name = "B", allow_hyphen_values = true)]
    pub(in crate::cli) spread: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum BestArgument {
    /// The Hölder exponent
    Exponent,
    /// T_c, with the c of `--levels`
    Contraction,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DistanceArgument {
    /// The Hausdorff distance between the mesh or the polygon and the limit, from both sides
    Geometric,
    /// The greatest distance between points with equal parameters
    Parametric,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum FacesArgument {
    /// Quadrilaterals are bilinear, larger faces are fans of triangles from their centroids
    Bilinear,
    /// All but triangles are fans of triangles from their centroids
    Fan,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum BoundaryArgument {
    /// The last point is followed by the first
    Closed,
    /// Only rules whose points all exist are applied
    Open,
}

/// The boundary of a control polygon or of a polygon mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) enum AnyBoundary {
    Polygon(BoundaryArgument),
    Mesh(MeshBoundary),
}

impl AnyBoundary {
    /// The rules at the boundary of a polygon mesh.
    pub(in crate::cli) fn of_mesh(self) -> Option<MeshBoundary> {
        match self {
            AnyBoundary::Polygon(_) => None,
            AnyBoundary::Mesh(boundary) => Some(boundary),
        }
    }
}

impl ValueEnum for AnyBoundary {
    fn value_variants<'a>() -> &'a [AnyBoundary] {
        &[
            AnyBoundary::Polygon(BoundaryArgument::Closed),
            AnyBoundary::Polygon(BoundaryArgument::Open),
            AnyBoundary::Mesh(MeshBoundary::None),
            AnyBoundary::Mesh(MeshBoundary::Edge),
            AnyBoundary::Mesh(MeshBoundary::Corner),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            AnyBoundary::Polygon(boundary) => boundary.to_possible_value(),
            AnyBoundary::Mesh(boundary) => boundary.to_possible_value(),
        }
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SchemesArguments {
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SchemeArguments {
    /// The scheme: a mask, or rules around a vertex or on a face; rules without a valence are examined at 3 to 12. Several
    /// schemes of one kind stand side by side
    #[arg(value_name = "SCHEME", required = true)]
    pub(in crate::cli) schemes: Vec<String>,
    #[command(flatten)]
    pub(in crate::cli) output: FindingOutput,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotArguments {
    /// The scheme: a mask, also one with one or two parameters without a value; or rules around a vertex or on a face; rules
    /// without a valence are drawn at 3, 5 and 7
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The region of two parameters without a value, such as a=-1..1,b=0..1/2 [default: from -1 to 1]
    #[arg(long, aliases = ["box", "region"], value_name = "BOX", allow_hyphen_values = true)]
    pub(in crate::cli) bounds: Option<String>,
    /// The file for the picture [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE")]
    pub(in crate::cli) file: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct AtlasArguments {
    /// Schemes, also your own [default: those of the catalogue]
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) names: Vec<String>,
    /// A claim file (may be repeated): with `--format html`, the pages of schemes link to what it says of them, on the page
    /// of its audit
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub(in crate::cli) claims: Vec<PathBuf>,
    /// Output format; without it, the ending of the file decides
    #[arg(long, value_enum, default_value_t = FindingFormat::Text)]
    pub(in crate::cli) format: FindingFormat,
    /// The file for the results; for `--format html` the folder for a page of each scheme, NAME.html, and index.html
    /// [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE|DIR")]
    pub(in crate::cli) file: Option<PathBuf>,
}
