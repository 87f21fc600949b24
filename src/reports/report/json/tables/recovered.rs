//! Parameters that a paper does not state.

use crate::audit::{self, RecoveredFrom};
use serde::Serialize;

/// The value of a parameter that the paper does not state.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Recovered<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its value.
    pub value: String,
    /// The lower end of the values that fit the numbers of the table; null where these were not
    /// solved for it.
    pub from: Option<String>,
    /// The upper end of these values.
    pub to: Option<String>,
    /// The id of the table that gives the value; null where this table itself does.
    pub table: Option<&'a str>,
}

/// Values of parameters that fit some cells of a table.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Fitting<'a> {
    /// The parameters with these values.
    pub parameters: Vec<Recovered<'a>>,
    /// How many cells a reading gives there.
    pub cells: usize,
}

impl<'a> Fitting<'a> {
    pub(crate) fn of(fitting: &'a audit::Fitting) -> Fitting<'a> {
        let parameters = fitting.values.iter().map(Recovered::of).collect();
        Fitting { parameters, cells: fitting.cells }
    }
}

impl<'a> Recovered<'a> {
    pub(crate) fn of((name, recovered): (&'a String, &'a audit::Recovered)) -> Recovered<'a> {
        let (from, to, table) = match &recovered.from {
            RecoveredFrom::Solved(low, high) => {
                (Some(low.to_string()), Some(high.to_string()), None)
            }
            RecoveredFrom::Table { id, .. } => (None, None, Some(id.as_str())),
            RecoveredFrom::Tried => (None, None, None),
        };
        Recovered { name, value: recovered.value.to_string(), from, to, table }
    }
}
