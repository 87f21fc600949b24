//! Wavefront OBJ.

use super::assemble::{MAX_CORNERS, Parts};
use super::lines::{Line, Lines, Word, extent};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::sync::Arc;

/// Statements that say nothing about the surface.
const PASSED_OVER: [&str; 15] = [
    "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p", "bevel",
    "c_interp", "d_interp", "lod",
];

/// The most lines that backslashes join into one.
const MAX_CONTINUED: usize = 10_000;

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut lines = Lines::new(source, true);
    let mut parts = Parts::new(source, 1);
    let (mut normals, mut colours) = (0_usize, 0_usize);
    while let Some(line) = whole_line(&mut lines)? {
        let Some((&keyword, words)) = line.split_first() else { continue };
        match keyword.text {
            "v" => point(&lines, &line, words, &mut parts, &mut colours)?,
            "f" | "fo" => {
                let read = |word: &Word<'_>| vertex(&lines, *word, &parts);
                let vertices = words.iter().map(read).collect::<Result<Vec<usize>, _>>()?;
                let textured = textured(&lines, &line, words, &parts)?;
                parts.face(vertices, extent(&line))?;
                parts.extras.textured.push(textured);
            }
            "vt" => {
                if parts.extras.texture.len() == MAX_CORNERS {
                    let message = format!("more than {MAX_CORNERS} texture coordinates");
                    return Err(lines
                        .wrong(extent(&line), message)
                        .with_help("take a smaller mesh"));
                }
                let value = texture(&lines, &line, words)?;
                parts.extras.texture.push((value, extent(&line)));
            }
            "vn" => normals += 1,
            word if PASSED_OVER.contains(&word) => {}
            "t" => super::tags::read(&lines, &line, words, &mut parts.extras)?,
            word => {
                let message = format!("`{word}` is no statement of a polygon mesh");
                return Err(lines.wrong(keyword.place(), message).with_help(
                    "points are lines `v x y z`, and faces are lines `f i j k …` with indices from 1",
                ));
            }
        }
    }
    if normals > 0 {
        let note =
            format!("{normals} normals are dropped: those of the limit are written by `limit`");
        parts.extras.notes.push(note);
    }
    if colours > 0 {
        parts.extras.notes.push(format!("the colours of {colours} points are dropped"));
    }
    Ok(parts)
}

/// The next line, with the one after it where a backslash ends it, and so on.
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
        // A line without words ends it.
        match lines.any() {
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
    colours: &mut usize,
) -> Result<(), Diagnostic> {
    // Three coordinates, with a weight, or with a colour, or with both.
    if ![3, 4, 6, 7].contains(&words.len()) {
        let message = format!("{} numbers; a point is written `v x y z`", words.len());
        return Err(lines.wrong(extent(line), message));
    }
    let more = words[3..].iter().map(|word| Ok((*word, lines.number(*word)?)));
    let more = more.collect::<Result<Vec<(Word<'_>, Rational)>, Diagnostic>>()?;
    if let Some((weight, number)) = more.first().filter(|_| more.len() != 3)
        && *number != Rational::one()
    {
        let message = "a weight other than 1: rational surfaces are not supported";
        return Err(lines.wrong(weight.place(), message).with_help("write the point as `v x y z`"));
    }
    *colours += usize::from(more.len() >= 3);
    parts.point(lines.point(words)?, extent(line))
}

/// A texture coordinate: one number, which has v = 0, or two or three.
fn texture(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
) -> Result<Vec<Rational>, Diagnostic> {
    if !(1..=3).contains(&words.len()) {
        let message = format!("{} numbers; a texture coordinate is written `vt u v`", words.len());
        return Err(lines.wrong(extent(line), message));
    }
    let mut value =
        words.iter().map(|word| lines.number(*word)).collect::<Result<Vec<Rational>, _>>()?;
    value.resize(value.len().max(2), Rational::zero());
    Ok(value)
}

/// The texture coordinates of a face: of each vertex, or none.
fn textured(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
    parts: &Parts,
) -> Result<Option<Vec<usize>>, Diagnostic> {
    let of = |word: &Word<'_>| word.text.split('/').nth(1).is_some_and(|text| !text.is_empty());
    let count = words.iter().filter(|word| of(word)).count();
    if count == 0 {
        return Ok(None);
    }
    if count < words.len() {
        let message = "some vertices of this face have texture coordinates, and some have none";
        return Err(lines.wrong(extent(line), message).with_help("give all or none"));
    }
    let before = parts.extras.texture.len();
    let read = |word: &Word<'_>| {
        let text = word.text.split('/').nth(1).unwrap_or_default();
        index(lines, *word, text, "texture coordinate", before)
    };
    words.iter().map(read).collect::<Result<_, _>>().map(Some)
}

/// A vertex `v`, `v/vt`, `v//vn` or `v/vt/vn`.
fn vertex(lines: &Lines<'_>, word: Word<'_>, parts: &Parts) -> Result<usize, Diagnostic> {
    let text = word.text.split('/').next().unwrap_or_default();
    index(lines, word, text, "point", parts.point_count())
}

/// A number counted from 1, or backwards from −1 for the last of the `count` things before.
fn index(
    lines: &Lines<'_>,
    word: Word<'_>,
    text: &str,
    thing: &str,
    count: usize,
) -> Result<usize, Diagnostic> {
    let wrong = |message: String| {
        lines.wrong(word.place(), message).with_help(format!(
            "{thing}s are counted from 1, and those before this line from -1 backwards"
        ))
    };
    let (digits, backwards) = match text.strip_prefix('-') {
        Some(digits) => (digits, true),
        None => (text, false),
    };
    let index: usize = digits.parse().map_err(|_| {
        let huge = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        wrong(if huge {
            format!("{thing} {text} does not exist")
        } else {
            format!("`{}` is no vertex", word.text)
        })
    })?;
    if index == 0 {
        return Err(wrong(format!("there is no {thing} 0")));
    }
    if !backwards {
        return Ok(index - 1);
    }
    let before =
        || wrong(format!("{thing} {text} does not exist: there are {count} {thing}s before"));
    count.checked_sub(index).ok_or_else(before)
}
