//! The expression language in which masks and claims are written.
//!
//! ```text
//! 3/4   0.0266   .5   4.35e-5   ½    exact numbers
//! w   tau   μ                   named parameters
//! q[2*i - 1]   a[0, j]          members of families
//! a + b   a - b   a*b   a/b     exact arithmetic; -x^2 is -(x^2)
//! x^k                           k an integer, also negative
//! abs(x)  min(x, …)  max(x, …)  floor(x)  ceil(x)
//! mod(x, m)                     x - m*floor(x/m)
//! kronecker(a, b)               1 where a = b, 0 elsewhere
//! binomial(t, k)                t(t-1)…(t-k+1)/k!, t rational, k = 0, 1, …
//! sum(h = 1..m, body)           0 when m < 1
//! max(h = 1..m, body)  min(…)   over a range, which must not be empty
//! cos(2*pi*j/n)   cos(π/n)      of any rational multiple of pi
//! sqrt(x)   √3   √(x + 1)       of x >= 0
//! root([c0, c1, …], i)          the real root number i, from 1, of c0 + c1*x + …
//! T(c, order = forward)         whatever the context offers; options are words
//! ```
//!
//! [`parse()`] gives an [`Expr`]; [`evaluate()`] computes it over any [`Value`], with
//! names and functions supplied by a [`Context`]. Every error carries the byte range of
//! its cause in the formula.
//!
//! `pi` is a reserved name for angles. It may stand only inside `cos`, not in a
//! definition that is used there, and only in sums, in products and in numerators. A
//! cosine is a [`RealCyclotomic`](crate::exact::RealCyclotomic) number. Over the
//! rationals a formula has a value only if all its cosines are rational.
//!
//! The real roots of a polynomial are counted from 1 in increasing order, a multiple one once. Over real
//! algebraic numbers, [`AlgebraicNumber`](crate::exact::AlgebraicNumber), `sqrt` and `root` always have values, as long as all numbers
//! of a formula lie in one field of degree up to 24. Over [`RealExpression`](crate::exact::RealExpression) they have values without
//! such a cap, but the coefficients of `root` have no roots in them. Over the rationals they have one only where it is
//! rational, and over the values of claims about papers, never.
//!
//! ```
//! use subcert::exact::{Rational, RealCyclotomic};
//! use subcert::formula::{Parameters, evaluate, parse};
//!
//! let formula = parse("sum(j = 1..n, cos(2*pi*j/n)^2)")?;
//! let n = Parameters::from([("n", RealCyclotomic::from(7))]);
//! assert_eq!(evaluate(&formula, &n)?, RealCyclotomic::from(Rational::new(7, 2)));
//!
//! let rational = evaluate(&formula, &Parameters::from([("n", Rational::from(7))]));
//! assert_eq!(rational.unwrap_err().to_string(), "cos(2*pi/7) is not rational");
//! # Ok::<(), subcert::formula::FormulaError>(())
//! ```

mod angle;
mod ast;
mod builtin;
mod context;
mod dependence;
mod display;
mod error;
mod evaluate;
mod free;
mod hyphens;
mod laurent;
mod located;
mod parse;
mod power;
mod root;
mod root_error;
mod scope;
mod token;
mod values;

pub use angle::PI;
pub use ast::{Expr, Fold, Node, Operator, OptionWord, SEQUENCE_INDEX, Span};
pub use builtin::is_builtin;
pub use context::{Call, Context, Lookup, Parameters, Work};
pub use dependence::{Dependence, IndexPair};
pub use error::{CallError, FormulaError, FormulaErrorKind, MAX_FORMULA_LENGTH, MAX_NESTING};
pub use evaluate::evaluate;
pub use evaluate::evaluate_with;
pub use free::FreeNames;
pub use hyphens::differences;
pub use laurent::{Laurent, MAX_SYMBOL_POWER};
pub use located::LocatedFormula;
pub use parse::parse;
pub use power::{LATTICE_VARIABLES, Power, SYMBOL_VARIABLE};
pub use root_error::RootError;
pub use scope::{Functions, Scope};
pub use token::{continues_name, is_identifier, starts_name};
pub use values::half_planes::{HalfPlanes, Linear, NoPolygon, Pieces};
pub use values::real::RealValue;
pub use values::value::Value;
