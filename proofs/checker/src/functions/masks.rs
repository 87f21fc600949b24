//! Functions of the coefficients a_k of a mask.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, number, wrong};
use super::reproduction::reproduction;
use super::steps::{add, plus, times};
use crate::formulas::MAX_INTEGER;
use crate::numbers::{Meter, Piece, Value, count, int};
use crate::schemes::Scheme;
use crate::text::Stop;

/// The coefficients a_l, …, a_K of a mask; neither a_l nor a_K is 0.
pub struct Mask {
    /// n.
    pub arity: usize,
    /// l.
    pub first: i64,
    /// The coefficients.
    pub values: Vec<Value>,
}

const PLACE: Stop = Stop::Capped("the places of the coefficients of a mask");

/// An index as a number with a sign.
pub fn signed(index: usize) -> Result<i64, Stop> {
    i64::try_from(index).map_err(|_| PLACE)
}

/// The value of such a function; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    let (meter, piece) = (call.library.meter, call.piece());
    let truth = |is: bool| Value::int(is.into());
    let value = match (call.function, call.arguments) {
        ("coefficient", [k]) => coefficient(&*call.scheme()?, k.integer(MAX_INTEGER)?)?,
        ("symbol_at", [z]) => Mask::of(meter, &*call.scheme()?, piece)?.symbol_at(meter, z)?,
        ("support_start", []) => Mask::called(call)?.parts(|mask| Ok(mask.first))?,
        ("support_end", []) => Mask::called(call)?.parts(Mask::last)?,
        ("support", []) => Mask::called(call)?.parts(Mask::length)?,
        ("symmetric", []) => truth(Mask::called(call)?.is_symmetric(piece)?),
        ("interpolating", []) => {
            let scheme = call.scheme()?;
            meter.spend(number_of_entries(&scheme))?;
            if piece.is_none() {
                scheme.numeric()?;
            }
            let mut rules = scheme.mask.iter();
            truth(rules.try_fold(false, |is, rule| Ok(is || is_unit(rule, piece)?))?)
        }
        ("sum_rules", []) => number(Mask::called(call)?.sum_rules(meter, piece)?),
        ("generation", []) => {
            number(Mask::called(call)?.sum_rules(meter, piece)?).minus(&Value::int(1))?
        }
        ("reproduction", []) => {
            let scheme = call.scheme()?;
            let indexed = call.choose("parameters", &["natural", "indexed"])? == 1;
            number(reproduction(meter, &scheme, indexed, piece)?)
        }
        ("approximation_order", []) if call.choose("data", &["sampled", "adapted"])? == 1 => {
            number(Mask::called(call)?.sum_rules(meter, piece)?)
        }
        ("approximation_order", []) => {
            let degree = reproduction(meter, &*call.scheme()?, false, piece)?;
            number(degree).plus(1, &Value::int(1))?
        }
        ("same", []) => {
            let (one, Some(other)) = (call.scheme()?, call.named("with")?) else {
                return wrong("the option `with` is missing");
            };
            let one = Mask::on(meter, &one, piece)?;
            truth(one.is(&Mask::of_numbers(meter, &other)?, piece)?)
        }
        ("orthogonal", []) => {
            let mask = Mask::called(call)?;
            truth(mask.is_dual_to(&mask, meter, piece)?)
        }
        ("biorthogonal", []) => {
            let mask = Mask::called(call)?;
            let Some(other) = call.named("with")? else {
                return wrong("the option `with` is missing");
            };
            truth(mask.is_dual_to(&Mask::of_numbers(meter, &other)?, meter, piece)?)
        }
        _ => return Ok(None),
    };
    Ok(Some(value))
}

fn number_of_entries(scheme: &Scheme) -> u64 {
    (scheme.arity() as u64).saturating_mul(scheme.width() as u64)
}

/// Whether two values are equal on a piece.
fn equal(one: &Value, other: &Value, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
    one.minus(other)?.is_zero_on(piece)
}

/// Whether a rule keeps one point as it is.
fn is_unit(rule: &[Value], piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
    let mut others = Vec::new();
    for a in rule {
        if !a.is_zero_on(piece)? {
            others.push(a);
        }
    }
    match others[..] {
        [only] => equal(only, &Value::int(1), piece),
        _ => Ok(false),
    }
}

