//! Reference values as JSON and CSV.

use super::header::Header;
use super::values::OracleValues;
use crate::mesh::one_line;
use std::io::{self, Write};

/// The values as indented JSON: an object of `schema`, `header` and `groups`, its keys in the
/// order of the fields of [`OracleValues`]. Every exact value is a string.
///
/// # Panics
/// Never: writing to memory does not fail.
#[must_use]
pub fn to_json(values: &OracleValues) -> String {
    in_memory(|out| write_json(values, out))
}

/// The values as CSV: comment lines with `#` that say what was computed, then the columns
/// `quantity,index,exact,decimal,f64,hex`. Several indices are separated by `:`.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::oracle::{Boundary, Control, OracleRequest, reference_values, to_csv};
/// use subcert::scheme::parse_scheme;
///
/// let request = OracleRequest {
///     scheme: "chaikin".to_owned(),
///     max_block: 1,
///     control: Control::seeded_polygon(1, 4),
///     level: 1,
///     boundary: Boundary::Closed,
/// };
/// let csv = to_csv(&reference_values(&parse_scheme("chaikin")?, &request)?);
/// assert!(csv.contains("\nmask,0:1,1/4,2.5000000000000000e-1,0.25,0x1p-2\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn to_csv(values: &OracleValues) -> String {
    in_memory(|out| write_csv(values, out))
}

pub(super) fn in_memory(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> String {
    let mut out = Vec::new();
    write(&mut out).expect("memory takes every write");
    String::from_utf8(out).expect("text was written")
}

/// Writes the text of [`to_json`].
///
/// # Errors
/// When writing to `out` fails.
pub fn write_json(values: &OracleValues, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut out, values)?;
    out.write_all(b"\n")
}

/// Writes the text of [`to_csv`].
///
/// # Errors
/// When writing to `out` fails.
pub fn write_csv(values: &OracleValues, mut out: impl Write) -> io::Result<()> {
    for (key, value) in header_lines(&values.header) {
        writeln!(out, "# {key}: {}", one_line(&value))?;
    }
    for group in &values.groups {
        writeln!(out, "# {}: {}", group.quantity, group.about)?;
    }
    writeln!(out, "quantity,index,exact,decimal,f64,hex")?;
    for group in &values.groups {
        for value in &group.values {
            let index: Vec<String> = value.index.iter().map(usize::to_string).collect();
            let (quantity, index) = (&group.quantity, index.join(":"));
            let super::Value { exact, decimal, f64, hex, .. } = value;
            writeln!(out, "{quantity},{index},{exact},{decimal},{f64},{hex}")?;
        }
    }
    Ok(())
}

pub(super) fn header_lines(header: &Header) -> Vec<(&'static str, String)> {
    let masks = header
        .masks
        .iter()
        .map(|mask| format!("arity {}, width {}, offset {}", mask.arity, mask.width, mask.offset));
    let rings = header.ring.iter().map(|ring| {
        let edges = ring.edges.iter().map(|(a, b)| format!("{a}-{b}")).collect::<Vec<String>>();
        format!("points {}, edges {}", ring.points.join(" "), edges.join(" "))
    });
    let mut lines = vec![
        ("program", header.program.clone()),
        ("scheme", header.scheme.clone()),
        ("shape", masks.chain(rings).collect::<Vec<String>>().join("; ")),
        ("max_block", header.max_block.to_string()),
        ("level", header.level.to_string()),
        ("boundary", header.boundary.unwrap_or_default().to_owned()),
        ("seed", header.seed.clone().unwrap_or_else(|| "none, the control was given".to_owned())),
        ("first_index", header.first_index.join(":")),
        ("notes", header.notes.join("; ")),
        ("columns", header.columns.to_owned()),
    ];
    lines.retain(|(_, text)| !text.is_empty());
    lines
}
