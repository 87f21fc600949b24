//! The expression language in which masks and claims are written.
//!
//! ```text
//! 3/4   0.0266   4.35e-5        exact numbers
//! w   tau   μ                   named parameters
//! a + b   a - b   a*b   a/b     exact arithmetic; -x^2 is -(x^2)
//! x^k                           k an integer, also negative
//! abs(x)  min(x, …)  max(x, …)  floor(x)  ceil(x)
//! binomial(t, k)                t(t-1)…(t-k+1)/k!, t rational, k = 0, 1, …
//! sum(h = 1..m, body)           empty when m < 1
//! T(c, order = forward)         whatever the context offers; options are words
//! ```
//!
//! [`parse()`] gives an [`Expr`]; [`evaluate()`] computes it over any [`Value`], with
//! names and functions supplied by a [`Context`]. Every error carries the bytes
//! of the formula it is about.

mod ast;
mod builtin;
mod error;
mod evaluate;
mod located;
mod parse;
mod scope;
mod value;

pub use ast::{Expr, Node, Operator, OptionWord, Span};
pub use error::{CallError, FormulaError, FormulaErrorKind};
pub use evaluate::{Call, Context, Lookup, Parameters, Work, evaluate};
pub use located::LocatedFormula;
pub use parse::{MAX_FORMULA_LENGTH, MAX_NESTING, is_identifier, parse};
pub use scope::{Functions, Scope};
pub use value::Value;
