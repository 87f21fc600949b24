//! Temporary.
#![allow(missing_docs)]
mod common;
#[path = "exact/expression.rs"]
mod expression;
mod spectrum;
