//! Papers: an audit at first sight, its report, one claim in full, coverage, and the head with its counts.

pub(super) mod audit;
pub(super) mod brief;
pub(super) mod consistency;
pub(super) mod coverage;
pub(super) mod explain;
pub(super) mod headline;
pub(super) mod overview;
pub(super) mod summary;
