//! A report as a LaTeX document: an article with headings, paragraphs, lists and tables.

use super::latex::escape;
use crate::report::words::sheet::{Block, Grid, Sheet};
use std::fmt::Write as _;

const HEAD: &str = "\\documentclass{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\usepackage{amssymb,booktabs,graphicx,longtable}
\\setlength{\\parindent}{0pt}
\\setlength{\\parskip}{0.5\\baselineskip}
\\begin{document}
\\sloppy
";

/// The share of a line that columns of text take, together.
const TEXT_PERCENT: usize = 90;

impl Sheet {
    /// The report as a document, with the packages `amssymb`, `booktabs`, `graphicx` and `longtable`.
    ///
    /// ```
    /// use subcert::report::Sheet;
    ///
    /// let mut sheet = Sheet::default();
    /// sheet.heading(1, "T_1 < 1");
    /// assert!(sheet.to_latex_document().contains("\\section*{$T_{1}$ $<$ 1}\n"));
    /// ```
    #[must_use]
    pub fn to_latex_document(&self) -> String {
        let mut out = HEAD.to_owned();
        for block in &self.blocks {
            out.push('\n');
            match block {
                Block::Heading(level, text) => {
                    let sub = "sub".repeat(usize::from(level.saturating_sub(1).min(2)));
                    let _ = writeln!(out, "\\{sub}section*{{{}}}", lines(text, " "));
                }
                Block::Text(text) => {
                    let _ = writeln!(out, "{}\n", lines(text, " \\\\\n"));
                }
                Block::Facts(facts) => write_facts(facts, &mut out),
                Block::Grid(grid) => grid.write_document(&mut out),
            }
        }
        out.push_str("\n\\end{document}\n");
        out
    }
}

/// The lines of a text, with something between them; empty ones are left out.
fn lines(text: &str, between: &str) -> String {
    let lines = text.split('\n').filter(|line| !line.trim().is_empty()).map(escape);
    lines.collect::<Vec<String>>().join(between)
}

fn write_facts(facts: &[(String, String)], out: &mut String) {
    if facts.is_empty() {
        return;
    }
    out.push_str("\\begin{description}\n");
    for (name, value) in facts {
        // Braces, so that a value may begin with a bracket.
        let _ =
            writeln!(out, "\\item[{{{}}}] {{{}}}", lines(name, " "), lines(value, " \\newline "));
    }
    out.push_str("\\end{description}\n");
}

impl Grid {
    fn write_document(&self, out: &mut String) {
        let columns = self.header.len();
        if self.left_columns < columns {
            // Of numbers: as wide as they are, and no wider than a line.
            out.push_str(
                "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n",
            );
            self.write_latex(columns, out);
            out.push_str("}\n");
            return;
        }
        let share = TEXT_PERCENT / columns.max(1);
        let column = format!("p{{0.{share:02}\\linewidth}}");
        let _ = writeln!(out, "\\begin{{longtable}}{{{}}}\n\\toprule", column.repeat(columns));
        let row = |cells: &[String]| {
            let cells = cells.iter().map(|cell| lines(cell, " \\newline "));
            format!("{} \\\\\n", cells.collect::<Vec<String>>().join(" & "))
        };
        let _ = write!(out, "{}\\midrule\n\\endhead\n", row(&self.header));
        for cells in &self.rows {
            out.push_str(&row(cells));
        }
        out.push_str("\\bottomrule\n\\end{longtable}\n");
    }
}
