//! What the audit says of constants that programs ship, in words.

mod facts;
mod issue;
mod overview;
mod table;
mod words;

pub use issue::issue_sheet;
pub use overview::projects_sheet;
pub use table::{finding_sheet, headline};

pub(super) use overview::{counts, sentence};
pub(super) use table::{facts_of, rows, shown};
pub(super) use words::{meaning, reading as shipped_reading};
