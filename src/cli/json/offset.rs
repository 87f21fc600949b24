//! What `subcert constants` and `subcert depth` write of an offset that a file leaves out.

use serde::Serialize;
use subcert::report::json::Exact;

/// A better offset than 0, which is taken where a file states none.
#[derive(Serialize)]
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
