//! A mesh with the places of its points and faces in a file.

use super::super::error::MeshError;
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::ops::Range;
use std::sync::Arc;

/// A mesh with the places of its points and faces in a file.
#[derive(Clone, Debug)]
pub struct MeshFile {
    pub(super) mesh: PolygonMesh<Rational>,
    pub(super) places: Places,
    pub(super) notes: Vec<String>,
    pub(super) scheme: Option<String>,
}

/// Where points and faces stand; in a file of a solid, cells in place of faces.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    pub(super) source: Arc<SourceText>,
    pub(super) points: Vec<Range<usize>>,
    pub(super) faces: Vec<Range<usize>>,
    /// What the file calls the first point and the first face.
    pub(super) base: usize,
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

    /// The same file with another mesh on its faces, such as with other tags.
    #[must_use]
    pub fn with_mesh(self, mesh: PolygonMesh<Rational>) -> MeshFile {
        MeshFile { mesh, ..self }
    }

    /// What was dropped or changed when the file was read, in sentences.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What the file says against the scheme that it is refined by: a USD file names one.
    #[must_use]
    pub fn other_scheme(&self, scheme: MeshScheme) -> Option<String> {
        let named = self.scheme.as_deref()?;
        let fits = match named {
            "catmullClark" => scheme.is_bicubic(),
            "loop" => scheme.is_triangular(),
            // What is written by a scheme that USD does not know.
            "none" => !scheme.is_triangular() && scheme != MeshScheme::CatmullClark,
            _ => false,
        };
        let yours = scheme.name();
        (!fits).then(|| {
            format!("the file has the subdivisionScheme `{named}`, and the mesh is refined by {yours}, as asked for")
        })
    }

    /// An error about the mesh, at its place in the file.
    #[must_use]
    pub fn diagnostic(&self, error: &MeshError) -> Diagnostic {
        self.places.diagnostic(error)
    }
}

impl Places {
    pub(super) fn diagnostic(&self, error: &MeshError) -> Diagnostic {
        let (point, face, other) = (error.point(), error.face(), error.other_face());
        let about = About { point, face, other, help: error.help() };
        self.place(&about, error.message(self.base))
    }

    /// The line in which a point stands.
    pub(super) fn line(&self, point: usize) -> usize {
        let start = self.points.get(point).map_or(0, |place| place.start);
        1 + self.source.text.get(..start).unwrap_or_default().matches('\n').count()
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
