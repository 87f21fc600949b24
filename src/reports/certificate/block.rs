//! Blocks: the lines about one claim.

use crate::claim::Paper;

/// The most bytes of a line.
const MAX_LINE: usize = 65_536;

/// A finding that certificates state.
pub(super) trait Certified {
    /// What the certificate of the paper says of the claim.
    fn block(&self, paper: &Paper) -> Block;
}

/// The lines about one claim, and why it cannot be certified, if it cannot.
pub(super) struct Block {
    kind: &'static str,
    id: String,
    lines: Vec<String>,
    /// Why the claim cannot be certified.
    fault: Option<String>,
}

impl Block {
    pub(super) fn new(kind: &'static str, id: &str) -> Block {
        Block { kind, id: id.to_owned(), lines: Vec::new(), fault: None }
    }

    /// A line of the block.
    pub(super) fn line(&mut self, text: impl Into<String>) {
        self.lines.push(text.into());
    }

    /// A line that repeats a text of the claim file, whose line ends count as blanks.
    pub(super) fn restate(&mut self, what: &str, text: &str) {
        self.line(format!("{what} {}", words(text)));
    }

    /// Gives up the claim; only the first reason is kept.
    pub(super) fn give_up(&mut self, why: impl Into<String>) {
        self.fault.get_or_insert_with(|| why.into());
    }

    /// Adds the line, or gives up the claim for this reason.
    pub(super) fn try_line(&mut self, line: Result<String, String>) {
        match line {
            Ok(line) => self.line(line),
            Err(why) => self.give_up(why),
        }
    }

    /// The claim's id.
    pub(super) fn id(&self) -> &str {
        &self.id
    }

    /// The block as text; or why there is none.
    pub(super) fn text(self) -> Result<String, String> {
        let Block { kind, id, lines, fault } = self;
        let mut text = format!("{kind} {id}\n");
        for line in &lines {
            if line.contains(['\n', '\r']) {
                return Err("a printed text has several lines".to_owned());
            }
            if line.len() + 2 > MAX_LINE {
                return Err(format!("a line would have more than {MAX_LINE} bytes"));
            }
            text.extend(["  ", line, "\n"]);
        }
        fault.map_or(Ok(text), Err)
    }
}

/// The words of a text, with one blank between them.
pub(super) fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<&str>>().join(" ")
}

/// A value as a formula without blanks.
pub(super) fn closed(value: &impl std::fmt::Display) -> String {
    value.to_string().split_whitespace().collect()
}