/// The k of the first entry: α − n(o + j) for α = 0 and j = N − 1. The others follow in the order of −j and α.
fn start(scheme: &Scheme) -> Result<i64, Stop> {
    let last = signed(scheme.width())?.checked_sub(1).and_then(|j| scheme.offset.checked_add(j));
    let start = last.and_then(|last| last.checked_mul(signed(scheme.arity()).ok()?)?.checked_neg());
    start.ok_or(PLACE)
}

/// a_k.
fn coefficient(scheme: &Scheme, k: i64) -> Result<Value, Stop> {
    let place = k.checked_sub(start(scheme)?).ok_or(PLACE)?;
    let entry = usize::try_from(place).ok().and_then(|place| {
        let (back, alpha) =
            (place.checked_div(scheme.arity())?, place.checked_rem(scheme.arity())?);
        let j = scheme.width().checked_sub(back)?.checked_sub(1)?;
        scheme.mask.get(alpha)?.get(j)
    });
    Ok(entry.cloned().unwrap_or_else(|| Value::int(0)))
}

impl Mask {
    /// The coefficients of a scheme. On a piece, those that are 0 there are left out at both ends.
    fn of(meter: &Meter, scheme: &Scheme, piece: Option<&Piece<'_>>) -> Result<Mask, Stop> {
        let columns = (0..scheme.width()).rev();
        let all = columns.flat_map(|j| scheme.mask.iter().filter_map(move |rule| rule.get(j)));
        let mut values: Vec<Value> = Vec::new();
        for a in all {
            meter.spend(a.cost(a))?;
            values.push(a.clone());
        }
        while let Some(last) = values.last()
            && last.is_zero_on(piece)?
        {
            values.pop();
        }
        if values.is_empty() {
            return wrong("the symbol is 0");
        }
        let mut zeros = 0_usize;
        while let Some(first) = values.get(zeros)
            && first.is_zero_on(piece)?
        {
            zeros = zeros.saturating_add(1);
        }
        let first = start(scheme)?.checked_add(signed(zeros)?).ok_or(PLACE)?;
        Ok(Mask { arity: scheme.arity(), first, values: values.split_off(zeros) })
    }

    /// The same, which have to be numbers.
    pub fn of_numbers(meter: &Meter, scheme: &Scheme) -> Result<Mask, Stop> {
        Mask::on(meter, scheme, None)
    }

    /// The same, which have to be numbers but on a piece.
    pub fn on(meter: &Meter, scheme: &Scheme, piece: Option<&Piece<'_>>) -> Result<Mask, Stop> {
        if piece.is_none() {
            scheme.numeric()?;
        }
        Mask::of(meter, scheme, piece)
    }

    /// The same of the scheme of a call.
    pub fn called(call: &mut Call<'_>) -> Result<Mask, Stop> {
        Mask::on(call.library.meter, &*call.scheme()?, call.piece())
    }

    /// K − l.
    fn length(&self) -> Result<i64, Stop> {
        signed(self.values.len())?.checked_sub(1).ok_or(PLACE)
    }

    /// K.
    pub fn last(&self) -> Result<i64, Stop> {
        self.first.checked_add(self.length()?).ok_or(PLACE)
    }

    /// a_k, if it is not beyond l and K.
    pub fn at(&self, k: i64) -> Option<&Value> {
        self.values.get(usize::try_from(k.checked_sub(self.first)?).ok()?)
    }

    /// A place over n − 1.
    fn parts(&self, place: impl Fn(&Mask) -> Result<i64, Stop>) -> Result<Value, Stop> {
        Ok((int(place(self)?) / (count(self.arity) - int(1))).into())
    }

    /// a(z), by Horner's rule from a_K down to a_l, and then z^l.
    fn symbol_at(&self, meter: &Meter, z: &Value) -> Result<Value, Stop> {
        let mut sum = Value::int(0);
        for a in self.values.iter().rev() {
            sum = times(meter, &sum, z)?;
            plus(meter, &mut sum, a)?;
        }
        let power = z.power(self.first)?;
        meter.spend(power.steps(&power))?;
        times(meter, &sum, &power)
    }

