//! A report as LaTeX: its tables, with the rest as comments.

use crate::report::words::sheet::{Block, Grid, Sheet};
use std::fmt::Write as _;

impl Sheet {
    /// The tables of the report as `tabular`, for the packages `amssymb` and `booktabs`; headings and
    /// text are comments.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let mut out = String::new();
        for block in &self.blocks {
            match block {
                Block::Heading(_, text) => {
                    let _ = writeln!(out, "\n% {}", one_line(text));
                }
                Block::Text(text) => {
                    let _ = writeln!(out, "% {}", one_line(text));
                }
                Block::Facts(facts) => {
                    let row = |(name, value): &(String, String)| vec![name.clone(), value.clone()];
                    let grid = Grid::of([""; 0], facts.iter().map(row), 2);
                    grid.write_latex(2, &mut out);
                }
                Block::Grid(grid) => grid.write_latex(grid.header.len(), &mut out),
            }
        }
        out.trim_start().to_owned()
    }
}

impl Grid {
    pub(crate) fn write_latex(&self, columns: usize, out: &mut String) {
        let alignment = |column| if column < self.left_columns { 'l' } else { 'r' };
        let alignment: String = (0..columns).map(alignment).collect();
        let _ = writeln!(out, "\\begin{{tabular}}{{{alignment}}}\n\\toprule");
        if !self.header.is_empty() {
            write_row(&self.header, out);
            out.push_str("\\midrule\n");
        }
        self.rows.iter().for_each(|row| write_row(row, out));
        out.push_str("\\bottomrule\n\\end{tabular}\n");
    }
}

/// A row; a cell of several lines takes several rows, which are filled from above.
fn write_row(row: &[String], out: &mut String) {
    let cells: Vec<Vec<&str>> = row.iter().map(|cell| cell.split('\n').collect()).collect();
    let height = cells.iter().map(Vec::len).max().unwrap_or(0);
    for line in 0..height {
        let texts = cells.iter().map(|cell| escape(cell.get(line).copied().unwrap_or_default()));
        let _ = writeln!(out, "{} \\\\", texts.collect::<Vec<String>>().join(" & "));
    }
}

fn one_line(text: &str) -> String {
    text.replace('\n', " ")
}

/// Text that LaTeX shows as it is, with mathematical signs, and indices such as that of `T_c`.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    let mut rest = text;
    let mut after_letter = false;
    while let Some(c) = rest.chars().next() {
        let indexed = (!after_letter).then(|| index_of(rest)).flatten();
        if let Some((index, length)) = indexed {
            let letter = math(c).map_or_else(|| c.to_string(), str::to_owned);
            let _ = write!(escaped, "${letter}_{{{index}}}$");
            rest = &rest[length..];
            continue;
        }
        match math(c) {
            Some(command) => {
                let _ = write!(escaped, "${command}$");
            }
            None => match c {
                '\\' => escaped.push_str("\\textbackslash{}"),
                '~' => escaped.push_str("\\textasciitilde{}"),
                '^' => escaped.push_str("\\textasciicircum{}"),
                '&' | '%' | '$' | '#' | '_' | '{' | '}' => escaped.extend(['\\', c]),
                _ => escaped.push(c),
            },
        }
        after_letter = c.is_alphanumeric();
        rest = &rest[c.len_utf8()..];
    }
    escaped
}

/// The index of a letter at the start of a text, and how many bytes the two take.
fn index_of(text: &str) -> Option<(&str, usize)> {
    let letter = text.chars().next().filter(|c| c.is_alphabetic())?;
    let index = text[letter.len_utf8()..].strip_prefix('_')?;
    let end = index.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(index.len());
    (end > 0).then(|| (&index[..end], letter.len_utf8() + 1 + end))
}

/// The command of a sign in mathematical mode.
fn math(c: char) -> Option<&'static str> {
    Some(match c {
        '✓' => "\\checkmark",
        '✗' | '×' => "\\times",
        '≈' => "\\approx",
        '±' => "\\pm",
        '⇄' => "\\rightleftarrows",
        '≤' => "\\leq",
        '≥' => "\\geq",
        '<' => "<",
        '>' => ">",
        '|' => "|",
        '∞' => "\\infty",
        '‖' => "\\Vert",
        '·' => "\\cdot",
        '−' => "-",
        '→' => "\\to",
        '…' => "\\dots",
        'Δ' => "\\Delta",
        'Λ' => "\\Lambda",
        'Σ' => "\\Sigma",
        'α' => "\\alpha",
        'β' => "\\beta",
        'γ' => "\\gamma",
        'δ' => "\\delta",
        'ε' => "\\varepsilon",
        'η' => "\\eta",
        'λ' => "\\lambda",
        'μ' => "\\mu",
        'ν' => "\\nu",
        'ξ' => "\\xi",
        'σ' => "\\sigma",
        'ς' => "\\varsigma",
        'τ' => "\\tau",
        'ω' => "\\omega",
        'ζ' => "\\zeta",
        'θ' => "\\theta",
        'ϑ' => "\\vartheta",
        'κ' => "\\kappa",
        'π' => "\\pi",
        'ρ' => "\\rho",
        'φ' => "\\varphi",
        'χ' => "\\chi",
        'ψ' => "\\psi",
        'Γ' => "\\Gamma",
        'Φ' => "\\Phi",
        'Ψ' => "\\Psi",
        'Ω' => "\\Omega",
        '≠' => "\\neq",
        '√' => "\\surd",
        '∈' => "\\in",
        '′' => "{}'",
        '¹' => "{}^1",
        '²' => "{}^2",
        '³' => "{}^3",
        'ᵏ' => "{}^k",
        _ => return None,
    })
}
