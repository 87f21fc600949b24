//! PLY, ascii and binary.

use super::assemble::Parts;
use super::binary::{ByteOrder, Bytes, Kind, Listing, natural};
use super::lines::{Line, Lines, extent};
use super::off::{vertices, vertices_or};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::ops::Range;
use std::sync::Arc;

/// What the header says of one kind of lines.
struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

struct Property {
    name: String,
    kind: Kind,
    /// The type of the length, of a list.
    list: Option<Kind>,
}

impl Element {
    /// One of these, in words.
    fn one(&self) -> &str {
        if self.name == STRIPS { "strip" } else { &self.name }
    }
}

impl Property {
    /// Whether it is the list of the vertices of a face.
    fn has_vertices(&self) -> bool {
        self.list.is_some() && ["vertex_indices", "vertex_index"].contains(&self.name.as_str())
    }
}

/// How the numbers after the header are written.
enum Form {
    Ascii,
    Binary(ByteOrder),
}

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut lines = Lines::new(source, false);
    let mut parts = Parts::new(source, 0);
    let (form, elements) = header(&mut lines)?;
    if !matches!(form, Form::Ascii) {
        let message = "a binary PLY file, which is read from its bytes";
        return Err(lines.wrong(0..3, message).with_help("give the file, not its text"));
    }
    for element in elements {
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
                "face" => parts.face(list(&lines, &line, &element)?, extent(&line))?,
                STRIPS => strips(&list(&lines, &line, &element)?, &extent(&line), &mut parts)?,
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

fn header(lines: &mut Lines<'_>) -> Result<(Form, Vec<Element>), Diagnostic> {
    let mut form = Form::Ascii;
    let mut elements: Vec<Element> = Vec::new();
    let (mut first, mut formed) = (true, false);
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.iter().map(|word| word.text).collect();
        let wrong = |message: &str| lines.wrong(extent(&line), message);
        match words[..] {
            ["ply"] if first => {}
            _ if first => return Err(wrong("a PLY file begins with the line `ply`")),
            ["format", ..] if std::mem::replace(&mut formed, true) => {
                return Err(wrong("the format is there twice"));
            }
            ["format", "ascii", ..] | ["comment" | "obj_info", ..] => {}
            ["format", "binary_little_endian", ..] => form = Form::Binary(ByteOrder::Little),
            ["format", "binary_big_endian", ..] => form = Form::Binary(ByteOrder::Big),
            ["format", ..] => return Err(wrong("this is no format of PLY files")),
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
                let kind = |place: usize| {
                    Kind::parse(words[place]).ok_or_else(|| {
                        wrong(&format!("`{}` is no type of numbers", words[place])).with_help(
                            "the types are char, uchar, short, ushort, int, uint, float, double",
                        )
                    })
                };
                let list = if words[1] == "list" { Some(kind(2)?) } else { None };
                let (name, kind) = (name.to_owned(), kind(words.len() - 2)?);
                let property = Property { name, kind, list };
                let is_there = |other: &Property| {
                    other.name == property.name || other.has_vertices() && property.has_vertices()
                };
                if element.properties.iter().any(is_there) {
                    return Err(wrong("this property is there twice").with_help("keep one"));
                }
                element.properties.push(property);
            }
            ["end_header"] => return Ok((form, elements)),
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
        let Some(before) =
            before.filter(|before| !before.iter().any(|property| property.list.is_some()))
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

/// The vertices of a face or of strips; of strips, [`END`] for -1.
fn list(lines: &Lines<'_>, line: &Line<'_>, element: &Element) -> Result<Vec<usize>, Diagnostic> {
    let mut at = 0;
    for property in &element.properties {
        let word = line.get(at).copied().ok_or_else(|| {
            let message = format!("this {} has no `{}`", element.one(), property.name);
            lines.wrong(extent(line), message)
        })?;
        at += 1;
        if property.list.is_some() {
            let count = lines.natural(word, "the number of vertices of this face")?;
            if property.has_vertices() {
                let words = &line[at..];
                if element.name != STRIPS {
                    return vertices(lines, line, words, count);
                }
                return vertices_or(lines, line, words, count, |word| {
                    (word.text == "-1").then_some(END)
                });
            }
            at = at.saturating_add(count);
        }
    }
    let message = format!("the header gives {}s no list `vertex_indices`", element.one());
    Err(lines.wrong(extent(line), message))
}

/// The element of strips of triangles.
const STRIPS: &str = "tristrips";

/// What stands for -1, which ends a strip.
const END: usize = usize::MAX;

/// Adds strips of triangles.
fn strips(vertices: &[usize], place: &Range<usize>, parts: &mut Parts) -> Result<(), Diagnostic> {
    vertices.split(|vertex| *vertex == END).try_for_each(|strip| parts.strip(strip, place))
}

/// Where the bytes of a binary file begin, if the header says that it is one.
pub(super) fn binary_start(bytes: &[u8]) -> Option<usize> {
    if !bytes.starts_with(b"ply") {
        return None;
    }
    // Where lines end with \r alone, a line feed after the last one is the first byte of a number.
    let first = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
    let old = bytes[first] == b'\r' && bytes.get(first + 1) != Some(&b'\n');
    let (mut at, mut binary) = (0, false);
    loop {
        let line = bytes[at..].iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
        let words: Vec<&[u8]> = bytes[at..at + line]
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty())
            .collect();
        at += line + if !old && bytes[at + line..].starts_with(b"\r\n") { 2 } else { 1 };
        match words[..] {
            [b"end_header"] => return binary.then_some(at),
            [b"format", form, ..] => binary = form.starts_with(b"binary"),
            _ => {}
        }
    }
}

/// A point or a face with its place in the listing.
enum Thing {
    Point([Rational; 3]),
    Face(Vec<usize>),
    Strips(Vec<usize>),
}

/// A binary file, whose errors have the line of a listing: the header, then each point and each face with
/// its first byte.
pub(super) fn read_binary(name: &str, bytes: &[u8], start: usize) -> Result<Parts, Diagnostic> {
    let head = bytes.get(..start).unwrap_or(bytes);
    let head = SourceText::new(name, String::from_utf8_lossy(head));
    let mut lines = Lines::new(&head, false);
    let (form, elements) = header(&mut lines)?;
    let order = match form {
        Form::Binary(order) => order,
        Form::Ascii => ByteOrder::Little,
    };
    let mut cursor = Bytes::new(bytes, start, order);
    let mut listing = Listing::default();
    for line in head.text.lines() {
        listing.line(line);
    }
    let mut things = Vec::new();
    for element in &elements {
        // A thing without properties has no bytes.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for index in 0..count {
            let at = cursor.at;
            let place = listing.line(&format!("{} {index}, byte {at}", element.name));
            match thing(&mut cursor, element) {
                Ok(None) => {}
                Ok(Some(thing)) => things.push((thing, place)),
                Err(message) => {
                    return Err(Diagnostic::new(&listing.source(name), place, message)
                        .with_help("the file is cut off, or its header does not fit it"));
                }
            }
        }
    }
    if cursor.left() > 0 {
        let place = listing.line(&format!("the rest, byte {}", cursor.at));
        let message =
            format!("{} bytes after the last thing that the header tells of", cursor.left());
        return Err(Diagnostic::new(&listing.source(name), place, message)
            .with_help("the counts in the header say how many things there are"));
    }
    let mut parts = Parts::new(&listing.source(name), 0);
    for (thing, place) in things {
        match thing {
            Thing::Point(point) => parts.point(point, place)?,
            Thing::Face(vertices) => parts.face(vertices, place)?,
            Thing::Strips(vertices) => strips(&vertices, &place, &mut parts)?,
        }
    }
    Ok(parts)
}

