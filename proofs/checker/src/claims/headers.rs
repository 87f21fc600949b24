//! The headers of tables, and indices with listed values.

#![warn(clippy::arithmetic_side_effects)]

use super::paper::printed;
use crate::formulas::is_name;
use crate::numbers::{Q, read_rational};
use crate::text::{Stop, Toml};

/// The headers of rows or of columns.
pub enum Headers<'a> {
    /// The values of a parameter.
    Values(Axis<'a>),
    /// References to schemes.
    Schemes(Vec<&'a str>),
}

/// A parameter with listed values.
pub struct Axis<'a> {
    /// The name of the parameter.
    pub name: &'a str,
    /// The values as read, and as numbers.
    pub entries: Vec<(&'a str, Q)>,
}

impl<'a> Headers<'a> {
    /// Reads headers. They are numbers or schemes, and not both.
    pub fn read(table: &'a Toml) -> Result<Headers<'a>, Stop> {
        if table.get("schemes").is_none() {
            return Ok(Headers::Values(Axis::read(table)?));
        }
        let other = ["name", "values", "from", "to"].iter().any(|key| table.get(key).is_some());
        let scheme = |field: &'a Toml| field.as_text().or_else(|| field.text("scheme"));
        let schemes: Option<Vec<&str>> = table.list("schemes").iter().map(scheme).collect();
        match schemes {
            Some(schemes) if !other && !schemes.is_empty() => Ok(Headers::Schemes(schemes)),
            _ => Err(Stop::Wrong("headers that are `schemes` are these alone".into())),
        }
    }

    /// Reads the headers of the rows and of the columns of a table, as far as it has them.
    pub fn of(claim: &'a Toml) -> Result<Vec<Headers<'a>>, Stop> {
        let axes = ["rows", "columns"].into_iter().filter_map(|axis| claim.get(axis));
        axes.map(Headers::read).collect()
    }

    /// The number of headers.
    pub fn count(&self) -> usize {
        match self {
            Headers::Values(axis) => axis.entries.len(),
            Headers::Schemes(schemes) => schemes.len(),
        }
    }

    /// The parameter with its values, if there is one.
    pub fn axis(&self) -> Option<&Axis<'a>> {
        match self {
            Headers::Values(axis) => Some(axis),
            Headers::Schemes(_) => None,
        }
    }

    /// The schemes; none if the headers are numbers.
    pub fn schemes(&self) -> &[&'a str] {
        match self {
            Headers::Values(_) => &[],
            Headers::Schemes(schemes) => schemes,
        }
    }
}

impl<'a> Axis<'a> {
    /// Reads a parameter with listed values.
    pub fn read(table: &'a Toml) -> Result<Axis<'a>, Stop> {
        let entry = |field: &'a Toml| {
            let (_, read) = printed(field)?;
            Some((read, read_rational(read)?))
        };
        let entries: Option<Vec<(&str, Q)>> = table.list("values").iter().map(entry).collect();
        let other = ["schemes", "from", "to"].iter().any(|key| table.get(key).is_some());
        match (table.text("name"), entries) {
            (Some(name), Some(entries)) if is_name(name) && !entries.is_empty() && !other => {
                Ok(Axis { name, entries })
            }
            _ => Err(Stop::Wrong("`name` and `values` of headers are missing".into())),
        }
    }
}
