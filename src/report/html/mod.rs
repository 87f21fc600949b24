//! An audit as pages that a browser shows: one file for each paper, and an index of them.
//!
//! A page loads nothing and runs no script: cells open by their anchors, and filters are radio
//! buttons that the style sheet reads.

mod broken;
mod cell;
mod certified;
mod claims;
mod command;
mod context;
mod document;
mod filter;
mod index;
mod math;
mod names;
mod page;
mod picture;
mod sheet;
mod statement;
mod table;
mod verdict;

pub use index::index_page;
pub use page::audit_page;