    fn is_symmetric(&self, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
        for (a, b) in self.values.iter().zip(self.values.iter().rev()) {
            if !equal(a, b, piece)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether both are of one arity and have the same coefficients.
    fn is(&self, other: &Mask, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
        let places = (self.arity, self.first, self.values.len());
        if places != (other.arity, other.first, other.values.len()) {
            return Ok(false);
        }
        for (a, b) in self.values.iter().zip(&other.values) {
            if !equal(a, b, piece)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// How often 1 + z + … + z^{n−1} divides a(z).
    pub fn sum_rules(&self, meter: &Meter, piece: Option<&Piece<'_>>) -> Result<usize, Stop> {
        let (mut rest, mut order) = (self.values.clone(), 0_usize);
        while let Some(quotient) = quotient(meter, &rest, self.arity, piece)? {
            rest = quotient;
            order = order.saturating_add(1);
        }
        Ok(order)
    }

    /// Whether Σ_k a_k b_{k+nm} is n for m = 0, and 0 for all other m.
    fn is_dual_to(
        &self,
        other: &Mask,
        meter: &Meter,
        piece: Option<&Piece<'_>>,
    ) -> Result<bool, Stop> {
        if self.arity != other.arity {
            return wrong("the two masks are of two arities");
        }
        let n = signed(self.arity)?;
        // Of other m, no k is between both pairs of ends.
        let least = other.first.checked_sub(self.last()?).ok_or(PLACE)?.div_euclid(n);
        let most = other.last()?.checked_sub(self.first).ok_or(PLACE)?.div_euclid(n);
        if least > 0 || most < 0 {
            return Ok(false);
        }
        for m in least..=most {
            let by = n.checked_mul(m).and_then(|by| by.checked_add(self.first)).ok_or(PLACE)?;
            let mut sum = Value::int(0);
            for (k, a) in (by..).zip(&self.values) {
                meter.spend(1)?;
                if let Some(b) = other.at(k) {
                    add(meter, &mut sum, a, b)?;
                }
            }
            let expected = if m == 0 { number(self.arity) } else { Value::int(0) };
            if !equal(&sum, &expected, piece)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// p/(1 + z + … + z^{n−1})^m, if that is a polynomial.
pub fn divided(
    meter: &Meter,
    p: &[Value],
    (n, m): (usize, usize),
    piece: Option<&Piece<'_>>,
) -> Result<Option<Vec<Value>>, Stop> {
    let mut rest = p.to_vec();
    for _ in 0..m {
        let Some(next) = quotient(meter, &rest, n, piece)? else { return Ok(None) };
        rest = next;
    }
    Ok(Some(rest))
}

/// Σ_i p_{i+k}p_i for k from 0 on.
pub fn correlations(meter: &Meter, p: &[Value]) -> Result<Vec<Value>, Stop> {
    let sum = |k: usize| {
        let mut sum = Value::int(0);
        for (a, b) in p.iter().skip(k).zip(p) {
            add(meter, &mut sum, a, b)?;
        }
        Ok(sum)
    };
    (0..p.len()).map(sum).collect()
}

/// p/(1 + z + … + z^{n−1}), if that is a polynomial. It is (1 − z)p/(1 − z^n), a power series whose coefficients behind
/// the degree of p less n − 1 have to be 0: n of them in a row are enough.
pub fn quotient(
    meter: &Meter,
    p: &[Value],
    n: usize,
    piece: Option<&Piece<'_>>,
) -> Result<Option<Vec<Value>>, Stop> {
    let Some(degree) = p.len().checked_sub(n) else { return Ok(None) };
    let (mut series, zero) = (Vec::<Value>::with_capacity(p.len()), Value::int(0));
    for i in 0..=p.len() {
        let mut next = p.get(i).unwrap_or(&zero).clone();
        let before = i.checked_sub(1).map(|i| p[i].negated()).transpose()?;
        let earlier = i.checked_sub(n).map(|i| series[i].clone());
        for term in before.iter().chain(&earlier) {
            plus(meter, &mut next, term)?;
        }
        if i > degree && !next.is_zero_on(piece)? {
            return Ok(None);
        }
        series.push(next);
    }
    series.truncate(degree.saturating_add(1));
    Ok(Some(series))
}
