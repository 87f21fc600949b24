//! The same as [`shape`](super::shape) on a piece, for masks with polynomials in its symbol.

#![warn(clippy::arithmetic_side_effects)]

use super::limits::{exists, values};
use super::masks::{Mask, divided};
use super::steps::add;
use crate::numbers::{Meter, Piece, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;

/// The most coefficients of c_j.
pub const MAX_COEFFICIENTS: usize = 16_384;

/// Their cap.
pub const LENGTH: Stop = Stop::Capped("the coefficients of differences after some levels");

/// Whether the limits of all data whose m-th differences are not negative have this property too, on the whole piece.
pub fn keeps_on(
    library: &Library<'_>,
    scheme: &Scheme,
    m: usize,
    piece: &Piece<'_>,
) -> Result<bool, Stop> {
    let meter = library.meter;
    let Mask { arity: n, values: a, .. } = Mask::on(meter, scheme, Some(piece))?;
    exists(library, scheme, Some(piece))?;
    let Some(b) = divided(meter, &a, (n, m), Some(piece))? else {
        // As for numbers: some second differences are not 0, and so some are negative.
        let limit = values(library, scheme, Some(piece))?;
        let (mut refined, mut classes) = (a.clone(), n);
        while divided(meter, &product(meter, (&refined, 1), &limit)?, (classes, m), Some(piece))?
            .is_some()
        {
            refined = product(meter, (&refined, n), &a)?;
            classes = classes.saturating_mul(n);
        }
        return Ok(false);
    };
    let (mut differences, mut limit) = (b.clone(), None);
    while is_negative(&differences, piece)? {
        let limit = match &limit {
            Some(known) => known,
            None => limit.insert(values(library, scheme, Some(piece))?),
        };
        if is_negative(&product(meter, (&differences, 1), limit)?, piece)? {
            return Ok(false);
        }
        // c_{j+1}(z) = c_j(z^n)b(z).
        differences = product(meter, (&differences, n), &b)?;
    }
    Ok(true)
}

/// Whether some coefficient is negative.
fn is_negative(p: &[Value], piece: &Piece<'_>) -> Result<bool, Stop> {
    for c in p {
        if c.sign(Some(piece))? < 0 {
            return Ok(true);
        }
    }
    Ok(false)
}

/// p(z^s)q(z).
fn product(meter: &Meter, (p, s): (&[Value], usize), q: &[Value]) -> Result<Vec<Value>, Stop> {
    let length = p.len().saturating_sub(1).saturating_mul(s).saturating_add(q.len());
    if s > 1 && length > MAX_COEFFICIENTS {
        return Err(LENGTH);
    }
    let mut sums = vec![Value::int(0); length];
    for (place, x) in (0..).step_by(s).zip(p) {
        for (sum, y) in sums.iter_mut().skip(place).zip(q) {
            add(meter, sum, x, y)?;
        }
    }
    Ok(sums)
}
