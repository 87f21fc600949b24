//! A report as LaTeX: its tables, with the rest as comments.

use crate::report::words::greek::greek;
use crate::report::words::notation::{Part, parts};
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
    let script = |sign: char, script: Option<&str>| match script {
        Some(script) => format!("{sign}{{{}}}", in_formula(script)),
        None => String::new(),
    };
    for part in parts(text) {
        let _ = match part {
            Part::Plain(text) => write!(escaped, "{}", plain(text)),
            Part::Code(text) => write!(escaped, "\\texttt{{{}}}", plain(text)),
            Part::Minus => write!(escaped, "-"),
            Part::Scripts { base: "log", below, above, .. } => {
                write!(escaped, "$\\log{}{}$", script('_', below), script('^', above))
            }
            Part::Scripts { base, below, above, .. } => {
                let base = in_formula(greek(base).unwrap_or(base));
                let (below, above) = (script('_', below), script('^', above));
                write!(escaped, "${base}{below}{above}$")
            }
        };
    }
    escaped
}

/// A text within a formula.
fn in_formula(text: &str) -> String {
    let sign = |c: char| math(c).map_or_else(|| c.to_string(), |command| format!("{command} "));
    text.chars().map(sign).collect::<String>().trim_end().to_owned()
}

fn plain(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
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
    }
    escaped
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
        'ϱ' => "\\varrho",
        'ι' => "\\iota",
        'υ' => "\\upsilon",
        'ϕ' => "\\phi",
        'Θ' => "\\Theta",
        'Ξ' => "\\Xi",
        'Π' => "\\Pi",
        'Υ' => "\\Upsilon",
        'ϵ' => "\\epsilon",
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
        '\u{2044}' | '\u{2215}' => "/",
        '½' => "\\frac12",
        '⅓' => "\\frac13",
        '⅔' => "\\frac23",
        '¼' => "\\frac14",
        '¾' => "\\frac34",
        '⅕' => "\\frac15",
        '⅖' => "\\frac25",
        '⅗' => "\\frac35",
        '⅘' => "\\frac45",
        '⅙' => "\\frac16",
        '⅚' => "\\frac56",
        '⅐' => "\\frac17",
        '⅛' => "\\frac18",
        '⅜' => "\\frac38",
        '⅝' => "\\frac58",
        '⅞' => "\\frac78",
        '⅑' => "\\frac19",
        '⅒' => "\\frac1{10}",
        _ => return None,
    })
}
