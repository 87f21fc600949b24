//! MEDIT, ascii: vertices, and faces or cells.

use super::assemble::Parts;
use super::lines::Word;
use super::words::Words;
use crate::diagnostic::{Diagnostic, SourceText};
use std::sync::Arc;

/// What is read of a file.
pub(crate) struct Medit {
    /// The keywords of faces or cells, what one is called, and how many corners it has.
    pub(crate) read: &'static [(&'static str, &'static str, usize)],
    /// The keywords of cells that must not be there.
    pub(crate) refused: &'static [&'static str],
    /// What is right in place of those.
    pub(crate) help: &'static str,
}

impl Medit {
    /// Whether these are curved faces or cells of a kind that is read or refused, such as `TRIANGLESP2` or `HEXAHEDRAQ3`.
    fn curves(&self, keyword: &str) -> bool {
        let [linear @ .., b'P' | b'Q', b'2'..=b'9'] = keyword.as_bytes() else { return false };
        let same = |name: &str| name.as_bytes().eq_ignore_ascii_case(linear);
        self.read.iter().map(|(name, ..)| *name).chain(self.refused.iter().copied()).any(same)
    }
}

/// What is read of a polygon mesh.
const POLYGONS: Medit = Medit {
    read: &[("Triangles", "triangle", 3), ("Quadrilaterals", "quadrilateral", 4)],
    refused: &[
        "TETRAHEDRA",
        "HEXAHEDRA",
        "PRISMS",
        "PENTAHEDRA",
        "WEDGES",
        "PYRAMIDS",
        "BOUNDARYPOLYGONHEADERS",
        "INNERPOLYGONHEADERS",
        "POLYHEDRAHEADERS",
    ],
    help: "save only the triangles and quadrilaterals; hexahedra are refined by the scheme bajaj",
};

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    medit(source, &POLYGONS)
}

/// The vertices of a file, and its faces or cells.
pub(crate) fn medit(source: &Arc<SourceText>, kind: &Medit) -> Result<Parts, Diagnostic> {
    let mut words = Words::new(source, 0, true);
    let mut parts = Parts::new(source, 1);
    version(&mut words)?;
    let mut found: Vec<String> = Vec::new();
    while let Some(word) = words.next() {
        let keyword = word.text.to_ascii_uppercase();
        let read = kind.read.iter().find(|(name, ..)| name.eq_ignore_ascii_case(word.text));
        if read.is_some() || keyword == VERTICES {
            if found.contains(&keyword) {
                let message = format!("`{}` for the second time", word.text);
                return Err(words.wrong(word.place(), message));
            }
            found.push(keyword.clone());
        }
        if let Some((name, one, corners)) = read {
            faces(&mut words, &mut parts, [&name.to_lowercase(), one], *corners)?;
            continue;
        }
        match keyword.as_str() {
            "DIMENSION" => dimension(&mut words)?,
            VERTICES => vertices(&mut words, &mut parts)?,
            "END" => break,
            other if kind.refused.contains(&other) => {
                none_of(&mut words, word, "cells", kind.help)?;
            }
            other if kind.curves(other) => {
                let linear = &word.text[..other.len() - 2];
                let help = format!("save them with straight edges, as `{linear}`; {}", kind.help);
                none_of(&mut words, word, "curved cells", &help)?;
            }
            // Faces, edges, corners, normals: they carry references, and no cells.
            _ if begins_with_letter(word.text) => {
                words.skip(|word, _| begins_with_letter(word.text));
            }
            _ => {
                let message = format!("a keyword is expected here, and not `{}`", word.text);
                return Err(words
                    .wrong(word.place(), message)
                    .with_help("are the numbers before it as many as their count says?"));
            }
        }
    }
    let names: Vec<&str> = kind.read.iter().map(|(name, ..)| *name).collect();
    let has = |name: &str| found.iter().any(|found| found.eq_ignore_ascii_case(name));
    let missing = if has(VERTICES) {
        (!names.iter().any(|name| has(name))).then(|| names.join("` and no `"))
    } else {
        Some("Vertices".to_owned())
    };
    if let Some(missing) = missing {
        let end = source.text.trim_end().len();
        let help = format!("the file is cut off, or has other cells; {}", kind.help);
        return Err(words.wrong(end..end, format!("there is no `{missing}`")).with_help(help));
    }
    Ok(parts)
}

/// The keyword of points.
const VERTICES: &str = "VERTICES";

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
    Err(words.wrong(place, format!("points of dimension {dimension}; 3 is needed")))
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

fn faces(
    words: &mut Words<'_>,
    parts: &mut Parts,
    [all, one]: [&str; 2],
    count_of_corners: usize,
) -> Result<(), Diagnostic> {
    let count = words.count(&format!("the number of {all}"))?;
    for found in 0..count {
        let missing = || format!("{found} of {count} {all} have been read");
        let mut corners = Vec::with_capacity(count_of_corners);
        let (mut start, mut end) = (None, 0);
        for _ in 0..count_of_corners {
            let (corner, place) = words.natural("the number of a point", missing)?;
            let Some(corner) = corner.checked_sub(1) else {
                let message = "point 0 does not exist: points are counted from 1";
                return Err(words.wrong(place, message));
            };
            start.get_or_insert(place.start);
            end = place.end;
            corners.push(corner);
        }
        reference(words, one)?;
        parts.face(corners, start.unwrap_or(0)..end)?;
    }
    Ok(())
}

/// An error unless there are none.
fn none_of(
    words: &mut Words<'_>,
    word: Word<'_>,
    what: &str,
    help: &str,
) -> Result<(), Diagnostic> {
    let count = words.count("the number of cells")?;
    if count == 0 {
        return Ok(());
    }
    let message = format!("{count} {what} under `{}`", word.text);
    Err(words.wrong(word.place(), message).with_help(help))
}
