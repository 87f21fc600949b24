//! Legacy VTK, ascii: polygons, as polydata or as an unstructured grid. What solids have in common with them is here too.

use super::assemble::Parts;
use super::lines::{Word, line_end};
use super::words::Words;
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// A cell or a polygon: its corners, and where it stands.
pub(crate) type Cell = (Vec<usize>, Range<usize>);

/// The words that begin a part of a file.
const SECTIONS: [&str; 11] = [
    "POINTS",
    "POLYGONS",
    "VERTICES",
    "LINES",
    "TRIANGLE_STRIPS",
    "CELLS",
    "CELL_TYPES",
    "POINT_DATA",
    "CELL_DATA",
    "METADATA",
    "FIELD",
];

/// The types of cells that are faces, and that of strips.
const TRIANGLE: usize = 5;
const STRIP: usize = 6;
const POLYGON: usize = 7;
const PIXEL: usize = 8;
const QUADRILATERAL: usize = 9;

/// What the types of cells are called.
const CELLS: [(usize, &str); 18] = [
    (1, "vertex"),
    (2, "set of vertices"),
    (3, "line"),
    (4, "polyline"),
    (TRIANGLE, "triangle"),
    (STRIP, "strip of triangles"),
    (POLYGON, "polygon"),
    (PIXEL, "pixel"),
    (QUADRILATERAL, "quadrilateral"),
    (10, "tetrahedron"),
    (11, "voxel"),
    (12, "hexahedron"),
    (13, "wedge"),
    (14, "pyramid"),
    (24, "quadratic tetrahedron"),
    (25, "quadratic hexahedron"),
    (29, "triquadratic hexahedron"),
    (42, "polyhedron"),
];

/// What a type of cells is called, after `a cell of type N`.
pub(crate) fn vtk_cell(kind: usize) -> String {
    let name = CELLS.iter().find(|(known, _)| *known == kind);
    name.map(|(_, name)| format!(", a {name}")).unwrap_or_default()
}

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, vtk_header(source)?, false);
    let mut parts = Parts::new(source, 0);
    if dataset(&mut words, &["POLYDATA", GRID])? == GRID {
        for (cell, kind) in vtk_grid(source, &mut words, &mut parts)? {
            face(source, cell, kind, &mut parts)?;
        }
        return Ok(parts);
    }
    let mut met = Vec::new();
    while let Some(word) = words.next() {
        match section(&words, &word, &mut met)?.as_str() {
            "POINTS" => vtk_points(&mut words, &mut parts)?,
            "POLYGONS" => {
                for (corners, place) in vtk_lists(&mut words)? {
                    parts.face(corners, place)?;
                }
            }
            "TRIANGLE_STRIPS" => {
                for (corners, place) in vtk_lists(&mut words)? {
                    parts.strip(&corners, &place)?;
                }
            }
            "VERTICES" | "LINES" => {
                let what = word.text.to_ascii_lowercase();
                parts.extras.notes.push(format!("the {what} of the file are dropped"));
                vtk_lists(&mut words)?;
            }
            "POINT_DATA" | "CELL_DATA" => {
                parts.extras.notes.push(DROPPED.to_owned());
                break;
            }
            "METADATA" | "FIELD" => skip_to_section(&mut words),
            _ => return Err(words.unexpected(&word)),
        }
    }
    Ok(parts)
}

const DROPPED: &str = "data of points and faces are dropped";

/// The section that a word begins, in capitals. Sections of points and cells stand once.
fn section(
    words: &Words<'_>,
    word: &Word<'_>,
    met: &mut Vec<String>,
) -> Result<String, Diagnostic> {
    let section = word.text.to_ascii_uppercase();
    if met.contains(&section) && !["METADATA", "FIELD"].contains(&section.as_str()) {
        let message = format!("`{}` for the second time", word.text);
        return Err(words.wrong(word.place(), message).with_help("keep one of the two lists"));
    }
    met.push(section.clone());
    Ok(section)
}

/// Passes over words until one with which a section begins. An array in the part that is passed over may have such a name,
/// and then four words are in its line.
fn skip_to_section(words: &mut Words<'_>) {
    words.skip(|word, of_line| {
        SECTIONS.contains(&word.text)
            || of_line.is_some_and(|count| count < 4)
                && SECTIONS.iter().any(|section| section.eq_ignore_ascii_case(word.text))
    });
}

/// The name of unstructured grids.
const GRID: &str = "UNSTRUCTURED_GRID";

/// The dataset, which is one of these.
fn dataset(words: &mut Words<'_>, known: &[&'static str]) -> Result<&'static str, Diagnostic> {
    let wanted = || format!("`DATASET {}`", known.join("` or `DATASET "));
    let missing = || format!("{} is missing", wanted());
    let (word, kind) = (words.expect(missing)?, words.expect(missing)?);
    let found = known.iter().find(|known| kind.text.eq_ignore_ascii_case(known));
    found.copied().filter(|_| word.text.eq_ignore_ascii_case("DATASET")).ok_or_else(|| {
        let message = format!("{} is expected here", wanted());
        words.wrong(word.at..kind.place().end, message).with_help("save the mesh so")
    })
}

