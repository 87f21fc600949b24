//! Functions of the limit φ of the data 1 at 0: φ(x) = Σ_k a_k φ(nx − k), Σ_k φ(x − k) = 1.

#![warn(clippy::arithmetic_side_effects)]

mod existing;
mod integers;
mod moments;
mod points;
mod polynomials;
mod products;
mod related;

use super::call::{Call, within};
use super::extremes::extreme;
use super::masks::Mask;
use super::real::Real;
use crate::formulas::MAX_INTEGER;
use crate::numbers::Value;
use crate::text::Stop;
use std::rc::Rc;

pub use existing::{exists, piece_of, values};
pub use integers::{solve, window};

/// The greatest degree of a moment.
const MAX_DEGREE: i64 = 64;

/// The greatest order of a derivative.
const MAX_ORDER: usize = 16;

/// The value of such a function; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    let library = call.library;
    Ok(Some(match (call.function, call.arguments) {
        ("moment", [m]) => {
            let degree = within(m, 0, MAX_DEGREE)?;
            let mask = Mask::called(call)?;
            moments::moment(library.meter, &mask, degree)?
        }
        ("limit_value", [x]) => {
            let (scheme, order) = (call.scheme()?, call.word("derivative", "0"));
            let piece = piece_of(&scheme, call.piece());
            let wrong = || Stop::Wrong(format!("`{order}` is no order of a derivative"));
            let order: usize = order.parse().map_err(|_| wrong())?;
            if order > MAX_ORDER {
                return Err(Stop::Capped("the order of a derivative"));
            }
            points::derivative(library, (&scheme, piece), x, order)?
        }
        ("integral", [x, y]) => {
            let scheme = call.scheme()?;
            points::integral(library, (&scheme, piece_of(&scheme, call.piece())), [x, y])?
        }
        ("inner_product", [k]) => {
            let (scheme, k) = (call.scheme()?, k.integer(MAX_INTEGER)?);
            let other = call.named("with")?.unwrap_or_else(|| Rc::clone(&scheme));
            products::inner_product(library, (&scheme, &other), k, call.piece())?
        }
        _ => return real(call)?.map(Real::value).transpose(),
    }))
}

/// The functions among them whose values may be any real numbers.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    let upper = match (call.function, call.arguments) {
        ("riesz_lower", []) => false,
        ("riesz_upper", []) => true,
        _ => return Ok(None),
    };
    let scheme = call.scheme()?;
    let (first, known) = products::inner_products(call.library, &scheme, &scheme, None)?;
    extreme(call.library.meter, (first, &known), upper).map(Some)
}
