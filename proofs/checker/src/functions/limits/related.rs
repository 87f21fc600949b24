//! The schemes of derivatives and of integrals.
//!
//! With σ(z) = 1 + z + … + z^{n−1}, the limit of a(z)σ(z)/n is the convolution of that of a(z) with the interval from 0 to 1.

#![warn(clippy::arithmetic_side_effects)]

use super::existing::exists;
use super::integers::{PLACE, at_integers};
use crate::functions::call::number;
use crate::functions::masks::{Mask, quotient, signed};
use crate::functions::steps::{over, plus, times};
use crate::numbers::{Piece, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use std::rc::Rc;

/// The scheme of ψ with φ^{(m)}(x) = Σ_{i≤m} (−1)^i binomial(m, i) ψ(x − i), b(z) = n^m a(z)/σ(z)^m. It is shown to converge.
pub fn derived(
    library: &Library<'_>,
    (scheme, piece): (&Scheme, Option<&Piece<'_>>),
    order: usize,
) -> Result<Rc<Scheme>, Stop> {
    let known = scheme.derived.borrow().get(&order).cloned().filter(|_| piece.is_none());
    let found = if let Some(known) = known {
        known
    } else {
        let (meter, mask) = (library.meter, Mask::on(library.meter, scheme, piece)?);
        let (n, mut values) = (number(mask.arity), mask.values);
        for _ in 0..order {
            let Some(next) = quotient(meter, &values, mask.arity, piece)? else {
                return Err(Stop::Wrong("the symbol has no derivative of this order".into()));
            };
            values = next.iter().map(|b| times(meter, b, &n)).collect::<Result<_, Stop>>()?;
        }
        if quotient(meter, &values, mask.arity, piece)?.is_none() {
            return Err(Stop::Capped("derivatives that are not shown to exist"));
        }
        let found = Rc::new(scheme_of(&Mask { values, ..mask }, piece)?);
        if piece.is_none() {
            scheme.derived.borrow_mut().insert(order, Rc::clone(&found));
        }
        found
    };
    exists(library, &found, piece)?;
    Ok(found)
}

/// The scheme of χ with ∫_{x−1}^x φ = χ(x). It converges if that of φ does.
pub fn antiderivative(
    library: &Library<'_>,
    scheme: &Scheme,
    piece: Option<&Piece<'_>>,
) -> Result<Rc<Scheme>, Stop> {
    if let (None, Some(known)) = (piece, scheme.antiderivative.get()) {
        return Ok(Rc::clone(known));
    }
    let (meter, mask) = (library.meter, Mask::on(library.meter, scheme, piece)?);
    let (n, length) = (number(mask.arity), mask.values.len());
    let (mut values, mut sum) = (Vec::new(), Value::int(0));
    for k in 0..length.saturating_add(mask.arity).saturating_sub(1) {
        if let Some(a) = mask.values.get(k) {
            plus(meter, &mut sum, a)?;
        }
        if let Some(a) = k.checked_sub(mask.arity).and_then(|k| mask.values.get(k)) {
            plus(meter, &mut sum, &a.negated()?)?;
        }
        values.push(over(meter, &sum, &n)?);
    }
    let mask = Mask { values, ..mask };
    let found = scheme_of(&mask, piece)?;
    if piece.is_some() {
        return Ok(Rc::new(found));
    }
    // Its existence needs no levels of its own.
    let integers: Rc<[Value]> = at_integers(meter, &mask, None)?.into();
    found.limit.get_or_init(|| integers);
    Ok(Rc::clone(scheme.antiderivative.get_or_init(|| Rc::new(found))))
}

/// The scheme with these coefficients: a_k is in the rule α = k mod n, of the point (α − k)/n.
pub fn scheme_of(mask: &Mask, piece: Option<&Piece<'_>>) -> Result<Scheme, Stop> {
    let n = signed(mask.arity)?;
    let point = |k: i64| k.checked_div_euclid(n).and_then(i64::checked_neg).ok_or(PLACE);
    let (first, last) = (point(mask.last()?)?, point(mask.first)?);
    let mut rules = Vec::new();
    for alpha in 0..n {
        let entry = |point: i64| {
            let k = n.checked_mul(point).and_then(|k| alpha.checked_sub(k)).ok_or(PLACE)?;
            Ok(mask.at(k).cloned().unwrap_or_else(|| Value::int(0)))
        };
        rules.push((first..=last).map(entry).collect::<Result<Vec<Value>, Stop>>()?);
    }
    Scheme::on(rules, first, piece)
}
