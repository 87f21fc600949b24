//! Reference values as CSV without comment lines.

use super::values::OracleValues;
use super::write::in_memory;
use std::io::{self, Write};

/// The values as CSV that `readtable` of MATLAB, pandas and spreadsheets take without options: one
/// line of names, `quantity,first,second,value,exact,hex`, and one line for each value. No column mixes numbers and
/// text: `first` and `second` are the indices, empty where there are fewer, and `value` is the
/// nearest f64.
///
/// ```
/// use subcert::oracle::{Boundary, Control, OracleRequest, reference_values, to_table};
/// use subcert::scheme::parse_scheme;
///
/// let request = OracleRequest {
///     scheme: "chaikin".to_owned(),
///     max_block: 1,
///     control: Control::seeded_polygon(1, 4),
///     level: 1,
///     boundary: Boundary::Closed,
/// };
/// let table = to_table(&reference_values(&parse_scheme("chaikin")?, &request)?);
/// assert!(table.starts_with("quantity,first,second,value,exact,hex\nmask,0,0,0.75,3/4,0x1.8p-1\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn to_table(values: &OracleValues) -> String {
    in_memory(|out| write_table(values, out))
}

/// Writes the text of [`to_table`].
///
/// # Errors
/// When writing to `out` fails.
pub fn write_table(values: &OracleValues, mut out: impl Write) -> io::Result<()> {
    writeln!(out, "quantity,first,second,value,exact,hex")?;
    for group in &values.groups {
        for value in &group.values {
            let index = |at: usize| value.index.get(at).map_or(String::new(), usize::to_string);
            let super::Value { exact, f64, hex, .. } = value;
            writeln!(out, "{},{},{},{f64},{exact},{hex}", group.quantity, index(0), index(1))?;
        }
    }
    Ok(())
}
