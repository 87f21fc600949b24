//! Texts: certificates by lines and blocks, claim files in TOML, and the reasons to reject them.

pub mod certificate;
pub mod cursor;
pub mod reject;
pub mod toml;
pub mod verdict;
