//! Reading claim files about constants of programs.

mod exact;
mod file;
mod indices;
mod literals;
mod names;
mod nested;
mod project;

pub use project::{MAX_DESCRIBED, MAX_SHIPPED, is_project, read_project};
