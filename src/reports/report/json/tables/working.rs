//! The values from which a cell is computed.

use crate::audit;
use crate::report::json::exact::{Exact, Named};
use serde::Serialize;

/// The values from which a cell is computed by the printed definition.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Working {
    /// The scheme, its parameters with their values; both factors of a tensor product.
    pub scheme: Vec<String>,
    /// The headers and parameters that its formulas use.
    pub parameters: Named<Exact>,
    /// The definitions that its formula uses, but for those that depend on the index of a sum.
    pub definitions: Named<Exact>,
}

impl Working {
    pub(crate) fn of(working: &audit::Working) -> Working {
        let parameters = working.parameters.iter();
        let definitions = working.definitions.iter();
        Working {
            scheme: working.scheme.iter().map(ToString::to_string).collect(),
            parameters: Named(parameters.map(|(n, value)| (n.clone(), Exact::of(value))).collect()),
            definitions: Named(
                definitions.map(|(n, value)| (n.clone(), Exact::of(value))).collect(),
            ),
        }
    }
}
