//! The five papers, and claim files that were judged wrongly once.

mod ledger;
mod papers;
mod soundness;
