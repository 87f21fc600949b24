//! `subcert constants` and `certify`.

mod certify;
mod columns;
mod delta;
mod direction;
mod lattice;
pub(super) mod offset;
mod ring;
mod uniform;

pub(super) use certify::certify;
pub(super) use uniform::constants;
#[cfg(feature = "schema")]
pub(super) use {
    certify::Certification, lattice::LatticeConstants, ring::RingConstants, uniform::Constants,
};
