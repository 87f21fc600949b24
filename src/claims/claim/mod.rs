//! The assertions of a paper, as data: schemes, tables, equations, closed forms in a free parameter
//! and ranges of it, the smoothness of limits, and theorems.
//!
//! A claim file is TOML; [`read_paper`] reads one, [`embedded`] lists those that
//! are part of the program. Every number and formula is a string: TOML's own
//! numbers are rounded.

mod contents;
mod domain;
mod embedded;
mod equation;
mod function;
mod kinds;
mod paper;
mod read;
mod regularity;
mod smoothness;
mod table;
mod target;
mod theorem;

pub use contents::{Item, Label, MAX_LABELS};
pub(crate) use domain::is_rounded;
pub use domain::{Domain, Ends, RangeEnd};
pub(crate) use embedded::embedded_paper;
pub use embedded::{EmbeddedPaper, embedded, embedded_papers};
pub use equation::{Comparison, Equation, EquationBody, Hypothesis, Identity, Index, Left, Sign};
pub use function::{FunctionClaim, Limit, RangeClaim};
pub(crate) use kinds::with_kinds;
pub use kinds::{Claim, Kind};
pub use paper::{Alternative, Bibliography, Paper, SchemeSource};
#[cfg(feature = "schema")]
pub use read::paper_schema;
pub use read::{MAX_CLAIM_FILE_BYTES, is_id, read_paper, read_paper_file, read_whole_paper};
pub use regularity::{RegularityCell, RegularityTable};
pub use smoothness::{
    ExponentStatement, PrintedExponent, PrintedValences, SmoothRangeStatement,
    SmoothRegionStatement, SmoothnessBody, SmoothnessClaim, SmoothnessKind, SmoothnessStatement,
};
pub use table::{
    Axis, AxisEntry, Cell, Figure, Headers, LocatedReference, Printed, Promise, Table,
};
pub use target::Target;
pub use theorem::{ByHand, Quantity, Rewriting, Statement, THEOREM_NAMES, Theorem, Trial};
