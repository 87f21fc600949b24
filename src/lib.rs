#![doc = include_str!("../README.md")]
#![allow(missing_docs)]
pub mod bound;
pub mod diagnostic;
pub mod exact;
pub mod float;
pub mod formula;
pub mod oracle;
pub mod scheme;
