//! Real algebraic numbers: a polynomial, and an interval that isolates one root.
//!
//! | file | subject |
//! |---|---|
//! | `number` | the number type: how numbers are made and what they tell |
//! | `order` | equality and order |

mod number;
mod order;

pub use number::RealAlgebraic;
