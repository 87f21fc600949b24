//! Findings: what the audit says of claims, as plain data.

mod by_hand;
mod cell;
mod consistency;
mod equation;
mod function;
mod judgement;
mod kernel;
mod kinds;
mod levels;
mod paper;
mod promise;
mod range;
mod reading;
mod reason;
mod recovered;
mod smoothness;
mod table;
mod theorem;
mod witness;
mod working;

pub use by_hand::{ByHand, HandCell, HandConstant, LeftOut};
pub use cell::{
    AsRead, Assumed, CellFinding, CellKind, Direction, Missing, PointsAt, Slip, Sound, Verdict,
};
pub use consistency::{Contradiction, Needed, Side, TablePart};
pub use equation::{
    Counterexample, EquationFinding, EquationVerdict, Failure, OnReals, RealCase, SideValue,
};
pub use function::{Example, FunctionFinding, FunctionVerdict};
pub use judgement::Harm;
pub use kernel::{Excess, KernelFinding, KernelProof, KernelStatement, RingExcess};
pub use kinds::Finding;
pub use levels::{Later, LevelEvidence, Levels};
pub use paper::{PaperAudit, UnstatedOffset};
pub use promise::{Broken, Kept, PromiseCounts};
pub use range::{EndFinding, EndRelation, FoundRange, RangeFinding, RangeVerdict};
pub(crate) use reading::{COPIED, Values};
pub use reading::{
    Difference, Explanation, Line, LineReading, MAX_DIFFERENCES, Search, Solved, Uncomputed,
    WayCounts,
};
pub use reason::Reason;
pub(crate) use recovered::values;
pub use recovered::{Fitting, Recovered, RecoveredFrom};
pub use smoothness::{
    Contraction, KnownLimits, LatticeLimits, Proven, RangeAtValence, RangeOfLimits, RegionOfLimits,
    SmoothSets, SmoothnessFinding, SmoothnessVerdict, VertexWitness, Vertices, Witness,
};
pub use table::TableFinding;
pub use theorem::{
    CaseFinding, Correction, EveryShift, FailingPremise, Naturally, Outcome, Refutation, Repair,
    TheoremFinding, TheoremVerdict,
};
pub use witness::{Attained, Control, Place, Refiner, Supremum, Unshiftable, Violation};
pub use working::Working;
