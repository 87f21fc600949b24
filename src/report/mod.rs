//! Findings as text, Markdown, LaTeX, JSON and HTML.

mod audit;
mod by_hand;
mod consistency;
mod coverage;
mod data;
mod equation;
mod errata;
mod explain;
mod fit;
mod function;
mod headers;
mod headline;
pub mod html;
pub mod json;
mod latex;
mod latex_document;
mod numbers;
mod overview;
mod parts;
mod promise;
mod reading;
mod sheet;
mod shift;
mod summary;
mod text;
mod theorem;
mod tried;
mod witness;
mod working;

pub use audit::{audit_sheet, table_values};
pub use coverage::coverage_sheet;
pub use errata::errata_sheet;
pub use explain::{Background, explain_sheet, table_of};
pub use overview::overview_sheet;
pub use parts::mark;
pub use sheet::{Block, Grid, Sheet};
