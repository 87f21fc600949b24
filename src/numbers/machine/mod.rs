//! Numbers of the machine: f64 as a [`Real`](crate::exact::Real), and exact conversion from and to it.
//!
//! | item | what it is |
//! |---|---|
//! | [`nearest`], [`nearest_f32`], [`exact`], [`upper`], [`lower`], [`ulp`], [`ulps_between`] | conversion between exact numbers and f64 |
//! | [`inverse`], [`replace`] | inverses of matrices |
//! | [`shortest`], [`hexadecimal`], [`parse_hexadecimal`] | f64 as text |
//! | [`Rational`](crate::exact::Rational) and [`Integer`](crate::exact::Integer) with `ToPrimitive`, `FromPrimitive` | the same for generic code of num-traits |
//! | `f64` as [`Real`](crate::exact::Real) | the arithmetic of IEEE 754 |

mod convert;
mod hexadecimal;
mod inverse;
mod primitive;
mod real;

pub use convert::{exact, lower, nearest, nearest_f32, shortest, ulp, ulps_between, upper};
pub use hexadecimal::{HexadecimalError, hexadecimal, parse_hexadecimal};
pub use inverse::{inverse, replace};
