//! Cells and readings of tables as JSON.

pub(crate) mod cell;
pub(super) mod promise;
pub(super) mod reading;
pub(super) mod recovered;
pub(super) mod working;
