//! Findings as pages that a browser shows: one file for each paper of an audit and an index of them, and one
//! for a single finding.
//!
//! A page loads nothing and runs no script but for the index of the atlas, which works without it: cells open by their anchors, and filters are radio
//! buttons that the style sheet reads.

mod atlas;
mod broken;
mod cell;
mod certified;
mod claims;
mod command;
mod context;
mod depth;
mod document;
mod explain;
mod filter;
mod finding;
mod index;
mod math;
mod names;
mod page;
mod picture;
mod plot;
mod regularity;
mod ring;
mod sheet;
mod shipped;
mod statement;
mod table;
mod verdict;

pub use atlas::{ATLAS_HEADER, AtlasRow, EntryPage, SchemeSection, atlas_page, entry_page};
pub use command::quoted as shell_word;
pub use depth::{LevelLine, Levels};
pub use explain::explain_page;
pub use finding::{FindingPage, Picture};
pub use index::index_page;
pub use page::audit_page;
pub use picture::{ColouredFaces, FarPolygon};
pub use plot::Plot;
pub use shipped::{project_page, projects_page};