/// The next thing of an element, if it is a point or a face.
fn thing(cursor: &mut Bytes<'_>, element: &Element) -> Result<Option<Thing>, String> {
    let mut point: [Option<Rational>; 3] = Default::default();
    let mut face = None;
    let has_faces = ["face", STRIPS].contains(&element.name.as_str());
    for property in &element.properties {
        let name = property.name.as_str();
        let ended = || format!("`{name}` is missing, or no number of its type");
        let Some(length) = property.list else {
            let number = cursor.number(property.kind);
            let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
            match axis.filter(|_| element.name == "vertex") {
                Some(axis) => point[axis] = Some(number.ok_or_else(ended)?),
                // Another number may be infinite, but must be there.
                None if cursor.ended => return Err(ended()),
                None => {}
            }
            continue;
        };
        let count = cursor.natural(length).ok_or_else(ended)?;
        if count > cursor.left() {
            return Err(format!("`{name}` has {count} numbers, and the file ends before them"));
        }
        if has_faces && property.has_vertices() {
            let all = (0..count).map(|_| {
                let number = cursor.number(property.kind).ok_or_else(ended)?;
                let ends = element.name == STRIPS && number == Rational::from(-1);
                if ends { Some(END) } else { natural(&number) }.ok_or_else(ended)
            });
            face = Some(all.collect::<Result<Vec<usize>, String>>()?);
        } else {
            (0..count).for_each(|_| drop(cursor.number(property.kind)));
            if cursor.ended {
                return Err(ended());
            }
        }
    }
    match element.name.as_str() {
        "vertex" => match point {
            [Some(x), Some(y), Some(z)] => Ok(Some(Thing::Point([x, y, z]))),
            _ => Err("the header gives points no x, y and z".to_owned()),
        },
        name if has_faces => {
            let thing = if name == STRIPS { Thing::Strips } else { Thing::Face };
            face.map(|face| Some(thing(face))).ok_or_else(|| {
                format!("the header gives {}s no list `vertex_indices`", element.one())
            })
        }
        _ => Ok(None),
    }
}
