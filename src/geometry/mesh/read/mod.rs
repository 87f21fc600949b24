//! Mesh files. Numbers are read from their text, exactly.

mod assemble;
mod binary;
mod file;
mod lines;
mod medit;
mod obj;
mod off;
mod ply;
mod stl;
mod tags;
mod usd;
mod vtk;
mod weld;
mod words;

pub use file::MeshFile;

pub(crate) use assemble::{Denominator, Parts};
pub(crate) use file::{About, Places};
pub(crate) use medit::{Medit, medit};
pub(crate) use vtk::{vtk_cell, vtk_solid};

use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::path::Path;
use std::sync::Arc;

/// The largest file that is read, in bytes.
pub const MAX_FILE_BYTES: u64 = 64 << 20;

/// The forms of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Wavefront OBJ.
    Obj,
    /// OFF, ascii.
    Off,
    /// PLY, ascii or binary.
    Ply,
    /// STL, ascii or binary.
    Stl,
    /// USD, ascii.
    Usda,
    /// Legacy VTK, ascii, of polygons.
    Vtk,
    /// MEDIT `.mesh`, ascii, of triangles and quadrilaterals.
    Medit,
}

impl MeshFormat {
    /// The form of a file: by its extension, or else by how its text begins; OBJ when neither says.
    #[must_use]
    pub fn of(path: &Path, text: &str) -> MeshFormat {
        let extension = path.extension().and_then(|extension| extension.to_str());
        match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("obj") => return MeshFormat::Obj,
            Some("off") => return MeshFormat::Off,
            Some("ply") => return MeshFormat::Ply,
            Some("stl") => return MeshFormat::Stl,
            Some("usda" | "usd" | "usdc" | "usdz") => return MeshFormat::Usda,
            Some("vtk") => return MeshFormat::Vtk,
            Some("mesh") => return MeshFormat::Medit,
            _ => {}
        }
        let start = text.trim_start_matches('\u{feff}');
        if start.starts_with("#usda") {
            return MeshFormat::Usda;
        }
        if start.get(..14).is_some_and(|start| start.eq_ignore_ascii_case("# vtk DataFile")) {
            return MeshFormat::Vtk;
        }
        let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim());
        let first = lines.into_iter().find(|line| !line.is_empty()).unwrap_or_default();
        match first.split_whitespace().next() {
            Some("ply") => MeshFormat::Ply,
            Some("solid") => MeshFormat::Stl,
            Some(word) if word.eq_ignore_ascii_case("MeshVersionFormatted") => MeshFormat::Medit,
            Some(word) if word.trim_end_matches(|c: char| c.is_ascii_digit()).ends_with("OFF") => {
                MeshFormat::Off
            }
            _ => MeshFormat::Obj,
        }
    }
}

/// Reads a mesh file.
///
/// Coordinates are decimals, such as `-0.5`, `.5`, `5.`, `+1` or `1e-3`, or fractions such as `1/3`, and
/// are read exactly. In OBJ, texture coordinates `vt` are read, and so are the tags `t crease`, `t corner`, `t hole`,
/// `t interpolateboundary` and `t creasemethod`, as OpenSubdiv's own shapes have them. Colours, names,
/// materials and lines are passed over. Normals and points of no face are dropped with a note
/// ([`MeshFile::notes`]). `#` begins a comment in OBJ and OFF.
///
/// # Errors
/// When the text has another form, is cut off, or is no oriented surface
/// ([`Connectivity::new`](super::Connectivity::new)), or its numbers are beyond the caps; with the
/// place, and mostly a remedy.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::mesh::{MeshFormat, read_mesh};
///
/// let text = "v 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n";
/// let file = read_mesh(&SourceText::new("a.obj", text), MeshFormat::Obj)?;
/// assert_eq!(file.mesh().points()[2][1].to_string(), "1/10");
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_mesh(source: &Arc<SourceText>, format: MeshFormat) -> Result<MeshFile, Diagnostic> {
    read_welded_mesh(source, format, None)
}

/// Reads a mesh file, and joins points that are at most `weld` apart in the Euclidean distance, if that is given: for 0 equal
/// ones.
///
/// Points that a chain of such steps connects are joined too, so that nothing depends on their order. The point that stays is
/// the one of the least x, then y, then z. A corner that is the same as the one before it is left out, and a face of fewer
/// than three corners dropped; [`MeshFile::notes`] says how many.
///
/// # Errors
/// As [`read_mesh`]; also when the tolerance is below 0, or so small or so large that comparisons are too much work, and when a face has a
/// vertex twice after that.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::exact::Rational;
/// use subcert::mesh::{MeshFormat, read_welded_mesh};
///
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
/// let file = read_welded_mesh(&SourceText::new("a.obj", text), MeshFormat::Obj, Some(&Rational::zero()))?;
/// assert_eq!(file.mesh().points().len(), 4);
/// assert_eq!(file.mesh().connectivity().edges().len(), 5);
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_welded_mesh(
    source: &Arc<SourceText>,
    format: MeshFormat,
    weld: Option<&Rational>,
) -> Result<MeshFile, Diagnostic> {
    let parts = match format {
        MeshFormat::Obj => obj::read(source),
        MeshFormat::Off => off::read(source),
        MeshFormat::Ply => ply::read(source),
        MeshFormat::Stl => stl::read(source),
        MeshFormat::Usda => usd::read(source),
        MeshFormat::Vtk => vtk::read(source),
        MeshFormat::Medit => medit::read(source),
    }?;
    finished(parts, weld)
}

/// The mesh of these points and faces, after points are joined, if that is asked for.
fn finished(mut parts: Parts, weld: Option<&Rational>) -> Result<MeshFile, Diagnostic> {
    if let Some(tolerance) = weld {
        parts.weld(tolerance)?;
    }
    let mut file = parts.assemble()?;
    file.notes.extend(weld::unwelded(&file.mesh));
    Ok(file)
}

/// Reads a binary PLY or STL file, with points joined as by [`read_welded_mesh`]; `None` where the bytes are neither.
///
/// A binary float is the dyadic number that it is. The places of errors are lines of a listing of
/// what the file holds, with the first byte of each point and face.
///
/// # Errors
/// As [`read_mesh`].
///
/// ```
/// use subcert::mesh::read_binary_mesh;
///
/// let mut bytes = vec![0; 80];
/// bytes.extend(1_u32.to_le_bytes());
/// for x in [0.0_f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.0] {
///     bytes.extend(x.to_le_bytes());
/// }
/// bytes.extend([0, 0]);
/// let file = read_binary_mesh("a.stl", &bytes, None).expect("binary STL")?;
/// assert_eq!(file.mesh().points()[2][1].to_string(), "1/2");
/// assert!(read_binary_mesh("a.obj", b"v 0 0 0", None).is_none());
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
#[must_use]
pub fn read_binary_mesh(
    name: &str,
    bytes: &[u8],
    weld: Option<&Rational>,
) -> Option<Result<MeshFile, Diagnostic>> {
    let parts = if let Some(start) = ply::binary_start(bytes) {
        ply::read_binary(name, bytes, start)
    } else if stl::is_binary(bytes) {
        stl::read_binary(name, bytes)
    } else {
        return None;
    };
    Some(parts.and_then(|parts| finished(parts, weld)))
}
