//! Whether a limit exists, and its values at the integers.

#![warn(clippy::arithmetic_side_effects)]

use super::integers::at_integers;
use crate::data::{converges, converges_on};
use crate::functions::masks::Mask;
use crate::numbers::{Piece, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use std::rc::Rc;

/// The piece, for a mask with its symbol. A mask of numbers needs none, and what is known of it is known everywhere.
pub fn piece_of<'p>(scheme: &Scheme, piece: Option<&'p Piece<'p>>) -> Option<&'p Piece<'p>> {
    piece.filter(|_| scheme.numeric().is_err())
}

/// Checks that a scheme is shown to converge, on a piece if there is one.
pub fn exists(
    library: &Library<'_>,
    scheme: &Scheme,
    piece: Option<&Piece<'_>>,
) -> Result<(), Stop> {
    let shown = match piece {
        None => scheme.limit.get().is_some() || converges(library, scheme)?,
        Some(piece) => converges_on(library, scheme, piece)?,
    };
    if shown {
        Ok(())
    } else {
        Err(Stop::Capped("the levels up to which convergence is looked for"))
    }
}

/// The values of φ at the integers of its support.
pub fn values(
    library: &Library<'_>,
    scheme: &Scheme,
    piece: Option<&Piece<'_>>,
) -> Result<Rc<[Value]>, Stop> {
    if let (None, Some(known)) = (piece, scheme.limit.get()) {
        return Ok(Rc::clone(known));
    }
    let mask = Mask::on(library.meter, scheme, piece)?;
    exists(library, scheme, piece)?;
    let found: Rc<[Value]> = at_integers(library.meter, &mask, piece)?.into();
    if piece.is_some() {
        // Beyond the piece they may be others.
        return Ok(found);
    }
    Ok(Rc::clone(scheme.limit.get_or_init(|| found)))
}
