//! Enclosures of real numbers by intervals with rational ends, and of the roots of polynomials.

mod arithmetic;
mod cosine;
mod interval;
mod number;
mod polynomial;
mod roots;

pub use cosine::Circle;
pub use interval::Interval;
pub use number::enclosed;
pub use polynomial::{at, is_within, without};
pub use roots::Sturm;
