//! A report's content, free of its looks.

use super::notation::{pieces, unicode};
use std::fmt::Write as _;

/// A report: blocks from top to bottom.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sheet {
    /// The blocks.
    pub blocks: Vec<Block>,
}

/// A part of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A heading, of level 1 (the largest) to 3.
    Heading(u8, String),
    /// A paragraph.
    Text(String),
    /// Names with values, one on a line.
    Facts(Vec<(String, String)>),
    /// A table.
    Grid(Grid),
}

/// A table of texts; a cell may have several lines.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Grid {
    /// The column headers.
    pub header: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
    /// The number of leading columns that are aligned to the left.
    pub left_columns: usize,
}

impl Sheet {
    /// A report with this heading.
    #[must_use]
    pub fn titled(text: impl Into<String>) -> Sheet {
        Sheet { blocks: vec![Block::Heading(1, text.into())] }
    }

    /// Appends a heading.
    pub fn heading(&mut self, level: u8, text: impl Into<String>) {
        self.blocks.push(Block::Heading(level, text.into()));
    }

    /// Appends a paragraph.
    pub fn text(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// Appends notes, each as a paragraph.
    pub fn notes(&mut self, notes: &[String]) {
        for note in notes {
            self.text(format!("Note: {note}"));
        }
    }

    /// Appends names with values.
    pub fn facts(&mut self, facts: Vec<(String, String)>) {
        self.blocks.push(Block::Facts(facts));
    }

    /// Appends a table.
    pub fn grid(&mut self, grid: Grid) {
        self.blocks.push(Block::Grid(grid));
    }

    /// The report with the signs of print in place of those of the keyboard.
    pub(crate) fn in_print(&self) -> Sheet {
        let all = |texts: &[String]| texts.iter().map(|text| unicode(text)).collect();
        let block = |block: &Block| match block {
            Block::Heading(level, text) => Block::Heading(*level, unicode(text)),
            Block::Text(text) => Block::Text(unicode(text)),
            Block::Facts(facts) => {
                let fact = |(name, value): &(String, String)| (unicode(name), unicode(value));
                Block::Facts(facts.iter().map(fact).collect())
            }
            Block::Grid(grid) => Block::Grid(Grid {
                header: all(&grid.header),
                rows: grid.rows.iter().map(|row| all(row)).collect(),
                left_columns: grid.left_columns,
            }),
        };
        Sheet { blocks: self.blocks.iter().map(block).collect() }
    }

    /// The report as Markdown.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let mut out = String::new();
        for block in &self.blocks {
            if !out.is_empty() {
                out.push('\n');
            }
            match block {
                Block::Heading(level, text) => {
                    let _ = writeln!(out, "{} {}", "#".repeat(usize::from(*level)), escape(text));
                }
                Block::Text(text) => {
                    let _ = writeln!(out, "{}", escape(text));
                }
                Block::Facts(facts) => {
                    for (name, value) in facts {
                        let _ = writeln!(out, "- {}: {}", escape(name), escape(value));
                    }
                }
                Block::Grid(grid) => grid.write_markdown(&mut out),
            }
        }
        out
    }
}

/// Text that Markdown shows as it is.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for (place, line) in text.split('\n').enumerate() {
        if place > 0 {
            escaped.push_str("<br>");
        }
        for (piece, is_code) in pieces(line) {
            if is_code {
                // A bar would end a cell of a table.
                let _ = write!(escaped, "`{}`", piece.replace('|', "\\|"));
                continue;
            }
            for c in piece.chars() {
                match c {
                    '<' => escaped.push_str("&lt;"),
                    '*' | '_' | '|' | '\\' | '`' | '[' => escaped.extend(['\\', c]),
                    _ => escaped.push(c),
                }
            }
        }
    }
    escaped
}

impl Grid {
    /// A table with this header and these rows, whose first so many columns are aligned to the left.
    #[must_use]
    pub fn of(
        header: impl IntoIterator<Item: Into<String>>,
        rows: impl IntoIterator<Item = Vec<String>>,
        left_columns: usize,
    ) -> Grid {
        let header = header.into_iter().map(Into::into).collect();
        Grid { header, rows: rows.into_iter().collect(), left_columns }
    }

    fn write_markdown(&self, out: &mut String) {
        let line = |cells: &[String]| {
            let cell = |text: &String| escape(text);
            format!("| {} |\n", cells.iter().map(cell).collect::<Vec<String>>().join(" | "))
        };
        out.push_str(&line(&self.header));
        let rule = |column| if column < self.left_columns { "---" } else { "--:" };
        let rules: Vec<&str> = (0..self.header.len()).map(rule).collect();
        let _ = writeln!(out, "| {} |", rules.join(" | "));
        for row in &self.rows {
            out.push_str(&line(row));
        }
    }
}
