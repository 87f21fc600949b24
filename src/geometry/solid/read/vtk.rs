//! Legacy VTK, ascii: an unstructured grid of hexahedra or voxels.

use crate::diagnostic::{Diagnostic, SourceText};
use crate::mesh::{Cell, Parts, Words, vtk_header, vtk_lists, vtk_points};
use crate::solid::cube::FILE_ORDER;
use std::ops::Range;
use std::sync::Arc;

/// The types of cells that are read.
const VOXEL: usize = 11;
const HEXAHEDRON: usize = 12;

/// What other types are called.
const OTHERS: [(usize, &str); 16] = [
    (1, "vertex"),
    (2, "vertices"),
    (3, "line"),
    (4, "polyline"),
    (5, "triangle"),
    (6, "strip of triangles"),
    (7, "polygon"),
    (8, "pixel"),
    (9, "quadrilateral"),
    (10, "tetrahedron"),
    (13, "wedge"),
    (14, "pyramid"),
    (24, "quadratic tetrahedron"),
    (25, "quadratic hexahedron"),
    (29, "triquadratic hexahedron"),
    (42, "polyhedron"),
];

/// The type of a cell, and where it stands.
type Kind = (usize, Range<usize>);

/// The words that begin a part of a file.
const SECTIONS: [&str; 7] =
    ["POINTS", "CELLS", "CELL_TYPES", "POINT_DATA", "CELL_DATA", "METADATA", "FIELD"];

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, vtk_header(source)?, false);
    let mut parts = Parts::new(source, 0);
    let mut cells: Option<Vec<Cell>> = None;
    let mut types: Option<Vec<Kind>> = None;
    dataset(&mut words)?;
    while let Some(word) = words.next() {
        match word.text.to_ascii_uppercase().as_str() {
            "POINTS" => vtk_points(&mut words, word.place(), &mut parts)?,
            "CELLS" => cells = Some(vtk_lists(&mut words)?),
            "CELL_TYPES" => types = Some(cell_types(&mut words)?),
            // What belongs to points and cells comes after them.
            "POINT_DATA" | "CELL_DATA" => break,
            "METADATA" | "FIELD" => words.skip(|text| SECTIONS.contains(&text)),
            _ => return Err(words.unexpected(&word)),
        }
    }
    let missing = |what: &str| format!("there is no `{what}`");
    let cells = cells.ok_or_else(|| cut_off(source, &missing("CELLS")))?;
    let types = types.ok_or_else(|| cut_off(source, &missing("CELL_TYPES")))?;
    if cells.len() != types.len() {
        let message = format!("{} cells, but {} types of cells", cells.len(), types.len());
        return Err(cut_off(source, &message));
    }
    for ((corners, place), (kind, kind_place)) in cells.into_iter().zip(types) {
        let corners = hexahedron(source, corners, &place, kind, kind_place)?;
        parts.face(corners, place)?;
    }
    Ok(parts)
}

fn cut_off(source: &Arc<SourceText>, message: &str) -> Diagnostic {
    let end = source.text.trim_end().len();
    Diagnostic::new(source, end..end, message)
        .with_help("the file is cut off, or no unstructured grid")
}

fn dataset(words: &mut Words<'_>) -> Result<(), Diagnostic> {
    let missing = || "`DATASET UNSTRUCTURED_GRID` is missing".to_owned();
    let word = words.expect(missing)?;
    let kind = words.expect(missing)?;
    let right = word.text.eq_ignore_ascii_case("DATASET")
        && kind.text.eq_ignore_ascii_case("UNSTRUCTURED_GRID");
    if right {
        return Ok(());
    }
    let message = "`DATASET UNSTRUCTURED_GRID` is expected here";
    Err(words.wrong(word.at..kind.place().end, message).with_help("save the mesh so"))
}

fn cell_types(words: &mut Words<'_>) -> Result<Vec<Kind>, Diagnostic> {
    let count = words.count("the number of types")?;
    let mut types = Vec::new();
    for found in 0..count {
        let missing = || format!("{found} of {count} types of cells have been read");
        types.push(words.natural("the type of a cell", missing)?);
    }
    Ok(types)
}

/// The corners in the order of a hexahedron.
fn hexahedron(
    source: &Arc<SourceText>,
    corners: Vec<usize>,
    place: &Range<usize>,
    kind: usize,
    kind_place: Range<usize>,
) -> Result<Vec<usize>, Diagnostic> {
    if ![VOXEL, HEXAHEDRON].contains(&kind) {
        let name = OTHERS.iter().find(|(other, _)| *other == kind);
        let name = name.map(|(_, name)| format!(", a {name}")).unwrap_or_default();
        return Err(Diagnostic::new(source, kind_place, format!("a cell of type {kind}{name}"))
            .with_place(place.clone(), "the cell")
            .with_help(
                "the scheme refines hexahedra (type 12) and voxels (11); save only the hexahedra",
            ));
    }
    if corners.len() != 8 {
        let message = format!("a hexahedron of {} corners; it has 8", corners.len());
        return Err(Diagnostic::new(source, place.clone(), message));
    }
    Ok(if kind == VOXEL { FILE_ORDER.map(|corner| corners[corner]).to_vec() } else { corners })
}
