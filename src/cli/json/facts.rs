//! What `subcert atlas` writes.

use serde::Serialize;
use subcert::report::json::FactsForm;

/// The facts of all schemes of the catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Atlas<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The schemes, families at their samples.
    pub schemes: Vec<Entry<'a>>,
}

/// A scheme of the catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Entry<'a> {
    /// Its title.
    pub title: &'a str,
    /// Where it was published.
    pub source: &'a str,
    /// The facts; their fields stand here.
    #[serde(flatten)]
    pub facts: FactsForm,
}
