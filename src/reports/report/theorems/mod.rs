//! Theorems in words, with the data that refute them.

pub(super) mod by_hand;
pub(super) mod shift;
pub(super) mod theorem;
pub(super) mod witness;
