//! What `subcert scheme` and `subcert atlas` write.

use super::range::Interval;
use serde::Serialize;
use subcert::report::json::FactsForm;

/// The facts of one scheme.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Facts<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The facts; their fields stand here.
    #[serde(flatten)]
    pub found: &'a FactsForm,
    /// Where in the parameter of its family the limits are C^m, m = 0, 1, …; of masks of the catalogue that are
    /// polynomial in the only parameter.
    pub ranges: Option<Ranges>,
}

/// Where in a parameter the limits are C^m.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Ranges {
    /// The parameter.
    pub parameter: String,
    /// The sets for m = 0, 1, …
    pub orders: Vec<Order>,
    /// Why there are no more.
    pub end: String,
}

/// Where the limits are C^m. What is in neither set is open.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Order {
    /// m.
    pub smoothness: usize,
    /// There they are.
    pub inside: Vec<Interval>,
    /// There not all of them are, but for finitely many values at most where that is said.
    pub outside: Vec<Interval>,
    /// Whether finitely many values outside may be exceptions.
    pub but_finitely_many: bool,
}

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
