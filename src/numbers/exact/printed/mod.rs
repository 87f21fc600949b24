//! Numbers as they are printed.

pub(super) mod decimal;
pub(super) mod error;
pub(super) mod read;
