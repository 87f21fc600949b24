//! What follows from findings: how claims stand, a summary of cells, the coverage of a paper,
//! contradictions between tables, errata, and what Coq's kernel accepts.

mod beyond;
mod cause;
pub(crate) mod claims;
pub(crate) mod consistency;
mod coverage;
mod errata;
pub(crate) mod kernel;
mod luck;
pub(crate) mod offset;
mod opposed;
pub(crate) mod premises;
mod summary;

pub use beyond::BeyondCap;
pub use cause::{Cause, HowRead};
pub use claims::ClaimVerdict;
pub use coverage::{Coverage, CoverageState};
pub use errata::{
    Beyond, CellErratum, Consequences, Errata, Erratum, NotSharp, Subject, Unchecked,
};
pub use kernel::{KernelCounts, Share};
pub use opposed::Opposed;
pub use summary::{CellGroup, CellOutcome, CellStanding, CellSummary};
