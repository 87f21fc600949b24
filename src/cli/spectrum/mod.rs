//! `subcert spectrum` and `table`.

mod parts;
pub(super) mod ring;
mod sector;
pub(super) mod table;

pub(super) use ring::spectrum;
pub(super) use sector::sector;
pub(super) use table::table;
#[cfg(feature = "schema")]
pub(super) use {ring::Spectrum, sector::Sector};
