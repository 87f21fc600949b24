//! The arbitrary-precision arithmetic below [`Integer`](super::Integer): num-bigint by
//! default, GMP through rug with the feature `gmp`. Both modules define the same
//! functions.

#[cfg(feature = "gmp")]
mod gmp;
#[cfg(feature = "gmp")]
pub(super) use gmp::*;

#[cfg(not(feature = "gmp"))]
mod num;
#[cfg(not(feature = "gmp"))]
pub(super) use num::*;
