//! Tags in OBJ, as OpenSubdiv's own test shapes have them: `t NAME I/F/S`, then I whole numbers, F
//! numbers and S words. Vertices and faces are counted from 0 there.

use super::super::crease::{Boundary, Creasing, Sharpness};
use super::assemble::{Extras, Tag};
use super::lines::{Lines, Word, extent};
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;

const HELP: &str = "tags are, say, `t crease 2/1/0 0 1 2.5`, `t corner 1/1/0 4 10`, `t hole 1/0/0 3`, \
                    `t interpolateboundary 1/0/0 2` and `t creasemethod 0/0/1 chaikin`";

/// The parts of a tag.
struct Parsed<'a> {
    lines: &'a Lines<'a>,
    line: &'a [Word<'a>],
    wholes: Vec<usize>,
    numbers: Vec<Rational>,
    words: Vec<&'a str>,
}

pub(super) fn read(
    lines: &Lines<'_>,
    line: &[Word<'_>],
    words: &[Word<'_>],
    extras: &mut Extras,
) -> Result<(), Diagnostic> {
    let [name, counts, rest @ ..] = words else {
        return Err(lines.wrong(extent(line), "a tag without a name or counts").with_help(HELP));
    };
    let tag = Parsed::new(lines, line, *counts, rest)?;
    let place = extent(line);
    match name.text {
        "crease" => {
            let pairs = tag.wholes.len() / 2;
            let sharp = tag.sharpness(pairs, tag.wholes.len() % 2 == 0)?;
            for (ends, sharp) in tag.wholes.chunks_exact(2).zip(sharp) {
                extras.tags.push((Tag::Crease([ends[0], ends[1]], sharp), place.clone()));
            }
        }
        "corner" => {
            let sharp = tag.sharpness(tag.wholes.len(), true)?;
            for (&vertex, sharp) in tag.wholes.iter().zip(sharp) {
                extras.tags.push((Tag::Corner(vertex, sharp), place.clone()));
            }
        }
        "hole" => {
            let faces = tag.wholes.iter().map(|face| (Tag::Hole(*face), place.clone()));
            extras.tags.extend(faces);
        }
        "interpolateboundary" => {
            extras.rules.boundary = match tag.wholes[..] {
                [0] => Boundary::None,
                [1] => Boundary::Corner,
                [2] => Boundary::Edge,
                _ => {
                    return Err(
                        tag.wrong("0 (none), 1 (edges and corners) or 2 (edges) is expected")
                    );
                }
            };
        }
        "creasemethod" => {
            extras.rules.creasing = match tag.words[..] {
                ["normal"] => Creasing::Uniform,
                ["chaikin"] => Creasing::Chaikin,
                _ => return Err(tag.wrong("`normal` or `chaikin` is expected")),
            };
        }
        "smoothtriangles" if tag.wholes[..] == [0] => {}
        "facevaryinginterpolateboundary" if tag.wholes[..] == [5] => {}
        "facevaryinginterpolateboundary" | "facevaryingpropagatecorners" => {
            extras.notes.push(format!(
                "the tag `{}` is passed over: texture coordinates are refined linearly on each face",
                name.text
            ));
        }
        other => {
            let message = format!("the tag `{other}` is not supported");
            return Err(lines.wrong(name.place(), message).with_help(HELP));
        }
    }
    Ok(())
}

impl<'a> Parsed<'a> {
    fn new(
        lines: &'a Lines<'a>,
        line: &'a [Word<'a>],
        counts: Word<'a>,
        rest: &'a [Word<'a>],
    ) -> Result<Parsed<'a>, Diagnostic> {
        let sizes: Option<Vec<usize>> =
            counts.text.split('/').map(|count| count.parse().ok()).collect();
        let mut sizes = sizes.filter(|sizes| (2..=3).contains(&sizes.len())).ok_or_else(|| {
            let message = "how many whole numbers, numbers and words follow is expected here";
            lines.wrong(counts.place(), message).with_help(HELP)
        })?;
        sizes.resize(3, 0);
        let total: u128 = sizes.iter().map(|&size| size as u128).sum();
        if total != rest.len() as u128 {
            let message =
                format!("`{}` announces {total} values, and {} follow", counts.text, rest.len());
            return Err(lines.wrong(extent(line), message).with_help(HELP));
        }
        let (wholes, rest) = rest.split_at(sizes[0]);
        let (numbers, words) = rest.split_at(sizes[1]);
        let what = "a vertex, a face or a choice, counted from 0,";
        Ok(Parsed {
            lines,
            line,
            wholes: wholes
                .iter()
                .map(|word| lines.natural(*word, what))
                .collect::<Result<_, _>>()?,
            numbers: numbers.iter().map(|word| lines.number(*word)).collect::<Result<_, _>>()?,
            words: words.iter().map(|word| word.text).collect(),
        })
    }

    fn wrong(&self, message: impl Into<String>) -> Diagnostic {
        self.lines.wrong(extent(self.line), message).with_help(HELP)
    }

    /// A sharpness for each of `count` things: one for all, or one for each.
    fn sharpness(&self, count: usize, even: bool) -> Result<Vec<Option<Sharpness>>, Diagnostic> {
        if count == 0 || !even || !(self.numbers.len() == 1 || self.numbers.len() == count) {
            return Err(self.wrong(
                "pairs of vertices for creases, vertices for corners, and one sharpness for all, or \
                 one for each, are expected",
            ));
        }
        if let Some(number) = self.numbers.iter().find(|number| number.sign() < 0) {
            return Err(self.wrong(format!("the sharpness {number} is below 0")));
        }
        let of = |i: usize| Sharpness::new(&self.numbers[i % self.numbers.len()]);
        Ok((0..count).map(of).collect())
    }
}
