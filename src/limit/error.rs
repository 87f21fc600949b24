//! Why there is no limit, or no distance.

use crate::exact::{Enclosure, Rational, format};

/// The widest window of control points or differences that is worked on.
pub const MAX_WINDOW: usize = 128;

/// The largest offset o of a mask, in absolute value.
pub const MAX_OFFSET: u64 = 10_000;

/// The highest level k at which a polygon is compared with its limit.
pub const MAX_LEVEL: u32 = 128;

/// The most n-adic digits of a parameter.
pub const MAX_PARAMETER_DIGITS: u32 = 256;

/// The most n-adic digits of a parameter after which they repeat.
pub const MAX_PERIOD: u32 = 64;

/// Why there is no limit, or no distance.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LimitError {
    /// 1 is not a simple eigenvalue of the scheme on its invariant window.
    #[error(
        "the scheme has no continuous limit: 1 is a multiple eigenvalue of its operator \
         on the points {first} to {last}, which determine the limit at 0"
    )]
    NoLimit {
        /// The first point of the invariant window.
        first: i64,
        /// The last one.
        last: i64,
    },
    /// No computed T_c is below 1.
    #[error(
        "not shown to converge: the least contraction constant T_c for c from 1 to {blocks} is \
         {least}, and one below 1 is needed"
    )]
    NotShown {
        /// The greatest c tried.
        blocks: u32,
        /// The least T_c.
        least: String,
    },
    /// An offset beyond [`MAX_OFFSET`].
    #[error("the offset {0} is too large; it must be from -{MAX_OFFSET} to {MAX_OFFSET}")]
    Offset(i64),
    /// A window beyond [`MAX_WINDOW`].
    #[error(
        "a window of {0} points or differences determines the limit; at most {MAX_WINDOW} are \
         worked on: take a scheme of fewer coefficients, or of an offset nearer to its centre"
    )]
    Window(usize),
    /// A parameter with too many digits, or too large.
    #[error(
        "the parameter {parameter} is 2^60 or more in absolute value, or its digits in base {arity} \
         repeat neither after {MAX_PARAMETER_DIGITS} of them nor with a period of {MAX_PERIOD}"
    )]
    Parameter {
        /// The parameter.
        parameter: String,
        /// n.
        arity: usize,
    },
    /// A level beyond [`MAX_LEVEL`].
    #[error("level {0} is too high; at most {MAX_LEVEL} is")]
    Level(u32),
    /// Too many residue classes for a step or a difference.
    #[error("after {level} levels of arity {arity} there are too many points to compare")]
    Classes {
        /// n.
        arity: usize,
        /// k.
        level: u32,
    },
    /// A width, a tolerance or a spread that must be positive.
    #[error("{what} must be positive, and is {value}")]
    NotPositive {
        /// What must be positive.
        what: &'static str,
        /// What it is.
        value: String,
    },
    /// The asked width was not reached within the cap on cells.
    #[error(
        "at most {cells} cells leave the distance between {} and {}: ask for a greater width",
        format::short(.reached.lower(), 9), format::short(.reached.upper(), 9)
    )]
    TooFine {
        /// How many cells were looked at.
        cells: u32,
        /// What is known.
        reached: Box<Enclosure>,
    },
    /// A control polygon that determines no piece of the limit.
    #[error("fewer than {needed} control points do not determine any piece of the limit")]
    TooFew {
        /// How many points are needed.
        needed: usize,
    },
    /// No level up to [`MAX_LEVEL`] is shown to be deep enough.
    #[error(
        "no level up to {MAX_LEVEL} is shown to meet the tolerance: ask for a greater tolerance"
    )]
    TooDeep,
    /// A level that the search leaves open comes before any that is shown to be deep enough.
    #[error(
        "the depth is at least {lower}, and of no level up to {MAX_LEVEL} it is shown within the \
         caps of the search, {caps}, that it and all later ones meet the tolerance: ask for a \
         greater tolerance"
    )]
    LeftOpen {
        /// The level before this one does not meet the tolerance.
        lower: u32,
        /// The caps.
        caps: String,
    },
}

/// Refuses a value that is not positive.
pub(super) fn positive(what: &'static str, value: &Rational) -> Result<(), LimitError> {
    if value.sign() > 0 {
        return Ok(());
    }
    Err(LimitError::NotPositive { what, value: format::short(value, 6) })
}
