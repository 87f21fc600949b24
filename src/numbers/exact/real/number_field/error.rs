//! The caps on fields, and the errors of roots.

use crate::cap::Cap;

/// The greatest degree of a field.
pub const MAX_FIELD_DEGREE: usize = 24;

/// The greatest degree of a polynomial over the rationals of which the roots are isolated: the degree of the
/// field times the degree of the polynomial.
pub const MAX_NORM_DEGREE: usize = 64;

/// Why a root of a polynomial is not computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FieldError {
    /// Every number is a root of 0.
    #[error("all coefficients of the polynomial are 0")]
    Zero,
    /// There is no root of this number.
    #[error("the polynomial has {found} real root{s}, so that there is no root number {asked}", s = if *found == 1 { "" } else { "s" })]
    NoSuchRoot {
        /// The number of real roots.
        found: usize,
        /// The root that is asked for, counted from 1.
        asked: i64,
    },
    /// The degree of the norm is too large.
    #[error(
        "the roots are those of a polynomial of degree {0} over the rationals; the degree can be at most \
         {MAX_NORM_DEGREE}"
    )]
    Norm(usize),
    /// The degree of the field is too large.
    #[error(
        "the irrational numbers together need a field of degree above {MAX_FIELD_DEGREE} over the rationals; \
         write them in one number of a lower degree"
    )]
    Degree,
}

impl FieldError {
    /// The cap that a degree is beyond.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            FieldError::Zero | FieldError::NoSuchRoot { .. } => None,
            FieldError::Norm(_) => {
                Some(Cap::new("the degree of the polynomial of the roots", MAX_NORM_DEGREE as u64))
            }
            FieldError::Degree => {
                Some(Cap::new("the degree of the field of the numbers", MAX_FIELD_DEGREE as u64))
            }
        }
    }
}
