//! The check of all claims of a file: of a paper, or of a project.

pub mod outcome;
pub mod paper;
pub mod project;
