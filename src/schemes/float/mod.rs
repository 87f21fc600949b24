//! The constants of schemes in plain f64, and the certification of the results.
//!
//! Everything that this module builds on is exact. Here the algorithms of
//! [`bound`](crate::bound) run on machine floats, as in a graphics program. Each result
//! is compared with the exact value: the true error is computed, and a bound of the error
//! is proven a priori.
//!
//! | item | what it is |
//! |---|---|
//! | [`nearest`], [`nearest_f32`], [`exact`], [`upper`], [`lower`], [`ulp`], [`ulps_between`] | conversion between exact numbers and f64 |
//! | [`shortest`], [`hexadecimal`], [`parse_hexadecimal`] | f64 as text |
//! | `f64` as [`Real`](crate::exact::Real) | the arithmetic of the machine |
//! | [`Tracked`] | an exact value with a proven bound on the error of the f64 computation |
//! | [`extremal`] | proposals for extremal norms of sets of matrices |
//! | [`certify`], [`certify_local_rules`] | every constant of a scheme in f64, exactly, and with that bound |
//!
//! The f64 operations +, −, ·, / are those of IEEE 754, each rounded to nearest. Rust
//! neither reorders nor fuses them. (The only exception is the legacy x87 unit of 32-bit
//! x86 targets without SSE2.)

mod apriori;
mod certify;
mod depth;
mod error;
pub mod extremal;
mod local_rules;
mod pipeline;
mod quantity;
mod upward;

pub use crate::machine::{
    HexadecimalError, exact, hexadecimal, lower, nearest, nearest_f32, parse_hexadecimal, shortest,
    ulp, ulps_between, upper,
};
pub use apriori::Tracked;
pub use certify::{Certification, CertifyOptions, MAX_TRACKED_STEPS, certify};
pub use depth::{DepthDecision, Margin, float_depth};
pub use error::{CertifyError, MAX_CERTIFIED_LEVEL, MAX_STEPS};
pub use local_rules::{LocalCertification, certify_local_rules};
pub use quantity::Quantity;
