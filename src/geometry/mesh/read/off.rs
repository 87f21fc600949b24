//! OFF, ascii.

use super::assemble::Parts;
use super::lines::{Line, Lines, Word, extent};
use crate::diagnostic::{Diagnostic, SourceText};
use std::sync::Arc;

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut lines = Lines::new(source, true);
    let mut parts = Parts::new(source, 0);
    let (points, faces, plain) = counts(&mut lines)?;
    let mut more = false;
    while parts.point_count() < points {
        let found = parts.point_count();
        let line = lines
            .next()
            .ok_or_else(|| lines.cut_off(&format!("{found} of {points} points have been read")))?;
        more |= plain && line.len() > 3;
        parts.point(lines.point(&line)?, extent(&line))?;
    }
    if more {
        parts.extras.notes.push("what stands behind x, y and z of points is dropped".to_owned());
    }
    while parts.face_count() < faces {
        let found = parts.face_count();
        let line = lines
            .next()
            .ok_or_else(|| lines.cut_off(&format!("{found} of {faces} faces have been read")))?;
        parts.face(face(&lines, &line)?, extent(&line))?;
    }
    match lines.next() {
        None => Ok(parts),
        Some(line) => {
            let message = format!("a line after {points} points and {faces} faces");
            Err(lines
                .wrong(extent(&line), message)
                .with_help("the counts after `OFF` say how many lines there are"))
        }
    }
}

/// The numbers of points and faces, in the line of `OFF` or the next; whether points have coordinates only.
fn counts(lines: &mut Lines<'_>) -> Result<(usize, usize, bool), Diagnostic> {
    let mut plain = true;
    let ended = |lines: &Lines<'_>| lines.cut_off("the numbers of points and faces are missing");
    let mut line = lines.next().ok_or_else(|| ended(lines))?;
    let text = line[0].text.trim_end_matches(|c: char| c.is_ascii_digit());
    if text.ends_with("OFF") {
        let header = Word { text, at: line[0].at };
        // Some programs write no space between `OFF` and the first count.
        line[0] = Word { text: &line[0].text[text.len()..], at: header.place().end };
        if line[0].text.is_empty() {
            line.remove(0);
        }
        plain = header.text == "OFF";
        if !["OFF", "COFF", "NOFF", "CNOFF", "STOFF"].contains(&header.text) {
            let message = format!("`{}` is not supported", header.text);
            return Err(lines
                .wrong(header.place(), message)
                .with_help("write points x y z under `OFF`"));
        }
        if let Some(word) = line.first().filter(|word| word.text == "BINARY") {
            let message = "a binary OFF file";
            return Err(lines.wrong(word.place(), message).with_help("save it in the ascii form"));
        }
        if line.is_empty() {
            line = lines.next().ok_or_else(|| ended(lines))?;
        }
    }
    let [points, faces, ..] = line[..] else {
        let message = "the numbers of points, faces and edges are expected here";
        return Err(lines.wrong(extent(&line), message).with_help("write, say, `8 6 12`"));
    };
    let points = lines.natural(points, "the number of points")?;
    Ok((points, lines.natural(faces, "the number of faces")?, plain))
}

/// The vertices of a face: their number, then each; a colour may follow.
fn face(lines: &Lines<'_>, line: &Line<'_>) -> Result<Vec<usize>, Diagnostic> {
    let count = lines.natural(line[0], "the number of vertices of this face")?;
    vertices(lines, line, &line[1..], count)
}

/// The first `count` of these words as vertices.
pub(super) fn vertices(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
    count: usize,
) -> Result<Vec<usize>, Diagnostic> {
    vertices_or(lines, line, words, count, |_| None)
}

/// The same, where a word may stand for something else.
pub(super) fn vertices_or(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
    count: usize,
    other: impl Fn(&Word<'_>) -> Option<usize>,
) -> Result<Vec<usize>, Diagnostic> {
    let Some(words) = words.get(..count) else {
        let message = format!("a face of {count} vertices, of which {} are here", words.len());
        return Err(lines.wrong(extent(line), message));
    };
    let vertex = |word: &Word<'_>| {
        let other = other(word).map(Ok);
        other.unwrap_or_else(|| lines.natural(*word, "a vertex, counted from 0,"))
    };
    words.iter().map(vertex).collect()
}
