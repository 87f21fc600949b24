//! The five papers, and claim files that were judged wrongly once.

mod by_hand;
mod ledger;
mod one_claim;
mod papers;
mod soundness;
