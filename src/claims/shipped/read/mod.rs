//! Reading claim files about constants of programs.

#![deny(clippy::arithmetic_side_effects)]

mod exact;
mod file;
mod indices;
mod literals;
mod names;
mod nested;
mod project;
mod reader;

#[cfg(feature = "schema")]
pub use file::project_schema;
pub use project::{MAX_SHIPPED, is_project, read_project};
pub use reader::MAX_DESCRIBED;
