//! The integrals of the products of two limits.

#![warn(clippy::arithmetic_side_effects)]

use super::existing::exists;
use super::integers::{PLACE, at_integers, window};
use crate::functions::call::{number, wrong};
use crate::functions::masks::Mask;
use crate::functions::steps::{add, over};
use crate::numbers::Value;
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use std::rc::Rc;

/// ∫ φ(x)ψ(x − k) dx.
pub fn inner_product(
    library: &Library<'_>,
    scheme: &Scheme,
    other: &Scheme,
    k: i64,
) -> Result<Value, Stop> {
    let meter = library.meter;
    let (a, b) = (Mask::of_numbers(meter, scheme)?, Mask::of_numbers(meter, other)?);
    if a.arity != b.arity {
        return wrong("the two schemes are of two arities");
    }
    // c_j = Σ_{k−l=j} a_k b_l/n begins at the least k less the greatest l.
    let first = a.first.checked_sub(b.last()?).ok_or(PLACE)?;
    let length = a.values.len().saturating_add(b.values.len()).saturating_sub(1);
    let mut mask = Mask { arity: a.arity, first, values: vec![Value::int(0); length] };
    let window = window(&mask)?;
    let known = scheme.integrals.borrow().get(&std::ptr::from_ref(other)).cloned();
    let known = if let Some(known) = known {
        known
    } else {
        for scheme in [scheme, other] {
            exists(library, scheme)?;
        }
        for (from, of_a) in a.values.iter().enumerate() {
            let weight = over(meter, of_a, &number(a.arity))?;
            for (sum, of_b) in mask.values[from..].iter_mut().zip(b.values.iter().rev()) {
                add(meter, sum, &weight, of_b)?;
            }
        }
        let found: Rc<[Value]> = at_integers(meter, &mask)?.into();
        scheme.integrals.borrow_mut().insert(other, Rc::clone(&found));
        found
    };
    let place = k.checked_sub(window.0).and_then(|place| usize::try_from(place).ok());
    Ok(place.and_then(|place| known.get(place)).cloned().unwrap_or_else(|| Value::int(0)))
}
