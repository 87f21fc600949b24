//! Mesh files. Numbers are read from their text, exactly.

mod assemble;
mod lines;
mod obj;
mod off;
mod ply;

pub(crate) use assemble::Parts;
pub(crate) use lines::{Lines, Word, parse_coordinate};

use super::error::MeshError;
use super::polygon::PolygonMesh;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::ops::Range;
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
    /// PLY, ascii.
    Ply,
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
            _ => {}
        }
        let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim());
        let first = lines.into_iter().find(|line| !line.is_empty()).unwrap_or_default();
        match first.split_whitespace().next() {
            Some("ply") => MeshFormat::Ply,
            Some(word) if word.ends_with("OFF") => MeshFormat::Off,
            _ => MeshFormat::Obj,
        }
    }
}

/// A mesh with the places of its points and faces in a file.
#[derive(Clone, Debug)]
pub struct MeshFile {
    mesh: PolygonMesh<Rational>,
    places: Places,
}

/// Where points and faces stand; in a file of a solid, cells in place of faces.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    source: Arc<SourceText>,
    points: Vec<Range<usize>>,
    faces: Vec<Range<usize>>,
    /// What the file calls the first point and the first face.
    base: usize,
}

/// What an error is about: a point, a face, another face, and the remedy.
pub(crate) struct About {
    pub(crate) point: Option<usize>,
    pub(crate) face: Option<usize>,
    pub(crate) other: Option<usize>,
    pub(crate) help: Option<&'static str>,
}

impl MeshFile {
    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &PolygonMesh<Rational> {
        &self.mesh
    }

    /// An error about the mesh, at its place in the file.
    #[must_use]
    pub fn diagnostic(&self, error: &MeshError) -> Diagnostic {
        self.places.diagnostic(error)
    }
}

impl Places {
    fn diagnostic(&self, error: &MeshError) -> Diagnostic {
        let (point, face, other) = (error.point(), error.face(), error.other_face());
        let about = About { point, face, other, help: error.help() };
        self.place(&about, error.message(self.base))
    }

    /// What the file calls the first point and the first face.
    pub(crate) fn base(&self) -> usize {
        self.base
    }

    /// An error at its place.
    pub(crate) fn place(&self, about: &About, message: String) -> Diagnostic {
        let point = about.point.and_then(|point| self.points.get(point));
        let face = about.face.and_then(|face| self.faces.get(face));
        let span = point.or(face).cloned().unwrap_or(0..0);
        let mut diagnostic = Diagnostic::new(&self.source, span, message);
        let other = match (point, face) {
            (Some(_), Some(face)) => Some(face),
            _ => about.other.and_then(|face| self.faces.get(face)),
        };
        if let Some(other) = other {
            diagnostic = diagnostic.with_place(other.clone(), "the other place");
        }
        match about.help {
            Some(help) => diagnostic.with_help(help),
            None => diagnostic,
        }
    }
}

/// Reads a mesh file.
///
/// Coordinates are decimals, such as `-0.5`, `.5`, `5.`, `+1` or `1e-3`, or fractions such as `1/3`, and
/// are read exactly. Normals, colours, texture coordinates, names, materials and lines are passed
/// over. `#` begins a comment in OBJ and OFF.
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
    let parts = match format {
        MeshFormat::Obj => obj::read(source),
        MeshFormat::Off => off::read(source),
        MeshFormat::Ply => ply::read(source),
    }?;
    parts.assemble()
}
