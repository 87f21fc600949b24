//! What follows from findings: how claims stand, a summary of cells, the coverage of a paper,
//! contradictions between tables, and errata.

mod cause;
pub(crate) mod claims;
pub(crate) mod consistency;
mod coverage;
mod errata;
mod luck;
pub(crate) mod premises;
mod summary;

pub use cause::{Cause, HowRead};
pub use claims::ClaimVerdict;
pub use coverage::{Coverage, CoverageState};
pub use errata::{CellErratum, Consequences, Errata, Erratum, Subject, Unchecked};
pub use summary::{CellGroup, CellOutcome, CellSummary, Standing};
