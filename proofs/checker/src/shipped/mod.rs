//! Constants that programs ship: certificates about claim files of projects
//! (`proofs/format/shipped.md`). Nothing here is shared with the checks of papers but texts, formulas, rational numbers, and enclosures.

// Formulas on enclosures of real numbers.
mod functions;
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

pub use rule::check;
