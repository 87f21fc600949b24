//! MEDIT, ascii: `Vertices` and `Hexahedra`.

use crate::diagnostic::{Diagnostic, SourceText};
use crate::mesh::{Parts, Word, Words};
use std::sync::Arc;

/// Cells that the scheme has no rules for.
const OTHER_CELLS: [&str; 5] = ["TETRAHEDRA", "PRISMS", "PENTAHEDRA", "WEDGES", "PYRAMIDS"];

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, 0, true);
    let mut parts = Parts::new(source, 1);
    version(&mut words)?;
    let mut found = [false; 2];
    while let Some(word) = words.next() {
        match word.text.to_ascii_uppercase().as_str() {
            "DIMENSION" => dimension(&mut words)?,
            "VERTICES" => {
                once(&words, word, &mut found[0])?;
                vertices(&mut words, &mut parts)?;
            }
            "HEXAHEDRA" => {
                once(&words, word, &mut found[1])?;
                hexahedra(&mut words, &mut parts)?;
            }
            "END" => break,
            other if OTHER_CELLS.contains(&other) => none_of(&mut words, word)?,
            // Faces, edges, corners, normals: they carry references, and no cells.
            _ if begins_with_letter(word.text) => words.skip(begins_with_letter),
            _ => {
                let message = format!("a keyword is expected here, and not `{}`", word.text);
                return Err(words
                    .wrong(word.place(), message)
                    .with_help("are the numbers before it as many as their count says?"));
            }
        }
    }
    for (found, name) in found.into_iter().zip(["Vertices", "Hexahedra"]) {
        if !found {
            let end = source.text.trim_end().len();
            let message = format!("there is no `{name}`");
            return Err(words
                .wrong(end..end, message)
                .with_help("the file is cut off, or its cells are not hexahedra"));
        }
    }
    Ok(parts)
}

fn begins_with_letter(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
}

fn version(words: &mut Words<'_>) -> Result<(), Diagnostic> {
    let word = words.expect(|| "`MeshVersionFormatted 2` is missing".to_owned())?;
    if !word.text.eq_ignore_ascii_case("MeshVersionFormatted") {
        let message = "`MeshVersionFormatted` is expected here";
        return Err(words
            .wrong(word.place(), message)
            .with_help("it is the first word of a MEDIT file; is this another form?"));
    }
    words.count("the version").map(|_| ())
}

fn dimension(words: &mut Words<'_>) -> Result<(), Diagnostic> {
    let (dimension, place) =
        words.natural("the dimension", || "no dimension has been read".to_owned())?;
    if dimension == 3 {
        return Ok(());
    }
    Err(words.wrong(place, format!("points of dimension {dimension}; a solid has 3")))
}

fn once(words: &Words<'_>, word: Word<'_>, found: &mut bool) -> Result<(), Diagnostic> {
    if std::mem::replace(found, true) {
        return Err(words.wrong(word.place(), format!("`{}` for the second time", word.text)));
    }
    Ok(())
}

fn reference(words: &mut Words<'_>, what: &str) -> Result<(), Diagnostic> {
    let word = words.expect(|| format!("the reference of a {what} is missing"))?;
    if word.text.parse::<i64>().is_ok() {
        return Ok(());
    }
    let message = format!("the reference of a {what} is expected here: a whole number");
    Err(words
        .wrong(word.place(), message)
        .with_help("every line ends with a reference, 0 where there is none to say"))
}

fn vertices(words: &mut Words<'_>, parts: &mut Parts) -> Result<(), Diagnostic> {
    let count = words.count("the number of vertices")?;
    for found in 0..count {
        let missing = || format!("{found} of {count} vertices have been read");
        let (point, place) = words.point(missing)?;
        reference(words, "vertex")?;
        parts.point(point, place)?;
    }
    Ok(())
}

fn hexahedra(words: &mut Words<'_>, parts: &mut Parts) -> Result<(), Diagnostic> {
    let count = words.count("the number of hexahedra")?;
    for found in 0..count {
        let missing = || format!("{found} of {count} hexahedra have been read");
        let mut corners = Vec::with_capacity(8);
        let (mut start, mut end) = (None, 0);
        for _ in 0..8 {
            let (corner, place) = words.natural("the number of a point", missing)?;
            let Some(corner) = corner.checked_sub(1) else {
                let message = "point 0 does not exist: points are counted from 1";
                return Err(words.wrong(place, message));
            };
            start.get_or_insert(place.start);
            end = place.end;
            corners.push(corner);
        }
        reference(words, "hexahedron")?;
        parts.face(corners, start.unwrap_or(0)..end)?;
    }
    Ok(())
}

fn none_of(words: &mut Words<'_>, word: Word<'_>) -> Result<(), Diagnostic> {
    let count = words.count("the number of cells")?;
    if count == 0 {
        return Ok(());
    }
    let message = format!("{count} cells under `{}`", word.text);
    Err(words
        .wrong(word.place(), message)
        .with_help("the scheme refines hexahedra; save only those"))
}
