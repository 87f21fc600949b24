//! Certificates: lines, and blocks of lines.

use super::reject::{At, Checked, Compared, Reason, Rejection, Text, agree, compare, require};
use super::verdict::Verdict;
use std::fmt::Display;

/// The first line of a certificate.
const VERSION: &str = "subcert-certificate 4";

/// The most bytes of a certificate.
pub const MAX_BYTES: usize = 64 << 20;

/// The most bytes of a line.
pub const MAX_LINE: usize = 1 << 16;

/// A line, without the blanks around it.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Its number, counted from 1.
    pub number: usize,
    /// Its text.
    pub text: &'a str,
}

impl<'a> Line<'a> {
    /// A rejection at this line.
    pub fn reject(&self, reason: Reason) -> Rejection {
        Rejection { line: self.number, reason }
    }

    /// The first word, and what follows it.
    pub fn word(&self) -> (&'a str, &'a str) {
        let (word, rest) = self.text.split_once(' ').unwrap_or((self.text, ""));
        (word, rest.trim_start())
    }
}

/// So many words of a line.
pub fn words<'t, const N: usize>(said: &'t str, what: &'static str) -> Checked<[&'t str; N]> {
    let words: Vec<&str> = said.split_whitespace().collect();
    words.try_into().map_err(|_| Reason::Malformed(what).into())
}

/// The line of a claim and the lines that are indented under it. A rule takes them one by one.
#[derive(Clone, Debug)]
pub struct Block<'a> {
    /// `table table-1`, …
    pub head: Line<'a>,
    lines: Vec<Line<'a>>,
    taken: usize,
    /// The number of the line at hand.
    pub at: usize,
}

impl<'a> Block<'a> {
    /// The next line, if there is one.
    pub fn peek(&self) -> Option<Line<'a>> {
        self.lines.get(self.taken).copied()
    }

    /// The first word of the next line. It is empty if there is no next line.
    pub fn next_word(&self) -> &'a str {
        self.peek().map_or("", |line| line.word().0)
    }

    /// Takes the next line if it begins with this word, and gives the rest of it.
    pub fn maybe(&mut self, word: &str) -> Option<&'a str> {
        let line = self.peek().filter(|line| line.word().0 == word)?;
        self.taken += 1;
        self.at = line.number;
        Some(line.word().1)
    }

    /// Moves to the next line without taking it, or to the head if there is none.
    pub fn look(&mut self) {
        self.at = self.peek().unwrap_or(self.head).number;
    }

    /// Takes the next line and gives the rest of it. The line has to begin with this word.
    pub fn after(&mut self, word: &'static str) -> Checked<&'a str> {
        self.look();
        self.maybe(word).ok_or(Reason::Malformed(word).into())
    }

    /// Takes the next line, and gives its first word and the rest.
    pub fn any(&mut self) -> Checked<(&'a str, &'a str)> {
        self.look();
        let line = self.peek().ok_or(Reason::Malformed("another line"))?;
        self.taken += 1;
        Ok(line.word())
    }

    /// Takes the next line. It has to repeat a text of the claim file; blanks may differ.
    pub fn restates(&mut self, word: &'static str, text: Option<&str>) -> Checked<()> {
        let said = self.after(word)?;
        let same = |text: &str| text.split_whitespace().eq(said.split_whitespace());
        compare(text.is_some_and(same), said, text.unwrap_or_default(), Reason::Restated)
    }

    /// The same, of a text that the claim file need not have. Without it there is no line.
    pub fn may_restate(&mut self, word: &'static str, text: Option<&str>) -> Checked<()> {
        if text.is_some() { self.restates(word, text) } else { Ok(()) }
    }

    /// Takes the next line. It has to be this word alone.
    pub fn word(&mut self, word: &'static str) -> Checked<()> {
        let rest = self.after(word)?;
        require(rest.is_empty(), Reason::Malformed(word))
    }

    /// Takes the next line. It has to be this verdict, with nothing behind it.
    pub fn verdict(&mut self, found: impl Display) -> Checked<()> {
        self.look();
        let said = self.peek().map_or("", |line| line.text);
        self.taken += 1;
        agree(said, &found.to_string(), Reason::Verdict)
    }

    /// All lines.
    pub fn lines(&self) -> &[Line<'a>] {
        &self.lines
    }

    /// Whether the verdict, which is the last line, is that the claim holds.
    pub fn holds(&self) -> bool {
        let last = self.lines.last().and_then(|line| Verdict::named(line.word().0));
        last.is_some_and(Verdict::holds)
    }

    /// Checks that every line has been taken.
    pub fn finished(&mut self) -> Checked<()> {
        self.look();
        require(self.peek().is_none(), Reason::Malformed("the end of the block"))
    }
}

/// The numbered lines of a certificate that stands alone, after its first one and without comments.
pub fn alone(text: &str) -> impl Iterator<Item = Line<'_>> {
    let lines = (1..).zip(text.lines().map(str::trim)).skip(1);
    let lines = lines.map(|(number, text)| Line { number, text });
    lines.filter(|line| !line.text.is_empty() && !line.text.starts_with('#'))
}

/// What a certificate is about, as its second line says: a paper or a project, and its key.
#[derive(Clone, Copy)]
pub enum About<'k> {
    /// The claims of a paper.
    Paper(&'k str),
    /// The constants of a project.
    Project(&'k str),
}

impl About<'_> {
    /// Checks the second line.
    fn check(self, line: Line<'_>) -> Checked<()> {
        let (kind, key, otherwise): (_, _, Compared) = match self {
            About::Paper(key) => ("paper", key, Reason::Paper),
            About::Project(key) => ("project", key, Reason::Project),
        };
        compare(line.word() == (kind, key), line.text, key, otherwise)
    }
}

/// The blocks of a certificate about this.
pub fn blocks<'a>(text: &'a str, about: About<'_>) -> Checked<Vec<Block<'a>>> {
    let mut number = 0;
    let blocks = read(text, about, &mut number);
    blocks.at(number.max(1))
}

/// Reads the blocks. It counts the lines up to the one that is wrong.
fn read<'a>(text: &'a str, about: About<'_>, number: &mut usize) -> Checked<Vec<Block<'a>>> {
    let (mut blocks, mut heads, mut ended) = (Vec::<Block<'a>>::new(), 0, false);
    require(text.len() <= MAX_BYTES, Reason::LongLine)?;
    for raw in text.lines() {
        *number += 1;
        let line = Line { number: *number, text: raw.trim() };
        require(raw.len() <= MAX_LINE, Reason::LongLine)?;
        if heads == 0 && line.text != VERSION {
            return Err(Reason::Version(Text(line.text.to_string())).into());
        }
        if line.text.is_empty() || line.text.starts_with('#') {
            continue;
        }
        require(!ended, Reason::AfterFooter)?;
        match (heads, line.word()) {
            (0, _) => heads = 1,
            (1, _) => {
                about.check(line)?;
                heads = 2;
            }
            _ if raw.starts_with(' ') => {
                blocks.last_mut().ok_or(Reason::Malformed("a claim"))?.lines.push(line);
            }
            (_, ("end", count)) => {
                agree(count, &blocks.len().to_string(), Reason::Count)?;
                ended = true;
            }
            _ => blocks.push(Block { head: line, lines: Vec::new(), taken: 0, at: *number }),
        }
    }
    *number += 1;
    require(ended, Reason::Truncated)?;
    Ok(blocks)
}
