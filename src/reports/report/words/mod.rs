//! What all words share: sheets, numbers, sets, data.

pub(super) mod data;
pub(super) mod greek;
pub(super) mod kernel;
pub(super) mod look;
pub(super) mod notation;
pub(super) mod numbers;
pub(super) mod parts;
mod radical;
pub(super) mod set;
pub(super) mod sheet;
