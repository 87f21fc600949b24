//! Temporary.

#[path = "architecture/mod.rs"]
mod architecture;
#[path = "cli/mod.rs"]
mod cli;
#[path = "common/mod.rs"]
mod common;
#[path = "report/mod.rs"]
mod report;
