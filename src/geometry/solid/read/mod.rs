//! Files of solids. Numbers are read from their text, exactly.

#![deny(clippy::arithmetic_side_effects)]

mod vtk;

use super::error::SolidError;
use super::hexes::HexMesh;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use crate::mesh::{About, Medit, Places, medit};
use std::path::Path;
use std::sync::Arc;

/// What is read of a MEDIT file.
const HEXAHEDRA: Medit = Medit {
    read: &[("Hexahedra", "hexahedron", 8)],
    refused: &["TETRAHEDRA", "PRISMS", "PENTAHEDRA", "WEDGES", "PYRAMIDS"],
    help: "the scheme refines hexahedra; save only those",
};

/// The forms of files of solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolidFormat {
    /// Legacy VTK, ascii.
    Vtk,
    /// MEDIT `.mesh`, ascii.
    Medit,
}

impl SolidFormat {
    /// The form of a file: by its extension, or else by how its text begins; `None` when neither says
    /// that it is a solid.
    #[must_use]
    pub fn of(path: &Path, text: &str) -> Option<SolidFormat> {
        let extension = path.extension().and_then(|extension| extension.to_str());
        match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("vtk") => return Some(SolidFormat::Vtk),
            Some("mesh") => return Some(SolidFormat::Medit),
            _ => {}
        }
        let start = text.trim_start_matches('\u{feff}').trim_start();
        let begins = |word: &str| {
            start.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
        };
        if begins("# vtk DataFile") {
            Some(SolidFormat::Vtk)
        } else {
            begins("MeshVersionFormatted").then_some(SolidFormat::Medit)
        }
    }
}

/// A solid with the places of its points and cells in a file.
#[derive(Clone, Debug)]
pub struct SolidFile {
    mesh: HexMesh<Rational>,
    places: Places,
}

impl SolidFile {
    /// The solid.
    #[must_use]
    pub fn mesh(&self) -> &HexMesh<Rational> {
        &self.mesh
    }

    /// An error about the solid, at its place in the file.
    #[must_use]
    pub fn diagnostic(&self, error: &SolidError) -> Diagnostic {
        diagnostic(&self.places, error)
    }
}

fn diagnostic(places: &Places, error: &SolidError) -> Diagnostic {
    let (point, face, other) = (error.point(), error.cell(), error.other_cell());
    let about = About { point, face, other, help: error.help() };
    places.place(&about, error.message(places.base()))
}

/// Reads a hexahedral mesh.
///
/// | form | read |
/// |---|---|
/// | VTK | `DATASET UNSTRUCTURED_GRID` with `POINTS`, `CELLS` (both forms) and `CELL_TYPES` 12 and 11; data of points and cells are passed over |
/// | MEDIT | `Vertices` and `Hexahedra` with their references; edges, faces, normals and tags are passed over |
///
/// Coordinates are decimals or fractions, and are read exactly, as by
/// [`read_mesh`](crate::mesh::read_mesh).
///
/// # Errors
/// When the text has another form, is cut off, has other cells, or is no solid ([`HexMesh::new`]), or
/// its numbers are beyond the caps; with the place, and mostly a remedy.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::solid::{SolidFormat, read_solid};
///
/// let text = "MeshVersionFormatted 2 Dimension 3 Vertices 8 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0
///             0 0 0.1 0 1 0 0.1 0 1 1 0.1 0 0 1 0.1 0 Hexahedra 1 1 2 3 4 5 6 7 8 0 End";
/// let file = read_solid(&SourceText::new("a.mesh", text), SolidFormat::Medit)?;
/// assert_eq!(file.mesh().points()[4][2].to_string(), "1/10");
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_solid(source: &Arc<SourceText>, format: SolidFormat) -> Result<SolidFile, Diagnostic> {
    let parts = match format {
        SolidFormat::Vtk => vtk::read(source),
        SolidFormat::Medit => medit(source, &HEXAHEDRA),
    }?;
    let (points, cells, places) = parts.into_lists();
    let cells: Vec<[usize; 8]> =
        cells.into_iter().filter_map(|corners| corners.try_into().ok()).collect();
    match HexMesh::new(points, &cells) {
        Ok(mesh) => Ok(SolidFile { mesh, places }),
        Err(error) => Err(diagnostic(&places, &error)),
    }
}
