//! PLY, ascii.

use super::assemble::Parts;
use super::lines::{Line, Lines, extent};
use super::off::vertices;
use crate::diagnostic::{Diagnostic, SourceText};
use std::sync::Arc;

/// What the header says of one kind of lines.
struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

struct Property {
    name: String,
    list: bool,
}

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut lines = Lines::new(source, false);
    let mut parts = Parts::new(source, 0);
    for element in header(&mut lines)? {
        let name = element.name.as_str();
        for index in 0..element.count {
            let line = lines.next().ok_or_else(|| {
                lines.cut_off(&format!(
                    "{index} of {} lines of `{name}` have been read",
                    element.count
                ))
            })?;
            match name {
                "vertex" => point(&lines, &line, &element, &mut parts)?,
                "face" => face(&lines, &line, &element, &mut parts)?,
                _ => {}
            }
        }
    }
    match lines.next() {
        None => Ok(parts),
        Some(line) => Err(lines
            .wrong(extent(&line), "a line after the last one that the header tells of")
            .with_help("the counts in the header say how many lines there are")),
    }
}

fn header(lines: &mut Lines<'_>) -> Result<Vec<Element>, Diagnostic> {
    let mut elements: Vec<Element> = Vec::new();
    let mut first = true;
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.iter().map(|word| word.text).collect();
        let wrong = |message: &str| lines.wrong(extent(&line), message);
        match words[..] {
            ["ply"] if first => {}
            _ if first => return Err(wrong("a PLY file begins with the line `ply`")),
            ["format", "ascii", ..] | ["comment" | "obj_info", ..] => {}
            ["format", ..] => {
                return Err(wrong("a binary PLY file").with_help("save it in the ascii form"));
            }
            ["element", name, _] => {
                let count = lines.natural(line[2], "the number of lines")?;
                let name = name.to_owned();
                if elements.iter().any(|element| element.name == name) {
                    return Err(wrong(&format!("the element `{name}` is there twice")));
                }
                elements.push(Element { name, count, properties: Vec::new() });
            }
            ["property", "list", _, _, name] | ["property", _, name] => {
                let Some(element) = elements.last_mut() else {
                    return Err(wrong("a property before the first element"));
                };
                let (name, list) = (name.to_owned(), words[1] == "list");
                element.properties.push(Property { name, list });
            }
            ["end_header"] => return Ok(elements),
            _ => return Err(wrong("this is no line of a PLY header")),
        }
        first = false;
    }
    Err(lines.cut_off("the line `end_header` is missing"))
}

fn point(
    lines: &Lines<'_>,
    line: &Line<'_>,
    element: &Element,
    parts: &mut Parts,
) -> Result<(), Diagnostic> {
    let mut coordinates = Vec::with_capacity(3);
    for name in ["x", "y", "z"] {
        let position = element.properties.iter().position(|property| property.name == name);
        let before = position.map(|position| &element.properties[..position]);
        let Some(before) = before.filter(|before| !before.iter().any(|property| property.list))
        else {
            let message = format!("the header gives points no property `{name}` before lists");
            return Err(lines.wrong(extent(line), message));
        };
        let Some(&word) = line.get(before.len()) else {
            let message = format!("this point has no `{name}`");
            return Err(lines.wrong(extent(line), message));
        };
        coordinates.push(word);
    }
    parts.point(lines.point(&coordinates)?, extent(line))
}

fn face(
    lines: &Lines<'_>,
    line: &Line<'_>,
    element: &Element,
    parts: &mut Parts,
) -> Result<(), Diagnostic> {
    let mut at = 0;
    for property in &element.properties {
        let word = line.get(at).copied().ok_or_else(|| {
            let message = format!("this face has no `{}`", property.name);
            lines.wrong(extent(line), message)
        })?;
        at += 1;
        if property.list {
            let count = lines.natural(word, "the number of vertices of this face")?;
            if ["vertex_indices", "vertex_index"].contains(&property.name.as_str()) {
                return parts.face(vertices(lines, line, &line[at..], count)?, extent(line));
            }
            at = at.saturating_add(count);
        }
    }
    let message = "the header gives faces no list `vertex_indices`";
    Err(lines.wrong(extent(line), message))
}
