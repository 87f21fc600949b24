//! The JSON form of an offset that is better than 0.

use super::exact::Exact;
use crate::bound;
use serde::Serialize;

/// An offset that is better than 0, which is taken where none is stated.
#[derive(Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BetterOffset {
    /// The offset with the least σ.
    pub offset: i64,
    /// σ at that offset.
    pub displacement: Exact,
    /// σ at offset 0.
    pub displacement_at_zero: Exact,
}

impl BetterOffset {
    /// The JSON form of a better offset.
    #[must_use]
    pub fn of(better: &bound::BetterOffset) -> BetterOffset {
        BetterOffset {
            offset: better.offset,
            displacement: Exact::of(&better.least),
            displacement_at_zero: Exact::of(&better.at_zero),
        }
    }
}
