//! A report for the terminal.

use super::sheet::{Block, Grid, Sheet};
use anstyle::{AnsiColor, Style};
use comfy_table::{CellAlignment, LineStyle, Table, presets};
use std::fmt::Write as _;

const TITLE: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const FAIR: Style = AnsiColor::Yellow.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const FAINT: Style = Style::new().dimmed();

/// The marks, and how they look; put on after the layout, which counts columns.
const MARKS: [(&str, Style); 5] = [("✓", GOOD), ("≈", FAIR), ("±", FAIR), ("✗", BAD), ("?", FAINT)];

impl Sheet {
    /// The report for a terminal, with ANSI styles; a writer that is no terminal
    /// has to strip them.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        for (i, block) in self.blocks.iter().enumerate() {
            let after_heading =
                i > 0 && matches!(self.blocks[i - 1], Block::Heading(..) | Block::Text(_));
            if i > 0 && (!after_heading || matches!(block, Block::Heading(..))) {
                out.push('\n');
            }
            match block {
                Block::Heading(level, text) => {
                    let _ = writeln!(out, "{TITLE}{text}{TITLE:#}");
                    if *level == 1 {
                        let _ = writeln!(out, "{}", "─".repeat(text.chars().count()));
                    }
                }
                Block::Text(text) => {
                    let _ = writeln!(out, "{}", coloured(&wrapped(text, "")));
                }
                Block::Facts(facts) => {
                    let width = facts.iter().map(|(name, _)| name.chars().count()).max();
                    let width = width.unwrap_or(0);
                    for (name, value) in facts {
                        let value = wrapped(value, &" ".repeat(width + 4));
                        let _ = writeln!(out, "  {name:width$}  {}", coloured(&value));
                    }
                }
                Block::Grid(grid) => out.push_str(&grid.to_text()),
            }
        }
        out
    }
}

/// The widest line of running text.
const WIDTH: usize = 100;

/// The text with lines of at most [`WIDTH`] characters, all but the first
/// indented; a longer word has a line of its own.
fn wrapped(text: &str, indent: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for word in paragraph.split(' ') {
            let width = indent.len() + line.chars().count() + 1 + word.chars().count();
            if !line.is_empty() && width > WIDTH {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines.join(&format!("\n{indent}"))
}

fn coloured(text: &str) -> String {
    MARKS.iter().fold(text.to_owned(), |text, (mark, style)| {
        // A question mark is also punctuation: only one that stands alone is a mark.
        if *mark == "?" { text } else { text.replace(mark, &format!("{style}{mark}{style:#}")) }
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
        let lines = drawn.lines().map(|line| format!("  {}\n", line.trim_end()));
        coloured(&lines.collect::<String>())
    }
}
