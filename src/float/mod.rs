//! The same computations in plain f64, and their certification.
//!
//! Everything before this module is exact. Here the algorithms of [`bound`](crate::bound)
//! run over machine floats, as a graphics programmer would write them, and the
//! results are held against the exact ones: with the true error, and with a bound
//! on it that is proven in advance.
//!
//! | item | what it is |
//! |---|---|
//! | [`nearest`], [`exact`], [`upper`], [`lower`], [`ulp`], [`ulps_between`] | from exact numbers to f64 and back |
//! | [`shortest`], [`hexadecimal`], [`parse_hexadecimal`] | f64 as text |
//! | `f64` as [`Real`](crate::exact::Real) | the arithmetic of the machine |
//! | [`Tracked`] | an exact value with a proven bound on the error of the f64 computation |
//! | [`extremal`] | proposals for extremal norms of sets of matrices |
//! | [`certify`], [`certify_local_rules`] | every constant of a scheme in f64, exactly, and with that bound |
//!
//! The f64 operations +, −, ·, / are those of IEEE 754, rounded to nearest, one
//! by one: Rust neither reorders nor fuses them. (The one exception is the legacy
//! x87 unit of 32-bit x86 targets without SSE2.)

mod apriori;
mod certify;
mod convert;
mod depth;
mod error;
pub mod extremal;
mod hexadecimal;
mod local_rules;
mod pipeline;
mod quantity;
mod real;
mod upward;

pub use apriori::Tracked;
pub use certify::{Certification, CertifyOptions, MAX_TRACKED_STEPS, certify};
pub use convert::{exact, lower, nearest, shortest, ulp, ulps_between, upper};
pub use depth::{DepthDecision, Margin, float_depth};
pub use error::{CertifyError, MAX_CERTIFIED_LEVEL, MAX_STEPS};
pub use hexadecimal::{HexadecimalError, hexadecimal, parse_hexadecimal};
pub use local_rules::{LocalCertification, certify_local_rules};
pub use quantity::Quantity;
