//! Functions of the limit φ of the data 1 at 0: φ(x) = Σ_k a_k φ(nx − k), Σ_k φ(x − k) = 1.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, number, within, wrong};
use super::integers::{at_integers, window};
use super::masks::{Mask, signed};
use super::steps::{add, over, plus, times};
use crate::data::converges;
use crate::formulas::MAX_INTEGER;
use crate::numbers::{Meter, Q, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One, ToPrimitive as _, Zero as _};
use std::rc::Rc;

/// The highest level of the points at which φ is evaluated.
const MAX_LEVEL: usize = 64;

/// The most binary digits of n^64, since n is at most 64.
const MAX_BITS: u64 = 385;

/// The greatest degree of a moment.
const MAX_DEGREE: i64 = 64;

const PLACE: Stop = Stop::Capped("the places of a limit function");

/// The value of such a function; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    let library = call.library;
    Ok(Some(match (call.function, call.arguments) {
        ("moment", [m]) => {
            let degree = within(m, 0, MAX_DEGREE)?;
            moment(library.meter, &Mask::of_numbers(library.meter, &*call.scheme()?)?, degree)?
        }
        ("limit_value", [x]) => limit_value(library, &*call.scheme()?, x)?,
        ("inner_product", [k]) => {
            let (scheme, k) = (call.scheme()?, k.integer(MAX_INTEGER)?);
            let other = call.named("with")?.unwrap_or_else(|| Rc::clone(&scheme));
            inner_product(library, &scheme, &other, k)?
        }
        _ => return Ok(None),
    }))
}

/// ∫ x^m φ(x) dx. From the refinement, n^{m+1}M_m = Σ_{i≤m} binomial(m, i) M_i Σ_k a_k k^{m−i}.
fn moment(meter: &Meter, mask: &Mask, degree: usize) -> Result<Value, Stop> {
    let (n, mut sums) = (number(mask.arity), Vec::new());
    let places: Vec<Value> = (mask.first..).zip(&mask.values).map(|(k, _)| Value::int(k)).collect();
    let mut terms = mask.values.clone();
    for _ in 0..=degree {
        let mut sum = Value::int(0);
        for (term, k) in terms.iter_mut().zip(&places) {
            plus(meter, &mut sum, term)?;
            *term = times(meter, term, k)?;
        }
        sums.push(sum);
    }
    // The row m of Pascal's triangle, and n^{m+1}.
    let (mut row, mut power) = (vec![BigInt::one()], n.clone());
    let mut moments = vec![Value::int(1)];
    while moments.len() <= degree {
        let pairs = row.windows(2).map(|pair| &pair[0] + &pair[1]);
        row = [BigInt::one()].into_iter().chain(pairs).chain([BigInt::one()]).collect();
        power = times(meter, &power, &n)?;
        let mut sum = Value::int(0);
        // The sums of the powers m, m − 1, …, 1.
        let sums = sums[1..=moments.len()].iter().rev();
        for ((choices, known), of_powers) in row.iter().zip(&moments).zip(sums) {
            let factor = times(meter, known, &Q::from_integer(choices.clone()).into())?;
            add(meter, &mut sum, &factor, of_powers)?;
        }
        moments.push(over(meter, &sum, &power.minus(&n)?)?);
    }
    moments.pop().ok_or(PLACE)
}

/// φ(x), where xn^k is an integer for some k up to a cap.
fn limit_value(library: &Library<'_>, scheme: &Scheme, x: &Value) -> Result<Value, Stop> {
    let (meter, x) = (library.meter, x.number()?.rational().ok_or(PLACE)?);
    let known = values(library, scheme)?;
    let mask = Mask::of_numbers(meter, scheme)?;
    let n = BigInt::from(mask.arity);
    if x.denom().bits() > MAX_BITS {
        return Err(PLACE);
    }
    let whole = x.floor().to_integer();
    let (mut rest, mut digits) = (x - Q::from_integer(whole.clone()), Vec::new());
    while !rest.is_zero() {
        if digits.len() == MAX_LEVEL {
            return Err(PLACE);
        }
        meter.spend(1)?;
        rest *= &n;
        let digit = rest.floor().to_integer();
        digits.push(digit.to_i64().ok_or(PLACE)?);
        rest -= Q::from_integer(digit);
    }
    // The values at the points f + m of one level, from the integer before the support on, where f = 0 at first.
    let first = window(&mask)?.0.checked_sub(1).ok_or(PLACE)?;
    let mut level = [&[Value::int(0)], &known[..]].concat();
    for digit in digits.into_iter().rev() {
        level = coarser(meter, &mask, (first, &level), digit)?;
    }
    let place = whole.to_i64().and_then(|whole| whole.checked_sub(first));
    let place = place.and_then(|place| usize::try_from(place).ok());
    Ok(place.and_then(|place| level.get(place)).cloned().unwrap_or_else(|| Value::int(0)))
}

/// The values at g + m, from those at f + m for ng = f + d: φ(g + m) = Σ_p a_{d+nm−p} φ(f + p).
fn coarser(
    meter: &Meter,
    mask: &Mask,
    (first, level): (i64, &[Value]),
    digit: i64,
) -> Result<Vec<Value>, Stop> {
    let n = signed(mask.arity)?;
    let value = |(m, _)| {
        let at = n.checked_mul(m).and_then(|at| at.checked_add(digit)).ok_or(PLACE)?;
        let mut sum = Value::int(0);
        for (p, value) in (first..).zip(level) {
            meter.spend(1)?;
            if let Some(a) = at.checked_sub(p).and_then(|k| mask.at(k)) {
                add(meter, &mut sum, a, value)?;
            }
        }
        Ok(sum)
    };
    (first..).zip(level).map(value).collect()
}

/// ∫ φ(x)ψ(x − k) dx.
fn inner_product(
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

/// Checks that a scheme is shown to converge.
pub fn exists(library: &Library<'_>, scheme: &Scheme) -> Result<(), Stop> {
    if scheme.limit.get().is_some() || converges(library, scheme)? {
        return Ok(());
    }
    Err(Stop::Capped("the levels up to which convergence is looked for"))
}

/// The values of φ at the integers of its support.
pub fn values(library: &Library<'_>, scheme: &Scheme) -> Result<Rc<[Value]>, Stop> {
    if let Some(known) = scheme.limit.get() {
        return Ok(Rc::clone(known));
    }
    let mask = Mask::of_numbers(library.meter, scheme)?;
    exists(library, scheme)?;
    let found: Rc<[Value]> = at_integers(library.meter, &mask)?.into();
    Ok(Rc::clone(scheme.limit.get_or_init(|| found)))
}
