//! Functions of an integer t: one value for all t from one on.
//!
//! | file | subject |
//! |---|---|
//! | `sign` | the sign of a polynomial in t and h = cos(π/t) |
//! | `quotient` | quotients of such polynomials |
//! | `function` | these with square roots |
//! | `turned` | these with e^{iφ}, for an angle φ of which the cosine is one |

pub(super) mod function;
mod quotient;
mod sign;
pub(super) mod turned;
