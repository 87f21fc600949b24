//! Schemes: masks, the catalogue, files and references.

mod catalogue;
mod difference;
mod files;
mod mask;
mod reference;
mod rings;
