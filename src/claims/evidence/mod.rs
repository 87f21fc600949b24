//! Evidence: what certificates need beyond the findings, computed when they are written.

mod by_hand;
mod constants;
mod drawn;
mod excess;
mod kernel;
mod promise;
mod table;
mod theorem;
mod working;

pub use by_hand::by_hand;
pub use constants::{AttainedConstant, Powers, SearchedConstant};
pub use drawn::{DepthLevels, depth_levels, promise_refiner};
pub use kernel::kernel_findings;
pub use promise::{PromiseEvidence, promise_evidence};
pub use table::{Evidence, SoundCell, evidence};
pub use theorem::theorem_evidence;
pub use working::working;
