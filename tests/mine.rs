//! t
#![allow(missing_docs)]
mod architecture;
mod cli;
mod common;
mod report;
