//! The program about itself: its flags, man pages and schemas.

mod flags;
mod man;
#[cfg(feature = "schema")]
mod schemas;
#[cfg(not(target_family = "wasm"))]
mod serve;

pub(super) use flags::flags;
pub(super) use man::completions;
pub(super) use man::man;
#[cfg(feature = "schema")]
pub(super) use schemas::schemas;
#[cfg(not(target_family = "wasm"))]
pub(super) use serve::serve;
