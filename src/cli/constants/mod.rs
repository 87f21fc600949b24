//! `subcert constants` and `certify`.

mod certify;
mod columns;
mod delta;
mod direction;
pub(super) mod offset;
mod ring;
mod uniform;

pub(super) use certify::certify;
pub(super) use uniform::constants;
#[cfg(feature = "schema")]
pub(super) use {certify::Certification, ring::RingConstants, uniform::Constants};
