//! Constants that programs ship: certificates about claim files of projects
//! (`proofs/format/shipped.md`). Nothing here is shared with the checks of papers but texts, formulas, rational numbers, and enclosures of
//! roots.

// Enclosures of real numbers, and formulas on them.
mod arithmetic;
mod cosine;
mod functions;
pub mod interval;
pub mod roots;
mod value;

// Numbers in programs, and what is said of them.
mod decided;
mod held;
mod language;
mod literal;
mod number;
mod rounding;
mod slip;
mod verdict;
mod whole;

// Claim files, and the rule.
mod reading;
mod rule;
mod table;

pub use interval::Interval;
pub use roots::Sturm;
pub use rule::check;
