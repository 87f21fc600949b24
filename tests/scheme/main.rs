//! Schemes: masks, the catalogue, files and references.

mod catalogue;
#[path = "../common/mod.rs"]
mod common;
mod difference;
mod files;
mod mask;
mod reference;
mod rings;
