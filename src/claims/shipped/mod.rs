//! Constants that programs ship, and what they should be.
//!
//! A claim file with `[project]` describes tables of numbers in the source of a program: the numbers, typed in or read
//! from the source, their type, and the exact values that they are said to equal. [`audit_project`] says of each number whether
//! it is the nearest of its type, and how it came about where it is not.
//!
//! | item | what it is |
//! |---|---|
//! | [`Project`], [`ShippedClaim`] | a claim file, and a table in it |
//! | [`read_project`], [`is_project`] | reading |
//! | [`audit_project`], [`audit_projects`], [`audit_shipped`] | judging |
//! | [`decimal`], [`nearest_text`] | an exact number as one would print or type it |
//! | [`ProjectAudit`], [`ShippedFinding`] | what was found |
//!
//! ```
//! use subcert::diagnostic::SourceText;
//! use subcert::shipped::{Verdict, audit_project, read_project};
//!
//! let file = r#"
//! key = "mine"
//! project = { name = "Mine", repository = "local", commit = "0000000000000000000000000000000000000000", licence = "MIT" }
//! [[shipped]]
//! id = "thirds"
//! locus = "mine.c, thirds"
//! type = "f32"
//! indices = ["k = 1..2"]
//! equals = 'k/3'
//! cells = ["0.33333334f", "0.6667f"]
//! "#;
//! let project = read_project(&SourceText::new("mine.toml", file))?;
//! let audit = audit_project(&project)?;
//! let verdicts: Vec<Verdict> = audit.findings[0].cells.iter().map(|cell| cell.verdict).collect();
//! assert_eq!(verdicts, [Verdict::Nearest, Verdict::Rounded(4)]);
//! # Ok::<(), subcert::diagnostic::Errors>(())
//! ```

mod claim;
mod exact;
mod finding;
mod follows;
mod judge;
mod misprint;
mod number;
mod read;
mod reading;
mod verdict;

pub use claim::{
    Convention, Digits, ExactValues, NumberType, Origin, Project, ShippedClaim, ShippedNumber,
    TableIndex,
};
pub use finding::{
    BrokenSums, Early, Misprint, Outcome, ProjectAudit, Reading, ShippedCell, ShippedFinding,
    SplitEquals, Verdict,
};
pub use judge::{audit_project, audit_projects, audit_shipped};
pub use number::{DECIDING_BITS, decimal, nearest_text};
#[cfg(feature = "schema")]
pub use read::project_schema;
pub use read::{MAX_DESCRIBED, MAX_SHIPPED, is_project, read_project};
