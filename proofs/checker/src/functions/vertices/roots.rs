//! Real roots of polynomials over a field Q(2cos(2π/n)), with their multiplicities.

#![warn(clippy::arithmetic_side_effects)]

use super::blocks::Polynomial;
use crate::functions::real::Real;
use crate::numbers::{Meter, Number, Q, field};
use crate::shipped::{Interval, Sturm};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;
use std::cmp::Ordering;

/// The binary digits to which roots are enclosed.
const DIGITS: u64 = 384;

/// A real root.
#[derive(Clone)]
pub struct Root {
    /// The number.
    pub value: Real,
    /// An interval with it.
    pub near: Interval,
    /// How often it is a root.
    pub multiplicity: usize,
}

/// The roots of a polynomial.
pub struct Roots {
    /// The real ones, in decreasing order.
    pub real: Vec<Root>,
    /// The number of the others, each as often as it is one.
    pub others: usize,
}

/// An interval with a number.
pub fn enclosed(number: &Number) -> Result<Interval, Stop> {
    let (n, coordinates) = number.coordinates();
    if let Some(value) = number.rational() {
        return Interval::point(value);
    }
    let bits = DIGITS.saturating_add(64);
    let low = field(n).enclose(bits);
    let exponent = i64::try_from(bits).unwrap_or(0).saturating_neg();
    let x = Interval::new(low.clone(), low + BigInt::one(), exponent, bits)?;
    coordinates.iter().rev().try_fold(Interval::from(0), |sum, c| {
        sum.times(&x, bits)?.plus(&Interval::point(c.clone())?, bits)
    })
}

fn trimmed(mut p: Polynomial) -> Polynomial {
    while p.last().is_some_and(Number::is_zero) {
        p.pop();
    }
    p
}

/// The quotient and the remainder. The divisor is not 0.
fn divided(p: &Polynomial, divisor: &Polynomial, meter: &Meter) -> Result<[Polynomial; 2], Stop> {
    let (mut rest, degree) = (p.clone(), divisor.len().saturating_sub(1));
    let lead =
        divisor.last().and_then(Number::inverse).ok_or(Stop::Undefined("it divides by 0"))?;
    let mut quotient = Vec::new();
    while rest.len() > degree {
        let Some(top) = rest.pop() else { break };
        let factor = top.times(&lead)?;
        let from = rest.len().saturating_sub(degree);
        for (c, d) in rest[from..].iter_mut().zip(divisor) {
            meter.spend(factor.cost_in_field(d).saturating_add(1))?;
            *c = c.plus(-1, &factor.times(d)?)?;
        }
        quotient.insert(0, factor);
    }
    Ok([quotient, trimmed(rest)])
}

fn common(p: &Polynomial, q: &Polynomial, meter: &Meter) -> Result<Polynomial, Stop> {
    let (mut p, mut q) = (p.clone(), trimmed(q.clone()));
    while !q.is_empty() {
        let [_, rest] = divided(&p, &q, meter)?;
        (p, q) = (q, rest);
    }
    // With a leading coefficient 1 the numbers stay short.
    let lead = p.last().and_then(Number::inverse).ok_or(Stop::Undefined("it divides by 0"))?;
    p.iter().map(|c| c.times(&lead)).collect()
}

/// The real roots of a polynomial without multiple ones, in increasing order.
fn simple(p: &Polynomial, meter: &Meter) -> Result<Vec<(Real, Interval)>, Stop> {
    if let [constant, lead] = &p[..] {
        let inverse = lead.inverse().ok_or(Stop::Undefined("it divides by 0"))?;
        let root = constant.times(&inverse)?.times(&Number::Small(-1, 1))?;
        return Ok(vec![(Real::Exact(root.clone().into()), enclosed(&root)?)]);
    }
    let near = p.iter().map(enclosed).collect::<Result<Vec<Interval>, Stop>>()?;
    let sturm = Sturm::new(&near, DIGITS, meter)?;
    let mut roots: Vec<(Real, Interval)> = Vec::new();
    for number in 1..=i64::try_from(p.len()).unwrap_or(i64::MAX) {
        match sturm.root(number) {
            Ok(near) => {
                let exact = near.exact().cloned();
                let value =
                    exact.map_or(Real::RootOf(p.clone(), number), |x| Real::Exact(x.into()));
                roots.push((value, near));
            }
            Err(Stop::Undefined(_)) => break,
            Err(stop) => return Err(stop),
        }
    }
    Ok(roots)
}

