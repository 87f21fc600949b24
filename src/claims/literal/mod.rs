//! Tables of numbers in the source files of programs.
//!
//! Programs ship limit stencils, filter taps and weights as arrays of literals. [`read_literals`] finds such an
//! array in a file of C, C++, CUDA, GLSL, HLSL, WGSL, JavaScript, Python, Rust or MATLAB, or a macro, and reads every number twice: exactly
//! as it is written, and as the program holds it ([`Entry::held`]), with the language's rules for suffixes and
//! for sums and quotients of literals. What is no number, such as a macro, is refused with its line.
//!
//! | item | what it is |
//! |---|---|
//! | [`read_literals`], [`LiteralTable`] | the table after a name |
//! | [`Entry`], [`Written`] | one number: a literal, or an expression of literals |
//! | [`Language`] | which rules hold |
//! | [`Precision`] | the type of the table |

mod arithmetic;
mod compiled;
mod constructor;
mod declared;
mod directive;
mod entry;
mod expression;
mod language;
mod locate;
mod number;
mod place;
mod quoted;
mod reader;
mod size;
mod table;
mod token;
mod unclear;
mod uses;
mod whole;

pub use entry::{Entry, Written};
pub use language::{Language, Precision};
pub use reader::MAX_ENTRIES;
pub use table::{LiteralTable, read_literals};
