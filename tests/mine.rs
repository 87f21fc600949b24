//! t
#![allow(missing_docs)]
mod architecture;
mod common;
mod report;
