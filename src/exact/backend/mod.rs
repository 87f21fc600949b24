//! The arbitrary-precision arithmetic below [`Integer`](super::Integer): num-bigint by
//! default, GMP through rug with the feature `gmp`. Both files offer the same names.

#[cfg(feature = "gmp")]
mod gmp;
#[cfg(feature = "gmp")]
pub(super) use gmp::*;

#[cfg(not(feature = "gmp"))]
mod num;
#[cfg(not(feature = "gmp"))]
pub(super) use num::*;
