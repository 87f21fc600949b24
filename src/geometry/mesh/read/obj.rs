//! Wavefront OBJ.

use super::assemble::Parts;
use super::lines::{Line, Lines, Word, extent};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::sync::Arc;

/// Statements that say nothing about the surface.
const PASSED_OVER: [&str; 17] = [
    "vn", "vt", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p",
    "bevel", "c_interp", "d_interp", "lod",
];

/// The most lines that backslashes join into one.
const MAX_CONTINUED: usize = 10_000;

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut lines = Lines::new(source, true);
    let mut parts = Parts::new(source, 1);
    while let Some(line) = whole_line(&mut lines)? {
        let Some((&keyword, words)) = line.split_first() else { continue };
        match keyword.text {
            "v" => point(&lines, &line, words, &mut parts)?,
            "f" | "fo" => {
                let read = |word: &Word<'_>| vertex(&lines, *word, &parts);
                let vertices = words.iter().map(read).collect::<Result<Vec<usize>, _>>()?;
                parts.face(vertices, extent(&line))?;
            }
            word if PASSED_OVER.contains(&word) => {}
            "t" => {
                let message = "tags such as creases are not supported";
                return Err(lines
                    .wrong(extent(&line), message)
                    .with_help("remove the tags: boundaries and edges are then smooth"));
            }
            word => {
                let message = format!("`{word}` is no statement of a polygon mesh");
                return Err(lines.wrong(keyword.place(), message).with_help(
                    "points are lines `v x y z`, and faces are lines `f i j k …` with indices from 1",
                ));
            }
        }
    }
    Ok(parts)
}

/// The next line, with those that it continues on after a backslash.
fn whole_line<'a>(lines: &mut Lines<'a>) -> Result<Option<Line<'a>>, Diagnostic> {
    let Some(mut line) = lines.next() else { return Ok(None) };
    for _ in 0..MAX_CONTINUED {
        let Some(last) = line.last_mut().filter(|word| word.text.ends_with('\\')) else {
            return Ok(Some(line));
        };
        last.text = &last.text[..last.text.len() - 1];
        if last.text.is_empty() {
            line.pop();
        }
        match lines.next() {
            Some(more) => line.extend(more),
            None => return Err(lines.cut_off("its last line is continued")),
        }
    }
    let message = format!("more than {MAX_CONTINUED} lines are continued by backslashes");
    Err(lines.wrong(extent(&line), message))
}

fn point(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
    parts: &mut Parts,
) -> Result<(), Diagnostic> {
    // Three coordinates, with a weight, or with a colour, or with both.
    if ![3, 4, 6, 7].contains(&words.len()) {
        let message = format!("{} numbers; a point is written `v x y z`", words.len());
        return Err(lines.wrong(extent(line), message));
    }
    if let [_, _, _, weight] = words
        && lines.number(*weight)? != Rational::one()
    {
        let message = "a weight other than 1: rational surfaces are not supported";
        return Err(lines.wrong(weight.place(), message).with_help("write the point as `v x y z`"));
    }
    parts.point(lines.point(words)?, extent(line))
}

/// A vertex `v`, `v/vt`, `v//vn` or `v/vt/vn`, counted from 1, or backwards from −1.
fn vertex(lines: &Lines<'_>, word: Word<'_>, parts: &Parts) -> Result<usize, Diagnostic> {
    let text = word.text.split('/').next().unwrap_or_default();
    let wrong = |message: String| {
        lines
            .wrong(word.place(), message)
            .with_help("points are counted from 1, and those before this line from -1 backwards")
    };
    let (digits, backwards) = match text.strip_prefix('-') {
        Some(digits) => (digits, true),
        None => (text, false),
    };
    let index: usize = digits.parse().map_err(|_| {
        let huge = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        wrong(if huge {
            format!("point {text} does not exist")
        } else {
            format!("`{}` is no vertex", word.text)
        })
    })?;
    if index == 0 {
        return Err(wrong("there is no point 0".to_owned()));
    }
    if !backwards {
        return Ok(index - 1);
    }
    let count = parts.point_count();
    let before = || wrong(format!("point {text} does not exist: there are {count} points before"));
    count.checked_sub(index).ok_or_else(before)
}
