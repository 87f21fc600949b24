//! Constants of masks over any numbers.

use crate::bound::{Terms, displacement};
use crate::evaluation::options::Options;
use crate::exact::Real;
use crate::formula::CallError;
use crate::scheme::{Mask, Rules};

/// max_β |Σ_j b_{β,j}|.
pub(crate) fn total_contraction<S: Real>(difference: &Rules<S>) -> S {
    S::maximum(difference.rows().iter().map(|row| Terms::Total.gather(row)))
}

/// σ with the terms and at the offset that the options name; `best` gives the best offset, if the mask has one.
pub(crate) fn moved<S: Real>(
    mask: &Mask<S>,
    options: &mut Options<'_>,
    best: impl Fn() -> Option<i64>,
) -> Result<S, CallError> {
    let terms = options.terms()?;
    let offset = options.offset(mask.offset(), best)?;
    Ok(displacement(&mask.with_offset(offset), terms))
}
