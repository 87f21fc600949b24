//! Schemes: masks, the catalogue, files and references.

mod catalogue;
mod difference;
mod files;
mod local_rules;
mod mask;
mod reference;
mod symbol;
mod typed;
