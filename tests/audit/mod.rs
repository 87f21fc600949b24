//! The five papers, and claim files that were judged wrongly once.

mod papers;
mod soundness;
