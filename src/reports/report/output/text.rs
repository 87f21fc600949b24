//! A report for the terminal.

use super::fit::{Fitted, width_of, wrapped};
use crate::audit::{Standing, Word};
use crate::report::words::sheet::{Block, Grid, Sheet};
use anstyle::{AnsiColor, Style};
use comfy_table::{CellAlignment, LineStyle, Table, presets};
use std::fmt::Write as _;

const TITLE: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const FAIR: Style = AnsiColor::Yellow.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const FAINT: Style = Style::new().dimmed();

/// The widest line of running text.
const WIDTH: usize = 100;

/// The narrowest terminal that is written for.
const NARROWEST: usize = 30;

/// The indentation of names and tables.
const INDENT: &str = "  ";

impl Sheet {
    /// The report for a terminal, with ANSI styles; a writer that is no terminal
    /// has to strip them. No line is wider than `width`; without it, running text has lines of 100
    /// characters, and tables are as wide as they are.
    #[must_use]
    pub fn to_text(&self, width: Option<usize>) -> String {
        let lines = Lines { width: width.map(|width| width.max(NARROWEST)) };
        let mut out = String::new();
        let Sheet { blocks } = self.in_print();
        for (i, block) in blocks.iter().enumerate() {
            let after_heading =
                i > 0 && matches!(blocks[i - 1], Block::Heading(..) | Block::Text(_));
            if i > 0 && (!after_heading || matches!(block, Block::Heading(..))) {
                out.push('\n');
            }
            match block {
                Block::Heading(level, text) => lines.heading(&mut out, *level, text),
                Block::Text(text) => {
                    let text = lines.wrapped(text, 0).join("\n");
                    let _ = writeln!(out, "{}", coloured(&text));
                }
                Block::Facts(facts) => lines.facts(&mut out, INDENT, facts),
                Block::Grid(grid) => lines.grid(&mut out, grid),
            }
        }
        out
    }
}

/// How lines are laid out.
struct Lines {
    /// The widest line, where there is one.
    width: Option<usize>,
}

impl Lines {
    fn wrapped(&self, text: &str, indent: usize) -> Vec<String> {
        let width = self.width.map_or(WIDTH, |width| width.min(WIDTH));
        wrapped(text, width, indent, self.width.is_some())
    }

    fn heading(&self, out: &mut String, level: u8, text: &str) {
        let lines = match self.width {
            None => vec![text.to_owned()],
            Some(width) => wrapped(text, width, 0, true),
        };
        for line in &lines {
            let _ = writeln!(out, "{TITLE}{line}{TITLE:#}");
        }
        if level == 1 {
            let longest = lines.iter().map(|line| width_of(line)).max().unwrap_or(0);
            let _ = writeln!(out, "{}", "─".repeat(longest));
        }
    }

    /// Names with values beside them, or below them where names leave less than half of the width.
    fn facts(&self, out: &mut String, indent: &str, facts: &[(String, String)]) {
        let names = facts.iter().map(|(name, _)| width_of(name)).max().unwrap_or(0);
        let column = indent.len() + names + INDENT.len();
        let below = self.width.is_some_and(|width| 2 * column > width);
        for (name, value) in facts {
            if below {
                for line in self.wrapped(name, indent.len()) {
                    let _ = writeln!(out, "{indent}{}", coloured(&line));
                }
                for line in self.wrapped(value, indent.len() + INDENT.len()) {
                    let _ = writeln!(out, "{indent}{INDENT}{}", coloured(&line));
                }
            } else {
                let lines = self.wrapped(value, column).join(&format!("\n{}", " ".repeat(column)));
                let _ = writeln!(out, "{indent}{name:names$}{INDENT}{}", coloured(&lines));
            }
        }
    }

    fn grid(&self, out: &mut String, grid: &Grid) {
        let Some(width) = self.width else {
            out.push_str(&grid.to_text());
            return;
        };
        match grid.fitted(width - INDENT.len()) {
            Fitted::Tables(tables) => {
                let tables: Vec<String> = tables.iter().map(Grid::to_text).collect();
                out.push_str(&tables.join("\n"));
            }
            Fitted::Records(records) => {
                for (title, fields) in records {
                    for line in self.wrapped(&title, INDENT.len()) {
                        let _ = writeln!(out, "{INDENT}{}", coloured(&line));
                    }
                    self.facts(out, &INDENT.repeat(2), &fields);
                }
            }
        }
    }
}

/// With the marks of verdicts in their styles, which are put on after the layout, since this counts columns.
fn coloured(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        let _ = match style(character) {
            Some(style) => write!(out, "{style}{character}{style:#}"),
            None => write!(out, "{character}"),
        };
    }
    out
}

/// The style of a mark. A question mark and an equals sign are also punctuation.
fn style(mark: char) -> Option<Style> {
    let is_meant = |word: &&Word| !mark.is_ascii() && word.mark().starts_with(mark);
    Word::ALL.iter().find(is_meant).map(|word| match word.standing() {
        Standing::Holds => GOOD,
        Standing::Near => FAIR,
        Standing::Fails => BAD,
        Standing::Open => FAINT,
    })
}

impl Grid {
    fn to_text(&self) -> String {
        let mut table = Table::new();
        let several_lines = self.rows.iter().flatten().any(|cell| cell.contains('\n'));
        let style = presets::UTF8_HORIZONTAL_ONLY;
        table.load_style(if several_lines {
            style
        } else {
            style.row_separator(LineStyle::none())
        });
        table.set_header(&self.header);
        for row in &self.rows {
            table.add_row(row);
        }
        for (index, column) in table.column_iter_mut().enumerate() {
            let left = index < self.left_columns;
            column.set_cell_alignment(if left {
                CellAlignment::Left
            } else {
                CellAlignment::Right
            });
        }
        let drawn = table.to_string();
        let lines = drawn.lines().map(|line| format!("{INDENT}{}\n", line.trim_end()));
        coloured(&lines.collect::<String>())
    }
}
