//! Tables of numbers in words: readings, promises, and what a cell is computed from.

pub(super) mod eye;
pub(super) mod headers;
pub(super) mod promise;
pub(super) mod reading;
pub(super) mod tried;
pub(super) mod working;
