//! Theorems as JSON.

pub(super) mod by_hand;
pub(super) mod shift;
pub(super) mod theorem;
pub(super) mod witness;
