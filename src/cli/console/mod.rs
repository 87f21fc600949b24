//! What goes to the terminal and to files: answers in every format, notes, progress, interrupts.

pub(super) mod answer;
#[cfg(not(target_family = "wasm"))]
mod bar;
#[cfg(target_family = "wasm")]
#[path = "lines.rs"]
mod bar;
pub(super) mod csv;
pub(super) mod destination;
pub(super) mod endings;
pub(super) mod interrupt;
pub(crate) mod lattice;
pub(super) mod line;
pub(super) mod output;
pub(super) mod progress;
pub(super) mod quantity;
pub(super) mod save;
pub(super) mod terminal;
