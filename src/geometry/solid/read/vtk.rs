//! Legacy VTK, ascii: an unstructured grid of hexahedra or voxels.

use super::words::Words;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::mesh::Parts;
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

/// A cell: its corners, and where it stands.
type Cell = (Vec<usize>, Range<usize>);

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, header(source)?, false);
    let mut parts = Parts::new(source, 0);
    let mut cells: Option<Vec<Cell>> = None;
    let mut types: Option<Vec<Kind>> = None;
    dataset(&mut words)?;
    while let Some(word) = words.next() {
        match word.text.to_ascii_uppercase().as_str() {
            "POINTS" => points(&mut words, &mut parts)?,
            "CELLS" => cells = Some(self::cells(&mut words)?),
            "CELL_TYPES" => types = Some(cell_types(&mut words)?),
            // What belongs to points and cells comes after them.
            "POINT_DATA" | "CELL_DATA" => break,
            "METADATA" | "FIELD" => words.skip(|text| SECTIONS.contains(&text)),
            _ => {
                let message = format!("`{}` is not expected here", word.text);
                return Err(words
                    .wrong(word.place(), message)
                    .with_help("are the numbers before it as many as their count says?"));
            }
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

/// Where the third line ends: the first two say what the file is, in words that do not matter.
fn header(source: &Arc<SourceText>) -> Result<usize, Diagnostic> {
    let text = &source.text;
    let mut at = 0;
    let mut line = || {
        let start = at;
        at += text[at..].find('\n').map_or(text.len() - at, |end| end + 1);
        (start, text[start..at].trim())
    };
    let ((_, first), (second, _)) = (line(), line());
    let known = first.trim_start_matches('\u{feff}').to_ascii_lowercase();
    if !known.starts_with("# vtk datafile") {
        let place = 0..text[..second].trim_end().len();
        return Err(Diagnostic::new(source, place, "this is no solid").with_help(
            "a VTK file begins with `# vtk DataFile Version 3.0`, and a MEDIT file with \
             `MeshVersionFormatted 2`; of other forms, such as .vtu or .msh, save one of these",
        ));
    }
    let (start, third) = line();
    if third.eq_ignore_ascii_case("ASCII") {
        return Ok(at);
    }
    let (message, help) = if third.eq_ignore_ascii_case("BINARY") {
        ("a binary VTK file", "save it in the ascii form")
    } else {
        ("`ASCII` is expected here", "it is the third line of a VTK file")
    };
    Err(Diagnostic::new(source, start..start + third.len(), message).with_help(help))
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

fn points(words: &mut Words<'_>, parts: &mut Parts) -> Result<(), Diagnostic> {
    let count = words.count("the number of points")?;
    words.expect(|| "the type of the points is missing".to_owned())?;
    for found in 0..count {
        let (point, place) = words.point(|| format!("{found} of {count} points have been read"))?;
        parts.point(point, place)?;
    }
    Ok(())
}

/// Both forms: each cell after the number of its corners, or (from version 5 on) where the cells begin in
/// a list of all corners.
fn cells(words: &mut Words<'_>) -> Result<Vec<Cell>, Diagnostic> {
    let count = words.count("the number of cells")?;
    let size = words.count("the number of numbers")?;
    if words.peek().is_some_and(|word| word.text.eq_ignore_ascii_case("OFFSETS")) {
        return listed(words, count, size);
    }
    let mut cells = Vec::new();
    for found in 0..count {
        let missing = || format!("{found} of {count} cells have been read");
        let (length, start) = words.natural("the number of corners", missing)?;
        let mut corners = Vec::new();
        let mut end = start.end;
        for _ in 0..length {
            let (corner, place) = words.natural("the number of a point", missing)?;
            corners.push(corner);
            end = place.end;
        }
        cells.push((corners, start.start..end));
    }
    Ok(cells)
}

fn listed(words: &mut Words<'_>, count: usize, size: usize) -> Result<Vec<Cell>, Diagnostic> {
    let mut list = |name: &str, count: usize| {
        let missing = || format!("`{name}` and its numbers are expected");
        let word = words.expect(missing)?;
        if !word.text.eq_ignore_ascii_case(name) {
            return Err(words.wrong(word.place(), format!("`{name}` is expected here")));
        }
        words.expect(missing)?;
        let missing = || format!("{count} numbers of `{name}` are expected");
        let numbers = (0..count).map(|_| words.natural("a number of this list", missing));
        numbers.collect::<Result<Vec<(usize, Range<usize>)>, Diagnostic>>()
    };
    let offsets = list("OFFSETS", count)?;
    let corners = list("CONNECTIVITY", size)?;
    let cell = |pair: &[(usize, Range<usize>)]| {
        let own = corners.get(pair[0].0..pair[1].0).filter(|own| !own.is_empty());
        let own = own.ok_or_else(|| {
            words.wrong(pair[1].1.clone(), "no cell: the offsets must rise, up to the corners")
        })?;
        let place = own[0].1.start..own[own.len() - 1].1.end;
        Ok((own.iter().map(|(corner, _)| *corner).collect(), place))
    };
    offsets.windows(2).map(cell).collect()
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
