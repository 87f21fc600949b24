//! The integrals of the products of two limits.

#![warn(clippy::arithmetic_side_effects)]

use super::existing::{exists, piece_of};
use super::integers::{PLACE, at_integers, window};
use super::related::scheme_of;
use crate::data::{converges, converges_on};
use crate::functions::call::{number, wrong};
use crate::functions::masks::Mask;
use crate::functions::steps::{add, over};
use crate::numbers::{Meter, Piece, Value};
use crate::schemes::{Integrals, Library, Scheme};
use crate::text::Stop;

/// ∫ φ(x)ψ(x − k) dx.
pub fn inner_product(
    library: &Library<'_>,
    (scheme, other): (&Scheme, &Scheme),
    k: i64,
    piece: Option<&Piece<'_>>,
) -> Result<Value, Stop> {
    let (first, known) = inner_products(library, scheme, other, piece)?;
    let place = k.checked_sub(first).and_then(|place| usize::try_from(place).ok());
    Ok(place.and_then(|place| known.get(place)).cloned().unwrap_or_else(|| Value::int(0)))
}

/// All of these: the values of ∫ φ(x)ψ(x − y) dx at the integers y.
pub fn inner_products(
    library: &Library<'_>,
    scheme: &Scheme,
    other: &Scheme,
    piece: Option<&Piece<'_>>,
) -> Result<Integrals, Stop> {
    let (meter, piece_of_other) = (library.meter, piece_of(other, piece));
    let piece = piece_of(scheme, piece);
    let (a, b) = (Mask::on(meter, scheme, piece)?, Mask::on(meter, other, piece_of_other)?);
    let both = piece.or(piece_of_other);
    if a.arity != b.arity {
        return wrong("the two schemes are of two arities");
    }
    let known = scheme.integrals.borrow().get(&std::ptr::from_ref(other)).cloned();
    if let (None, Some(known)) = (both, known) {
        return Ok(known);
    }
    let mask = correlation(meter, &a, &b)?;
    exists(library, &scheme_of(&mask, both)?, both)?;
    if !std::ptr::eq(scheme, other) {
        for (scheme, mask, piece) in [(scheme, &a, piece), (other, &b, piece_of_other)] {
            if !shown(library, scheme, piece)? {
                let own = correlation(meter, mask, mask)?;
                exists(library, &scheme_of(&own, piece)?, piece)?;
            }
        }
    }
    let found = (window(&mask)?.0, at_integers(meter, &mask, both)?.into());
    if both.is_none() {
        scheme.integrals.borrow_mut().insert(other, Integrals::clone(&found));
    }
    Ok(found)
}

/// Whether a scheme is shown to converge; not if that is beyond a cap.
fn shown(library: &Library<'_>, scheme: &Scheme, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
    let found = match piece {
        None => converges(library, scheme),
        Some(piece) => converges_on(library, scheme, piece),
    };
    match found {
        Err(Stop::Capped(_)) => library.meter.spend(0).map(|()| false),
        found => found,
    }
}

/// The mask c_j = Σ_{k−l=j} a_k b_l/n. It begins at the least k less the greatest l.
fn correlation(meter: &Meter, a: &Mask, b: &Mask) -> Result<Mask, Stop> {
    let first = a.first.checked_sub(b.last()?).ok_or(PLACE)?;
    let length = a.values.len().saturating_add(b.values.len()).saturating_sub(1);
    let mut mask = Mask { arity: a.arity, first, values: vec![Value::int(0); length] };
    for (from, of_a) in a.values.iter().enumerate() {
        let weight = over(meter, of_a, &number(a.arity))?;
        for (sum, of_b) in mask.values[from..].iter_mut().zip(b.values.iter().rev()) {
            add(meter, sum, &weight, of_b)?;
        }
    }
    Ok(mask)
}
