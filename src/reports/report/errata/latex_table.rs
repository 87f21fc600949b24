//! A table of a paper with corrected numbers, in LaTeX.

use crate::audit::{CellFinding, Sound, TableFinding, Verdict};
use crate::claim::Cell;
use crate::exact::{
    Rational, RealCyclotomic,
    format::{raised_digits, short},
};
use crate::report::errata::cells::correct;
use crate::report::output::latex::escape;
use std::fmt::Write as _;

/// A number of a corrected table.
enum Corrected {
    /// As it is printed.
    Printed(String),
    /// The value of the printed definition, in place of another number.
    Defined(String),
    /// The value that keeps the promise of the number, in place of one that does not.
    Kept(String),
    /// As it is printed; whether it is right is not known.
    Open(String),
    /// The source has lost it.
    Lost,
}

/// The table as LaTeX, for the packages `amssymb` and `booktabs`. A number that is as the printed definition gives it
/// stays as it is, and another one becomes the value of the definition, in bold. A bound or a depth also has to keep its
/// promise: where neither the printed number nor the definition is shown to, the sound bound or depth takes its place, in
/// bold with an asterisk. Bounds are rounded up. A question mark stands at numbers that are not checkable.
#[must_use]
pub fn corrected_table(finding: &TableFinding<'_>) -> String {
    let table = finding.table;
    let (mut out, promises) = (String::new(), table.promise.is_some());
    let rows: Vec<Vec<Corrected>> = finding
        .cells
        .iter()
        .zip(&table.cells)
        .map(|(row, cells)| {
            row.iter()
                .zip(cells)
                .map(|(cell, printed)| corrected(cell, printed, promises))
                .collect()
        })
        .collect();
    let title = if table.title.is_empty() { &table.locus } else { &table.title };
    let _ = writeln!(out, "% {}, corrected", one_line(&table.locus));
    let _ =
        writeln!(out, "\\begin{{table}}\n\\centering\n\\caption{{{}}}", escape(&one_line(title)));
    let count = table.columns.entries.len();
    let label = usize::from(table.rows.is_some());
    let _ = writeln!(
        out,
        "\\begin{{tabular}}{{{}{}}}\n\\toprule",
        "l".repeat(label),
        "r".repeat(count)
    );
    let header = table.columns.entries.iter().map(|entry| escape(&one_line(&entry.printed)));
    let corner = table.rows.as_ref().map(|rows| {
        escape(&format!("{} \\ {}", one_line(&rows.label), one_line(&table.columns.label)))
    });
    let header: Vec<String> = corner.into_iter().chain(header).collect();
    let _ = writeln!(out, "{} \\\\\n\\midrule", header.join(" & "));
    for (place, row) in rows.iter().enumerate() {
        let label = table.rows.as_ref().map(|rows| escape(&one_line(&rows.entries[place].printed)));
        let cells: Vec<String> =
            label.into_iter().chain(row.iter().map(Corrected::latex)).collect();
        let _ = writeln!(out, "{} \\\\", cells.join(" & "));
    }
    out.push_str("\\bottomrule\n\\end{tabular}\n\\end{table}\n");
    let says = [
        (
            rows.iter().flatten().any(|one| matches!(one, Corrected::Defined(_))),
            "bold: the value of the printed definition",
        ),
        (
            rows.iter().flatten().any(|one| matches!(one, Corrected::Kept(_))),
            "bold with *: a value that keeps the promise of the number",
        ),
        (rows.iter().flatten().any(|one| matches!(one, Corrected::Open(_))), "?: not checkable"),
    ];
    for (_, text) in says.into_iter().filter(|(is, _)| *is) {
        let _ = writeln!(out, "% {text}");
    }
    out
}

fn corrected(cell: &CellFinding, printed: &Cell, promises: bool) -> Corrected {
    let Some(number) = printed.printed() else { return Corrected::Lost };
    let text = number.text.clone();
    let is_right = matches!(cell.verdict, Verdict::Confirmed | Verdict::Reproduced);
    let exact = cell.exact.as_ref().filter(|_| !matches!(cell.verdict, Verdict::NotCheckable(_)));
    match exact {
        None => Corrected::Open(text),
        Some(_) if is_right && (!promises || cell.keeps_promise() == Some(true)) => {
            Corrected::Printed(text)
        }
        Some(exact) if !promises => Corrected::Defined(correct(Some(exact), number, promises)),
        Some(exact) => match &cell.sound {
            None | Some(Sound::None(_)) => Corrected::Open(text),
            Some(Sound::Depth { level, .. } | Sound::Least(level)) => {
                let is_enough = is_at_least(exact, &Rational::from(*level));
                if is_enough && !is_right {
                    Corrected::Defined(correct(Some(exact), number, promises))
                } else {
                    Corrected::Kept(level.to_string())
                }
            }
            Some(Sound::Bound(bound)) => match exact.as_rational() {
                Some(exact) if exact >= bound && !is_right => Corrected::Defined(above(exact)),
                _ => Corrected::Kept(above(bound)),
            },
        },
    }
}

fn is_at_least(value: &RealCyclotomic, least: &Rational) -> bool {
    value.as_rational().is_some_and(|value| value >= least)
}

/// A positive number rounded up, with six significant digits.
fn above(bound: &Rational) -> String {
    short(&raised_digits(bound, 6), 40)
}

impl Corrected {
    fn latex(&self) -> String {
        let number = |text: &str| escape(&one_line(text));
        match self {
            Corrected::Printed(text) => number(text),
            Corrected::Defined(text) => format!("\\textbf{{{}}}", number(text)),
            Corrected::Kept(text) => format!("\\textbf{{{}}}$^{{*}}$", number(text)),
            Corrected::Open(text) => format!("{}$^{{?}}$", number(text)),
            Corrected::Lost => "--".to_owned(),
        }
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<&str>>().join(" ")
}
