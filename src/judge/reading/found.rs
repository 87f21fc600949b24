//! What solving for parameters has found.

use crate::exact::Integer;
use crate::finding::Explanation;

/// What solving for parameters has found.
pub(crate) struct Found {
    pub(crate) explanations: Vec<Explanation>,
    /// How many readings were tried.
    pub(crate) tried: usize,
    /// How many tables the parameters give that differ in their printed form, where
    /// one cell is as printed, over all readings.
    pub(crate) candidates: Integer,
}
