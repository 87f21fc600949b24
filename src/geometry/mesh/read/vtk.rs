//! Legacy VTK, ascii: polygons. What solids have in common with them is here too.

use super::assemble::Parts;
use super::words::Words;
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// A cell or a polygon: its corners, and where it stands.
pub(crate) type Cell = (Vec<usize>, Range<usize>);

/// Parts of a file that say nothing of faces.
const SECTIONS: [&str; 9] = [
    "POINTS",
    "POLYGONS",
    "VERTICES",
    "LINES",
    "TRIANGLE_STRIPS",
    "POINT_DATA",
    "CELL_DATA",
    "METADATA",
    "FIELD",
];

/// Whether a VTK file has polygons, and no solid.
pub(crate) fn is_polydata(text: &str) -> bool {
    let mut lines = text.lines();
    let first =
        lines.next().unwrap_or_default().trim_start_matches('\u{feff}').to_ascii_lowercase();
    let mut words = lines.skip(2).flat_map(str::split_whitespace);
    first.starts_with("# vtk datafile")
        && words.next().is_some_and(|word| word.eq_ignore_ascii_case("DATASET"))
        && words.next().is_some_and(|word| word.eq_ignore_ascii_case("POLYDATA"))
}

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, vtk_header(source)?, false);
    let mut parts = Parts::new(source, 0);
    for name in ["DATASET", "POLYDATA"] {
        let word = words.expect(|| "`DATASET POLYDATA` is missing".to_owned())?;
        if !word.text.eq_ignore_ascii_case(name) {
            let message = "`DATASET POLYDATA` is expected here";
            return Err(words.wrong(word.place(), message).with_help(
                "save the mesh so; solids are unstructured grids, for the scheme bajaj",
            ));
        }
    }
    while let Some(word) = words.next() {
        match word.text.to_ascii_uppercase().as_str() {
            "POINTS" => vtk_points(&mut words, word.place(), &mut parts)?,
            "POLYGONS" => {
                for (corners, place) in vtk_lists(&mut words)? {
                    parts.face(corners, place)?;
                }
            }
            "TRIANGLE_STRIPS" => {
                let message = "strips of triangles are not supported";
                return Err(words.wrong(word.place(), message).with_help("save polygons"));
            }
            "VERTICES" | "LINES" => {
                let what = word.text.to_ascii_lowercase();
                parts.extras.notes.push(format!("the {what} of the file are dropped"));
                vtk_lists(&mut words)?;
            }
            "POINT_DATA" | "CELL_DATA" => {
                parts.extras.notes.push("data of points and faces are dropped".to_owned());
                break;
            }
            "METADATA" | "FIELD" => words.skip(|text| SECTIONS.contains(&text)),
            _ => return Err(words.unexpected(&word)),
        }
    }
    Ok(parts)
}

/// Where the third line ends: the first two say what the file is, in words that do not matter.
pub(crate) fn vtk_header(source: &Arc<SourceText>) -> Result<usize, Diagnostic> {
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

/// The points of a VTK file, whose word `POINTS` stands at a place.
pub(crate) fn vtk_points(
    words: &mut Words<'_>,
    place: Range<usize>,
    parts: &mut Parts,
) -> Result<(), Diagnostic> {
    if parts.point_count() > 0 {
        let message = "the points of the file stand twice";
        return Err(words.wrong(place, message).with_help("keep one list of points"));
    }
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
pub(crate) fn vtk_lists(words: &mut Words<'_>) -> Result<Vec<Cell>, Diagnostic> {
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
