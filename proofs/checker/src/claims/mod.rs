//! Claim files of papers, their fields and names, and the blocks of certificates about them.

pub mod headers;
pub mod names;
pub mod paper;
pub mod said;
pub mod shape;
pub mod tasks;
