//! f64 and its certification: conversions against Rust's own, proven bounds
//! against true errors, decisions against exact ones.

mod apriori;
mod certify;
mod convert;
mod extremal;
mod hexadecimal;
mod local_rules;
mod strategy;
