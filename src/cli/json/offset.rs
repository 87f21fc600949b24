//! The JSON form of better offsets, which `subcert constants` and `subcert depth` write where a
//! file states no offset.

use serde::Serialize;
use subcert::report::json::Exact;

/// An offset that is better than 0, which is taken where a file states none.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BetterOffset<'a> {
    /// The file.
    pub file: &'a str,
    /// The offset with the least σ.
    pub offset: i64,
    /// σ at that offset.
    pub displacement: Exact,
    /// σ at offset 0.
    pub displacement_at_zero: Exact,
}
