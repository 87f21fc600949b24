//! Why there is no limit, or no distance.

use crate::exact::{Enclosure, Rational, format};

/// The greatest number of control points or differences in a window.
pub const MAX_WINDOW: usize = 128;

/// The largest absolute value of the offset o of a mask.
pub const MAX_OFFSET: i64 = 10_000;

/// The highest level k at which a polygon is compared with its limit.
pub const MAX_LEVEL: u32 = 128;

/// The greatest number of n-adic digits of a parameter before they repeat.
pub const MAX_PARAMETER_DIGITS: u32 = 256;

/// The greatest period of the n-adic digits of a parameter.
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
        /// The last point of the invariant window.
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
    /// A parameter that is too large, or whose digits repeat too late or with too long a
    /// period.
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
    /// Too many residue classes for a step, a change or a difference.
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
        /// Its value.
        value: String,
    },
    /// The requested width was not reached within the cap on cells.
    #[error(
        "at most {cells} cells leave the distance between {} and {}: ask for a greater width",
        format::short(.reached.lower(), 9), format::short(.reached.upper(), 9)
    )]
    TooFine {
        /// The cap on cells.
        cells: u32,
        /// The enclosure that was reached.
        reached: Box<Enclosure>,
    },
    /// No depth as a distance of sets of points.
    #[error("as a distance of sets of points the depth is not found: {reason}")]
    Sets {
        /// The reason.
        reason: String,
    },
    /// A control polygon that determines no piece of the limit.
    #[error("fewer than {needed} control points do not determine any piece of the limit")]
    TooFew {
        /// The number of points that are needed.
        needed: usize,
    },
    /// No level up to [`MAX_LEVEL`] is shown to be deep enough.
    #[error(
        "no level up to {MAX_LEVEL} is shown to meet the tolerance: ask for a greater tolerance"
    )]
    TooDeep,
    /// The search leaves a level open, and for no level it is shown that this level and
    /// all later ones meet the tolerance.
    #[error(
        "the depth is at least {lower}, and of no level up to {MAX_LEVEL} it is shown within the \
         caps of the search, {caps}, that it and all later ones meet the tolerance: ask for a \
         greater tolerance"
    )]
    LeftOpen {
        /// A lower bound of the depth: 0, or the level before it does not meet the
        /// tolerance.
        lower: u32,
        /// The caps.
        caps: String,
    },
}

/// An error unless `value` is positive.
pub(super) fn positive(what: &'static str, value: &Rational) -> Result<(), LimitError> {
    if value.sign() > 0 {
        return Ok(());
    }
    Err(LimitError::NotPositive { what, value: format::short(value, 6) })
}