/// All real roots.
pub fn roots(p: &Polynomial, meter: &Meter) -> Result<Roots, Stop> {
    let degree = p.len().saturating_sub(1);
    let (ones, p) = without_one(p, meter)?;
    let mut rest = p.clone();
    let mut real: Vec<Root> = Vec::new();
    // Of the roots of the greatest common divisor with the derivative, each is there once less often.
    while rest.len() > 1 {
        let slope = (1..).zip(rest.iter().skip(1)).map(|(k, c)| c.times(&Number::Small(k, 1)));
        let slope = slope.collect::<Result<Polynomial, Stop>>()?;
        let shared = common(&rest, &slope, meter)?;
        let [factor, _] = divided(&rest, &shared, meter)?;
        let found = simple(&factor, meter)?;
        if rest.len() == p.len() {
            real = found
                .into_iter()
                .map(|(value, near)| Root { value, near, multiplicity: 1 })
                .collect();
        } else {
            for (_, near) in found {
                let mut same = real.iter_mut().filter(|root| !is_apart(&root.near, &near));
                let (Some(root), None) = (same.next(), same.next()) else {
                    return Err(Stop::Capped("the digits that separate eigenvalues"));
                };
                root.multiplicity = root.multiplicity.saturating_add(1);
            }
        }
        rest = shared;
    }
    if ones > 0 {
        let value = Real::Exact(Number::Small(1, 1).into());
        let place =
            real.partition_point(|root| root.near.compare(&1.into()) == Some(Ordering::Less));
        if real.iter().any(|root| !is_apart(&root.near, &1.into())) {
            return Err(Stop::Capped("the digits that separate eigenvalues"));
        }
        real.insert(place, Root { value, near: 1.into(), multiplicity: ones });
    }
    let counted: usize = real.iter().map(|root| root.multiplicity).sum();
    real.reverse();
    Ok(Roots { real, others: degree.saturating_sub(counted) })
}

/// How often 1 is a root, and the quotient without these.
fn without_one(p: &Polynomial, meter: &Meter) -> Result<(usize, Polynomial), Stop> {
    let (mut ones, mut rest) = (0_usize, p.clone());
    let factor = vec![Number::Small(-1, 1), Number::Small(1, 1)];
    while rest.len() > 1 {
        let [quotient, remainder] = divided(&rest, &factor, meter)?;
        if !remainder.is_empty() {
            break;
        }
        (ones, rest) = (ones.saturating_add(1), quotient);
    }
    Ok((ones, rest))
}

/// Whether two intervals have no number in common.
fn is_apart(one: &Interval, other: &Interval) -> bool {
    matches!(one.compare(other), Some(Ordering::Less | Ordering::Greater))
}

/// |x| of a root, as a number and an interval.
pub fn size(root: &Root) -> Result<(Real, Interval), Stop> {
    let negative = match root.near.sign() {
        Some(sign) => sign < 0,
        None => return Err(Stop::Capped("the digits of an eigenvalue near 0")),
    };
    let minus = || Real::Exact(Q::from_integer((-1).into()).into());
    let value = match &root.value {
        Real::Exact(value) if negative => Real::Exact(value.negated()?),
        value if negative => Real::Ratio(Box::new(value.clone()), Box::new(minus())),
        value => value.clone(),
    };
    Ok((value, root.near.absolute()))
}
