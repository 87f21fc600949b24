//! The JSON form of better offsets, which `subcert constants` and `subcert depth` write where a
//! file states no offset.

use serde::Serialize;
use subcert::report::json;

/// An offset that is better than 0, which is taken where a file states none.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BetterOffset<'a> {
    /// The file.
    pub file: &'a str,
    /// The better offset.
    #[serde(flatten)]
    pub better: json::BetterOffset,
}
