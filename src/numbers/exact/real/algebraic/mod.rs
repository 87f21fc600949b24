//! Real algebraic numbers: a polynomial, and an interval that isolates one root.
//!
//! | file | subject |
//! |---|---|
//! | `number` | the number type: constructors and accessors |
//! | `order` | equality and order |

mod number;
mod order;

pub use number::RealAlgebraic;
