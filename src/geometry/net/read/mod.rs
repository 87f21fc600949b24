//! Net files. Numbers are read from their text, exactly.

mod csv;
mod json;
mod parts;

use super::grid::{Closed, Net};
use crate::diagnostic::{Diagnostic, SourceText};
use parts::Parts;
use std::path::Path;
use std::sync::Arc;

/// The forms of net files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NetFormat {
    /// A row of the net on each line.
    Csv,
    /// Arrays of rows of points.
    Json,
}

impl NetFormat {
    /// The form of a file by its extension; `None` where it is not that of a net.
    #[must_use]
    pub fn of(path: &Path) -> Option<NetFormat> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" => Some(NetFormat::Csv),
            "json" => Some(NetFormat::Json),
            _ => None,
        }
    }

    /// The form of a text: JSON if it begins as an array or an object does.
    #[must_use]
    pub fn of_text(text: &str) -> NetFormat {
        let text = text.trim_start_matches('\u{feff}').trim_start();
        if text.starts_with(['[', '{']) { NetFormat::Json } else { NetFormat::Csv }
    }
}

/// Reads a net.
///
/// CSV has a row of the net on each line: its points separated by commas, the coordinates x y z of a
/// point by blanks; `#` begins a comment. JSON is an array of rows, each an array of points [x, y, z], or
/// an object with this as `points`, and `closed`: "none", "u", "v" or "uv". Numbers are decimals or
/// fractions, in JSON these as strings; all are read exactly. `closed` as given here goes before that of the
/// file; without both the net is open.
///
/// # Errors
/// When the text has another form, is cut off, has rows of different lengths, or its numbers are beyond
/// the caps; with the place, and mostly a remedy.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::net::{Closed, NetFormat, read_net};
///
/// let text = "0 0 0.1, 1 0 0\n0 1 0, 1 1 1/3\n";
/// let net = read_net(&SourceText::new("a.csv", text), NetFormat::Csv, None)?;
/// assert_eq!(net.points()[0][2].to_string(), "1/10");
/// let text = r#"{"closed": "v", "points": [[[0, 0, 1], [1, 0, "1/3"], [1, 1, 1]], [[0, 0, 0], [1, 0, 0], [1, 1, 0]]]}"#;
/// let net = read_net(&SourceText::new("a.json", text), NetFormat::Json, None)?;
/// assert_eq!((net.sizes(), net.closed()), ([2, 3], Closed { u: false, v: true }));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_net(
    source: &Arc<SourceText>,
    format: NetFormat,
    closed: Option<Closed>,
) -> Result<Net, Diagnostic> {
    let mut parts = Parts::new(source);
    let stated = match format {
        NetFormat::Csv => csv::read(&mut parts).map(|()| None),
        NetFormat::Json => json::read(&mut parts),
    }?;
    let help = match format {
        NetFormat::Csv => csv::HELP,
        NetFormat::Json => json::HELP,
    };
    parts.assemble(closed.or(stated).unwrap_or_default(), help)
}
