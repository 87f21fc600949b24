//! Tables and test vectors as source code.

use super::arrays::{Array, are_consecutive, arrays};
use super::language::Language;
use super::real::RealType;
use super::rows::{Row, TableError};
use super::writer::Writer;
use crate::scheme::{notes, split_name};

/// What the header of a table says of where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The command that writes the table.
    pub command: &'a str,
}

/// A table of rows of consecutive valences as source code. The first lines say how to check it.
///
/// # Errors
/// When the rows have different orbits, or too many weights.
///
/// # Panics
/// When there are no rows, or the language has no numbers of the type ([`Language::types`]).
///
/// ```
/// use subcert::spectrum::{surroundings, table::{Language, Origin, RealType, Row, write}};
///
/// let rows = (3..=4).map(|n| Row::of(&surroundings("loop", Some(n))?)).collect::<Result<Vec<_>, _>>()?;
/// let origin = Origin { scheme: "loop", command: "subcert table loop --valences 3..4 --format rust" };
/// let text = write(&rows, Language::Rust, RealType::F64, &origin)?;
/// assert!(text.contains("pub const SUBDOMINANT: [f64; 2] = [0.25, 0.375];"));
/// # Ok::<(), subcert::spectrum::table::TableError>(())
/// ```
pub fn write(
    rows: &[Row],
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> Result<String, TableError> {
    write_without(rows, &[], language, real, origin)
}

/// The same of ascending valences, with a list of them where some are missing; the first lines say which are left out, and why.
///
/// # Errors
/// As [`write()`].
///
/// # Panics
/// When there are no rows.
pub fn write_without(
    rows: &[Row],
    left_out: &[(usize, String)],
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> Result<String, TableError> {
    let arrays = arrays(rows, real)?;
    let (first, last) = (rows[0].valence, rows[rows.len() - 1].valence);
    let valence = |n: usize| i64::try_from(n).expect("a small valence");
    let constants = vec![("first_valence", valence(first)), ("last_valence", valence(last))];
    let name = identifier(origin.scheme);
    let writer = Writer { language, real, name, constants, vectors: false };
    let mut header = header(rows, real, origin);
    header
        .extend(left_out.iter().map(|(valence, why)| format!("Without valence {valence}: {why}.")));
    Ok(writer.written(&header, &arrays))
}

/// Test vectors as source code, with whole numbers before the arrays: f64, and integers. A test need not use all of them, and they may be
/// long: in C and Rust there is no warning of those that are not used, and in Rust they are statics.
///
/// ```
/// use subcert::spectrum::table::{Array, Entries, Language, write_vectors};
///
/// let rows = vec![(vec![1.0 / 3.0], "1/3".to_owned())];
/// let entries = Entries::Noted { rows, list: true };
/// let array = Array { name: "weights", about: vec!["one third".to_owned()], entries };
/// let text = write_vectors(Language::C, "third", vec![("level", 1)], &[], &[array]);
/// assert!(text.contains("static const double third_weights[1] = {\n    0x1.5555555555555p-2, // 1/3\n};"));
/// ```
///
/// # Panics
/// When the language has no f64 ([`Language::types`]).
#[must_use]
pub fn write_vectors(
    language: Language,
    name: &str,
    constants: Vec<(&'static str, i64)>,
    header: &[String],
    arrays: &[Array<'_>],
) -> String {
    let (real, name) = (RealType::F64, name.to_owned());
    Writer { language, real, name, constants, vectors: true }.written(header, arrays)
}

/// The lines at the head of a table.
fn header(rows: &[Row], real: RealType, origin: &Origin<'_>) -> Vec<String> {
    let (first, last) = (rows[0].valence, rows[rows.len() - 1].valence);
    let mut lines = vec![format!(
        "Weights and stencils of {} by valence n = {first}, ..., {last}.",
        origin.scheme
    )];
    lines.extend(notes(origin.scheme).iter().map(|note| format!("Note: {note}.")));
    lines.extend(number_lines(real, origin));
    let row = if are_consecutive(rows) {
        format!("Row n - {first} of a table is that of valence n.")
    } else {
        "Row i of a table is that of valence[i].".to_owned()
    };
    lines.extend([
        format!("    subcert spectrum {} --valence n --format json", quoted(origin.scheme)),
        format!("{row} The cross product of tangent 1 and tangent 2"),
        "is a normal; a common positive factor of both is free.".to_owned(),
    ]);
    lines
}

/// What the numbers are, and how to check them. The command that writes exact values follows.
pub(super) fn number_lines(real: RealType, origin: &Origin<'_>) -> [String; 4] {
    let (name, bits) = match real {
        RealType::F32 => ("f32", 32),
        RealType::F64 => ("f64", 64),
    };
    [
        format!("Every number is the {name} (IEEE 754, {bits} bits) nearest to its exact value."),
        format!("Written by subcert {}:", env!("CARGO_PKG_VERSION")),
        format!("    {}", origin.command),
        "To check a copy, write it again by this command and compare; the exact values are written by"
            .to_owned(),
    ]
}

/// The text as one word of a shell.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,".contains(c);
    if text.chars().all(plain) { text.to_owned() } else { format!("'{text}'") }
}

/// The name of a scheme as an identifier: that of a file is its stem.
pub(super) fn identifier(scheme: &str) -> String {
    let (name, _) = split_name(scheme);
    let path = name.strip_suffix(".toml");
    let name = path.map_or(name, |path| path.rsplit(['/', '\\']).next().unwrap_or_default());
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = name.chars().map(plain).collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("s_{name}") }
}
