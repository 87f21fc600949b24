#![doc = include_str!("../README.md")]
#![allow(missing_docs)]
pub mod audit;
pub mod bound;
pub mod claim;
pub mod diagnostic;
pub mod exact;
pub mod formula;
#[cfg(feature = "cli")]
pub mod report;
pub mod scheme;
