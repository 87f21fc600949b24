//! The arguments of the commands about meshes.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The forms in which meshes are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum MeshOutputFormat {
    /// The nearest f64 of each coordinate, as shortest decimals, and with `limit` unit normals; points are numbered from 1
    Obj,
    /// The same without normals; points are numbered from 0
    Off,
    /// The same
    Ply,
    /// The same, as triangles with points of their own: a face of n vertices is n − 2 of them, with its first vertex
    Stl,
    /// The same, with creases, corners, holes and texture coordinates, as OBJ and JSON have them too
    Usda,
    /// The same, for a solid
    Vtk,
    /// The same, for a solid; points are numbered from 1
    Medit,
    /// Exact numbers and the nearest f64, and with `limit` exact normals; points and faces are numbered from 0
    Json,
    /// The nearest f64 of each coordinate; for nets only
    Csv,
}

/// The rules at the boundary of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum MeshBoundary {
    /// Faces at the boundary are holes
    None,
    /// The B-spline of the boundary polygon
    Edge,
    /// The same, with a corner at each vertex of one face
    Corner,
}

/// Points of a polygon mesh that no face has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum IsolatedArgument {
    /// They are left out
    Drop,
    /// They are written after the other points, as they are
    Keep,
}

/// The closed directions of a net.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ClosedArgument {
    /// Neither
    None,
    /// From row to row: the last row is followed by the first
    U,
    /// Along the rows: the last point of a row is followed by its first
    V,
    /// Both
    Uv,
}

/// Which points of a mesh are joined.
#[derive(Debug, Args)]
pub(in crate::cli) struct Weld {
    /// Join points of a polygon mesh at most so far apart, in the unit of the coordinates, and those that a chain of such steps
    /// connects; for 0, and without a number, only equal ones: --weld=1e-6, or --weld [default: none are joined]
    #[arg(id = "weld", long = "weld", value_name = "TOLERANCE", num_args = 0..=1, default_missing_value = "0",
          require_equals = true, requires = "mesh")]
    pub(in crate::cli) tolerance: Option<String>,
}

impl Weld {
    /// Whether it is given, and its name.
    pub(in crate::cli) fn given(&self) -> (bool, &'static str) {
        (self.tolerance.is_some(), "--weld")
    }
}

/// Where and how a mesh is written.
#[derive(Debug, Args)]
pub(in crate::cli) struct MeshOutput {
    /// The file [default: the standard output]
    #[arg(short = 'o', long = "output", value_name = "FILE")]
    pub(in crate::cli) file: Option<PathBuf>,
    /// Output format [default: by the extension of FILE, or obj, for a solid vtk]
    #[arg(long, value_enum)]
    pub(in crate::cli) format: Option<MeshOutputFormat>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct RefineArguments {
    /// The scheme: catmull-clark, doo-sabin, loop, or loop-warren; for a net a curve, or two with ` x `
    /// between them; bajaj for a solid
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The control mesh as OBJ, OFF, PLY, STL, USD (usda), or VTK or MEDIT polygons, a tensor net as CSV or JSON, or
    /// a solid as VTK or MEDIT (ascii); `-` for the standard input
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) mesh: PathBuf,
    /// The directions in which a net is closed [default: those in the file, or else none]
    #[arg(long, value_enum)]
    pub(in crate::cli) closed: Option<ClosedArgument>,
    /// The rules at the boundary of a polygon mesh [default: those in the file, or else edge]
    #[arg(long, value_enum)]
    pub(in crate::cli) boundary: Option<MeshBoundary>,
    /// What becomes of the points of a polygon mesh that belong to no face [default: drop]
    #[arg(long, value_enum)]
    pub(in crate::cli) isolated: Option<IsolatedArgument>,
    #[command(flatten)]
    pub(in crate::cli) weld: Weld,
    /// How many times the mesh is refined
    #[arg(long, value_name = "K", default_value_t = 1, allow_negative_numbers = true)]
    pub(in crate::cli) level: u32,
    #[command(flatten)]
    pub(in crate::cli) output: MeshOutput,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct LimitArguments {
    /// The scheme: catmull-clark, doo-sabin, loop, or loop-warren; for a net a curve, or two with ` x `
    /// between them; bajaj for a solid
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The control mesh as OBJ, OFF, PLY, STL, USD (usda), or VTK or MEDIT polygons, a tensor net as CSV or JSON, or
    /// a solid as VTK or MEDIT (ascii); `-` for the standard input
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) mesh: PathBuf,
    /// The directions in which a net is closed [default: those in the file, or else none]
    #[arg(long, value_enum)]
    pub(in crate::cli) closed: Option<ClosedArgument>,
    /// The rules at the boundary of a polygon mesh [default: those in the file, or else edge]
    #[arg(long, value_enum)]
    pub(in crate::cli) boundary: Option<MeshBoundary>,
    /// What becomes of the points of a polygon mesh that belong to no face [default: drop]
    #[arg(long, value_enum)]
    pub(in crate::cli) isolated: Option<IsolatedArgument>,
    #[command(flatten)]
    pub(in crate::cli) weld: Weld,
    /// How many times the mesh is refined before its limit points are computed
    #[arg(long, value_name = "K", default_value_t = 0, allow_negative_numbers = true)]
    pub(in crate::cli) level: u32,
    #[command(flatten)]
    pub(in crate::cli) output: MeshOutput,
}
