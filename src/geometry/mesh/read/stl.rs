//! STL, ascii and binary: triangles with points of their own, which are joined where they are equal.

use super::super::point::Point;
use super::assemble::Parts;
use super::binary::{ByteOrder, Bytes, Listing};
use super::lines::{Word, line_end, words};
use super::words::Words;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// The bytes before the first triangle, and of each triangle.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Triangles whose equal points are joined.
struct Joined {
    parts: Parts,
    known: HashMap<Point<Rational>, usize>,
    met: usize,
}

impl Joined {
    fn new(source: &Arc<SourceText>) -> Joined {
        Joined { parts: Parts::new(source, 0), known: HashMap::new(), met: 0 }
    }

    fn triangle(
        &mut self,
        corners: [(Point<Rational>, Range<usize>); 3],
        place: Range<usize>,
    ) -> Result<(), Diagnostic> {
        let mut numbers = Vec::with_capacity(3);
        for (point, place) in corners {
            self.met += 1;
            let next = self.parts.point_count();
            let number = *self.known.entry(point.clone()).or_insert(next);
            if number == next {
                self.parts.point(point, place)?;
            }
            numbers.push(number);
        }
        self.parts.face(numbers, place)
    }

    fn parts(mut self) -> Parts {
        let (met, points) = (self.met, self.parts.point_count());
        let note = format!(
            "{met} vertices of triangles are at {points} different points, and those at one point are \
             joined; the normals of the file are dropped"
        );
        self.parts.extras.notes.push(note);
        self.parts
    }
}

/// Whether the bytes are as many as a binary file has.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.get(80..HEAD).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    let length = |count: u32| u64::from(count) * TRIANGLE as u64 + HEAD as u64;
    count.is_some_and(|count| length(count) == bytes.len() as u64)
}

/// A binary file, whose errors have the line of a listing of its triangles.
pub(super) fn read_binary(name: &str, bytes: &[u8]) -> Result<Parts, Diagnostic> {
    let mut listing = Listing::default();
    let mut places = Vec::new();
    for index in 0..(bytes.len() - HEAD) / TRIANGLE {
        let at = HEAD + index * TRIANGLE;
        places.push(listing.line(&format!("triangle {index}, byte {at}")));
    }
    let source = listing.source(name);
    let mut joined = Joined::new(&source);
    let mut cursor = Bytes::new(bytes, HEAD, ByteOrder::Little);
    for place in places {
        // The normal.
        cursor.skip(12);
        let mut corner = || -> Result<_, Diagnostic> {
            let mut point = [Rational::zero(), Rational::zero(), Rational::zero()];
            for x in &mut point {
                *x = cursor.f32().ok_or_else(|| {
                    Diagnostic::new(&source, place.clone(), "a coordinate is no number")
                        .with_help("is it infinite or NaN, or is the file cut off?")
                })?;
            }
            Ok((point, place.clone()))
        };
        let corners = [corner()?, corner()?, corner()?];
        cursor.skip(2);
        joined.triangle(corners, place)?;
    }
    Ok(joined.parts())
}

/// `solid NAME`, then `facet normal … outer loop vertex … endloop endfacet`, then `endsolid NAME`; once or more often.
pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let first = source.text.trim_start_matches('\u{feff}').trim_start();
    let start = source.text.len() - first.len();
    let line = line_end(&source.text, start);
    if !first.to_ascii_lowercase().starts_with("solid") {
        let message = "an STL file begins with the word `solid`";
        return Err(Diagnostic::new(source, start..line, message)
            .with_help("a binary file has 84 bytes, and 50 for each triangle: is it cut off?"));
    }
    let mut words = Words::new(source, facet_in_line(&source.text, start).unwrap_or(line), false);
    let mut joined = Joined::new(source);
    let mut solids = 1_usize;
    loop {
        let missing = || "`endsolid` is missing".to_owned();
        let word = words.expect(missing)?;
        if word.text.eq_ignore_ascii_case("endsolid") {
            // The name of the solid may follow in this line.
            let text = &source.text;
            if let Some(at) = facet_in_line(text, word.at) {
                let message = "a triangle in the line of `endsolid`";
                return Err(Diagnostic::new(source, at..at + 5, message)
                    .with_help("put each `solid` and each `endsolid` on a line of its own"));
            }
            let rest = text[line_end(text, word.at)..].trim_start();
            if rest.is_empty() {
                break;
            }
            let at = text.len() - rest.len();
            let next = rest.split_whitespace().next().unwrap_or_default();
            if !next.eq_ignore_ascii_case("solid") {
                let message = "there is more after the end of the solid";
                return Err(Diagnostic::new(source, at..at + next.len(), message)
                    .with_help("another solid begins with the word `solid`"));
            }
            let start = facet_in_line(text, at).unwrap_or_else(|| line_end(text, at));
            words = Words::new(source, start, false);
            solids += 1;
            continue;
        }
        expected(&mut words, word.text, word.place(), "facet")?;
        word_is(&mut words, "normal")?;
        for _ in 0..3 {
            words.expect(missing)?;
        }
        word_is(&mut words, "outer")?;
        word_is(&mut words, "loop")?;
        let mut corner = || -> Result<_, Diagnostic> {
            word_is(&mut words, "vertex")?;
            words.point(|| "a triangle has three vertices".to_owned())
        };
        let corners = [corner()?, corner()?, corner()?];
        word_is(&mut words, "endloop")?;
        let end = word_is(&mut words, "endfacet")?;
        joined.triangle(corners, word.at..end)?;
    }
    let mut parts = joined.parts();
    if solids > 1 {
        parts.extras.notes.push(format!("the {solids} solids of the file are read as one mesh"));
    }
    Ok(parts)
}

/// The first triangle in the line that a byte is in, if there is one. A name may have the words `facet normal` in it, and then
/// `outer loop` does not follow after three numbers.
fn facet_in_line(text: &str, at: usize) -> Option<usize> {
    let end = line_end(text, at);
    let (mut facet, mut before, mut after) = (None, None::<Word<'_>>, 0);
    for word in words(&text[at..], at) {
        // `facet` may be the last word of the line, and `loop` is the sixth one after it.
        after += usize::from(word.at >= end);
        if after > 6 {
            break;
        }
        let are = |names: [&str; 2]| {
            before.is_some_and(|before| before.text.eq_ignore_ascii_case(names[0]))
                && word.text.eq_ignore_ascii_case(names[1])
        };
        if are(["facet", "normal"]) {
            facet = facet.or(before.map(|before| before.at).filter(|at| *at < end));
        }
        if facet.is_some() && are(["outer", "loop"]) {
            return facet;
        }
        before = Some(word);
    }
    None
}

fn word_is(words: &mut Words<'_>, name: &str) -> Result<usize, Diagnostic> {
    let word = words.expect(|| format!("`{name}` is expected"))?;
    expected(words, word.text, word.place(), name)?;
    Ok(word.place().end)
}

fn expected(
    words: &mut Words<'_>,
    found: &str,
    place: Range<usize>,
    name: &str,
) -> Result<(), Diagnostic> {
    if found.eq_ignore_ascii_case(name) {
        return Ok(());
    }
    Err(words.wrong(place, format!("`{name}` is expected here, and not `{found}`")).with_help(
        "a triangle is `facet normal x y z outer loop vertex x y z vertex x y z vertex x y z endloop \
         endfacet`",
    ))
}
