//! Functions of an integer t: one value for all t from one on.
//!
//! | file | subject |
//! |---|---|
//! | `sign` | the sign of a polynomial in t and h = cos(π/t) |
//! | `quotient` | quotients of such polynomials |
//! | `sum` | sums of these times square roots |
//! | `function` | functions of an integer |
//! | `turned` | these with e^{iφ}, for an angle φ of which the cosine is one |

pub(super) mod function;
mod quotient;
mod sign;
mod sum;
pub(super) mod turned;
