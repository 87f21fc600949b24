//! The errors of roots.

/// The greatest degree of the polynomials whose roots are computed.
pub const MAX_ROOT_DEGREE: usize = 16;

/// Why there is no such root.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RootError {
    /// The square root of a negative number.
    #[error("there is no real square root of {value}, which is about {decimal}; take a number ≥ 0")]
    Negative {
        /// The number.
        value: String,
        /// Its first digits.
        decimal: String,
    },
    /// A polynomial without a term that depends on x.
    #[error(
        "the polynomial is a constant; give at least two coefficients, from the constant term upwards, the last not 0"
    )]
    Constant,
    /// A polynomial of too large a degree.
    #[error("a polynomial of degree {0}; roots are computed of degrees up to {MAX_ROOT_DEGREE}")]
    Degree(usize),
    /// There is no real root of this number.
    #[error(
        "root {index} of a polynomial with {count} real roots; the distinct real roots are numbered in \
         ascending order, from 1"
    )]
    Index {
        /// The number that was asked for.
        index: usize,
        /// The number of distinct real roots.
        count: usize,
    },
}
