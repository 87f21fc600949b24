//! The meaning of headers, where their text does not say it.

use crate::claim::{Axis, AxisEntry, Headers, LocatedReference, Table};
use crate::exact::format::short;

/// The scheme of a table, or those of its headers that are not printed as references.
pub(crate) fn schemes(table: &Table) -> Option<(String, String)> {
    let of_axis = |axis: &Axis| {
        let named = axis.entries.iter().zip(axis.schemes());
        let named = named.map(|(entry, scheme)| (&entry.printed, scheme.reference.to_string()));
        let named = named.filter(|(printed, reference)| *printed != reference);
        named.map(|(printed, reference)| format!("{printed}: {reference}")).collect()
    };
    let mut lines: Vec<String> = table.scheme.iter().map(text).collect();
    lines.extend(table.axes().flat_map(|axis| -> Vec<String> { of_axis(axis) }));
    (!lines.is_empty()).then(|| ("scheme".to_owned(), lines.join("\n")))
}

/// The scheme of a cell.
pub(crate) fn scheme_at(table: &Table, (row, column): (usize, usize)) -> Option<(String, String)> {
    table.scheme_at(row, column).map(|located| ("scheme".to_owned(), text(located)))
}

fn text(located: &LocatedReference) -> String {
    located.reference.to_string()
}

/// The notes on the headers of an axis.
pub(crate) fn notes(axis: &Axis) -> Vec<String> {
    let note = |(place, entry): (usize, &AxisEntry)| {
        let (printed, note) = (&entry.printed, entry.note.as_ref()?);
        let means = match &axis.headers {
            Headers::Values { values, .. } => short(&values[place], 12),
            Headers::Schemes(schemes) => text(&schemes[place]),
        };
        Some(format!("The header {printed} is read as {means}: {note}."))
    };
    axis.entries.iter().enumerate().filter_map(note).collect()
}
