//! Judging claims: one file for each kind of claim, and folders where a kind needs several.

mod cases;
mod compare;
mod comparison;
pub(crate) mod distance;
pub(crate) mod equation;
mod for_all;
pub(crate) mod function;
mod hypotheses;
pub(crate) mod kind;
pub(crate) mod later;
mod mend;
pub(crate) mod promise;
pub(crate) mod range;
pub(crate) mod reading;
mod reals;
mod recovery;
pub(crate) mod related;
mod relation;
mod slips;
pub(crate) mod smoothness;
pub(crate) mod table;
pub(crate) mod theorem;

pub use cases::MAX_CASES;
