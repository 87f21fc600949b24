//! What is open, as JSON.

use serde::Serialize;

/// A fact that is open.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OpenForm {
    /// Which one.
    pub fact: &'static str,
    /// Why.
    pub reason: String,
}
