//! Findings as text, Markdown, LaTeX, JSON and HTML.

mod errata;
mod formulas;
pub mod html;
pub mod json;
mod kinds;
mod output;
mod papers;
mod shipped;
mod smooth;
mod tables;
mod theorems;
mod told;
mod words;

pub use errata::latex_table::corrected_table;
pub use errata::{differences_sheet, errata_sheet};
pub use papers::audit::{audit_sheet, table_values};
pub use papers::brief::brief_sheet;
pub use papers::coverage::coverage_sheet;
pub use papers::explain::{explain_sheet, table_of};
pub use papers::overview::overview_sheet;
pub use shipped::{finding_sheet, headline as shipped_headline, issue_sheet, projects_sheet};
pub use smooth::range::reduction;
pub use smooth::vertex::{
    SCOPE, VERTEX_HEADER, verdict_name, verdict_reason, vertex_facts, vertex_row,
};
pub use tables::eye::{Eye, to_the_eye};
pub use told::Background;
pub use words::data::parameters;
pub use words::look::legend;
pub use words::notation::unicode;
pub use words::numbers::{down, up};
pub use words::set::{found_texts, interval_texts, number, polynomial, proved_texts};
pub use words::sheet::{Block, Grid, Sheet};