/// A cell that is a face of a mesh.
fn face(
    source: &Arc<SourceText>,
    (mut corners, place): Cell,
    (kind, kind_place): Kind,
    parts: &mut Parts,
) -> Result<(), Diagnostic> {
    let wanted = match kind {
        TRIANGLE => Some(3),
        PIXEL | QUADRILATERAL => Some(4),
        STRIP => return parts.strip(&corners, &place),
        POLYGON => None,
        _ => {
            let message = format!("a cell of type {kind}{}", vtk_cell(kind));
            return Err(Diagnostic::new(source, kind_place, message)
                .with_place(place, "the cell")
                .with_help(
                    "a polygon mesh has triangles (type 5), quadrilaterals (9), pixels (8), polygons (7) and strips \
                     (6); hexahedra are refined by the scheme bajaj",
                ));
        }
    };
    if let Some(count) = wanted.filter(|count| *count != corners.len()) {
        let message = format!(
            "a cell of type {kind}{}, of {} corners; it has {count}",
            vtk_cell(kind),
            corners.len()
        );
        return Err(Diagnostic::new(source, place, message));
    }
    if kind == PIXEL {
        // Row by row, and not around.
        corners.swap(2, 3);
    }
    parts.face(corners, place)
}

/// The type of a cell, and where it stands.
pub(crate) type Kind = (usize, Range<usize>);

/// The cells of an unstructured grid with their types, after `DATASET UNSTRUCTURED_GRID`; the points go to `parts`.
fn vtk_grid(
    source: &Arc<SourceText>,
    words: &mut Words<'_>,
    parts: &mut Parts,
) -> Result<Vec<(Cell, Kind)>, Diagnostic> {
    let (mut cells, mut types, mut met) = (None, None, Vec::new());
    while let Some(word) = words.next() {
        match section(words, &word, &mut met)?.as_str() {
            "POINTS" => vtk_points(words, parts)?,
            "CELLS" => cells = Some(vtk_lists(words)?),
            "CELL_TYPES" => types = Some(cell_types(words)?),
            // What belongs to points and cells comes after them.
            "POINT_DATA" | "CELL_DATA" => {
                parts.extras.notes.push(DROPPED.to_owned());
                break;
            }
            "METADATA" | "FIELD" => skip_to_section(words),
            _ => return Err(words.unexpected(&word)),
        }
    }
    let cut_off = |message: &str| {
        let end = source.text.trim_end().len();
        Diagnostic::new(source, end..end, message)
            .with_help("the file is cut off, or no unstructured grid")
    };
    let cells = cells.ok_or_else(|| cut_off("there is no `CELLS`"))?;
    let types = types.ok_or_else(|| cut_off("there is no `CELL_TYPES`"))?;
    if cells.len() != types.len() {
        let message = format!("{} cells, but {} types of cells", cells.len(), types.len());
        return Err(cut_off(&message));
    }
    Ok(cells.into_iter().zip(types).collect())
}

/// The cells of a file of a solid, and its points.
pub(crate) fn vtk_solid(
    source: &Arc<SourceText>,
    parts: &mut Parts,
) -> Result<Vec<(Cell, Kind)>, Diagnostic> {
    let mut words = Words::new(source, vtk_header(source)?, false);
    dataset(&mut words, &[GRID])?;
    vtk_grid(source, &mut words, parts)
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

/// Where the third line ends: the first two say what the file is, in words that do not matter.
fn vtk_header(source: &Arc<SourceText>) -> Result<usize, Diagnostic> {
    let text = &source.text;
    let mut at = 0;
    let mut line = || {
        let start = at;
        at = line_end(text, at);
        (start, text[start..at].trim())
    };
    let ((_, first), (second, _)) = (line(), line());
    let known = first.trim_start_matches('\u{feff}').to_ascii_lowercase();
    if !known.starts_with("# vtk datafile") {
        let place = 0..text[..second].trim_end().len();
        return Err(Diagnostic::new(source, place, "this is no VTK file").with_help(
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

/// The points of a VTK file, after the word `POINTS`.
fn vtk_points(words: &mut Words<'_>, parts: &mut Parts) -> Result<(), Diagnostic> {
    let count = words.count("the number of points")?;
    words.expect(|| "the type of the points is missing".to_owned())?;
    for found in 0..count {
        let (point, place) = words.point(|| format!("{found} of {count} points have been read"))?;
        parts.point(point, place)?;
    }
    Ok(())
}

/// Cells or polygons in both forms: each after the number of its corners, or (from version 5 on) where the cells begin in
/// a list of all corners.
fn vtk_lists(words: &mut Words<'_>) -> Result<Vec<Cell>, Diagnostic> {
    let count = words.count("the number of cells")?;
    let size = words.count("the number of numbers")?;
    if let Some(word) = words.peek().filter(|word| word.text.eq_ignore_ascii_case("OFFSETS")) {
        return listed(words, &word.place(), (count, size));
    }
    let (mut cells, mut numbers, mut last) = (Vec::new(), 0, 0..0);
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
        numbers += 1 + corners.len();
        last = start.start..end;
        cells.push((corners, last.clone()));
    }
    if numbers != size {
        let message =
            format!("the last of {count} cells, which have {numbers} numbers and not {size}");
        let help = "the second number after the name of a list counts all numbers of it";
        return Err(words.wrong(last, message).with_help(help));
    }
    Ok(cells)
}

fn listed(
    words: &mut Words<'_>,
    start: &Range<usize>,
    (count, size): (usize, usize),
) -> Result<Vec<Cell>, Diagnostic> {
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
    let ends = [(offsets.first(), "first", 0), (offsets.last(), "last", size)];
    for (offset, which, wanted) in ends {
        let (found, place) = offset.map_or((0, start.clone()), |(at, place)| (*at, place.clone()));
        if found != wanted {
            let message = format!("the {which} offset is {found}, and it must be {wanted}");
            return Err(words.wrong(place, message).with_help(
                "the offsets begin with 0 and end with the number of corners; the number after the name of the list \
                 is that of the offsets, one more than there are cells",
            ));
        }
    }
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
