//! Findings as pages that a browser shows: one file for each paper of an audit and an index of them, and one
//! for a single finding.
//!
//! A page loads nothing and runs no script but for the index of the atlas, which works without it: cells open by their anchors, and filters are radio
//! buttons that the style sheet reads.

mod broken;
mod cell;
mod certified;
mod claims;
mod command;
pub(super) mod context;
mod document;
mod filter;
pub(super) mod math;
mod names;
mod pages;
pub(super) mod picture;
mod regularity;
pub(super) mod sheet;
pub(super) mod statement;
pub(super) mod table;
mod typeset;
mod verdict;

pub use command::quoted as shell_word;
pub use pages::atlas::{ATLAS_HEADER, AtlasRow, EntryPage, SchemeSection, atlas_page, entry_page};
pub use pages::depth::{LevelLine, Levels};
pub use pages::explain::explain_page;
pub use pages::finding::{FindingPage, Picture};
pub use pages::index::index_page;
pub use pages::page::audit_page;
pub use pages::plot::Plot;
pub use pages::shipped::{project_page, projects_page};
pub use picture::{ColouredFaces, FarPolygon};
