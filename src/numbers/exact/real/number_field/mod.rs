//! Numbers of the field Q(α) of a real algebraic number α, and fields that contain several of them.
//!
//! | file | subject |
//! |---|---|
//! | `element` | the number type |
//! | `extension` | a root of a polynomial over Q(α) |
//! | `merge` | one field for the numbers of two |
//! | `number` | numbers of any field, which meet each other |
//! | `error` | the caps |

mod element;
mod error;
mod extension;
mod merge;
mod number;

pub use element::FieldElement;
pub use error::{FieldError, MAX_FIELD_DEGREE, MAX_NORM_DEGREE};
pub use number::AlgebraicNumber;
