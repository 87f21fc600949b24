//! Products of the values of a polynomial at the roots of another one, where the coefficients are polynomials in v.

#![warn(clippy::arithmetic_side_effects)]

use super::euclid::{Coefficient, Polynomial};
use crate::numbers::{Meter, Q, at, bits, divide, int, multiplied, trimmed};
use crate::text::Stop;
use num_traits::{One as _, Pow, Zero as _};

/// The highest degree in v.
const MAX_DEGREE: usize = 400;

/// c^l·Π q(α) over the roots α of p, where c ≠ 0 is the leading coefficient of p, and l the degree of q. It is a polynomial in the
/// coefficients of both, of degree l in those of p, and m, the degree of p, in those of q.
pub fn norm(meter: &Meter, p: &Polynomial, q: &Polynomial) -> Result<Coefficient, Stop> {
    let (Some(m), Some(l)) = (p.len().checked_sub(1), q.len().checked_sub(1)) else {
        return Ok(Vec::new());
    };
    let in_v = |p: &Polynomial| p.iter().map(|c| c.len().saturating_sub(1)).max().unwrap_or(0);
    let degree = l.saturating_mul(in_v(p)).saturating_add(m.saturating_mul(in_v(q)));
    if degree > MAX_DEGREE {
        return Err(Stop::Capped("the degree of a norm"));
    }
    let (mut points, mut values) = (Vec::new(), Vec::new());
    // 0, 1, −1, 2, −2, …, but for those where p is of a lower degree.
    for i in 0_i64.. {
        if points.len() > degree {
            break;
        }
        let half = i.midpoint(1);
        let x = int(if i % 2 == 0 { half.saturating_neg() } else { half });
        let [p, q] = [p, q].map(|p| p.iter().map(|c| at(c, &x)).collect::<Vec<Q>>());
        let Some(leading) = p.last().filter(|c| !c.is_zero()).cloned() else { continue };
        values.push(Pow::pow(&leading, l) * product(meter, &p, trimmed(q))?);
        points.push(x);
    }
    interpolated(meter, &points, values)
}

/// Π q(α) over the roots α of p ≠ 0. With the leading coefficient 1 the fractions remain short.
fn product(meter: &Meter, p: &[Q], mut q: Vec<Q>) -> Result<Q, Stop> {
    let monic = |p: &[Q], leading: &Q| p.iter().map(|c| c / leading).collect::<Vec<Q>>();
    let (mut p, mut product) = (p.last().map(|a| monic(p, a)).unwrap_or_default(), Q::one());
    while p.len() > 1 {
        let digits = p.iter().chain(&q).map(bits).max().unwrap_or(0) / 64;
        let pairs = p.len().saturating_mul(q.len()) as u64;
        meter
            .spend(pairs.saturating_mul((digits.saturating_mul(digits) / 16).saturating_add(1)))?;
        let rest = trimmed(divide(q, &p).1);
        let Some(c) = rest.last().cloned() else { return Ok(Q::zero()) };
        // With the roots β of the remainder: Π_α cΠ_β(α − β) = c^mΠ_β(−1)^m p(β).
        let (m, k) = (p.len().saturating_sub(1), rest.len().saturating_sub(1));
        product *= Pow::pow(&c, m);
        if m % 2 == 1 && k % 2 == 1 {
            product = -product;
        }
        (q, p) = (p, monic(&rest, &c));
    }
    Ok(product)
}

/// The polynomial that has these values at these points, by divided differences.
fn interpolated(meter: &Meter, points: &[Q], mut values: Vec<Q>) -> Result<Coefficient, Stop> {
    let digits = values.iter().map(bits).max().unwrap_or(0) / 64;
    let pairs = (points.len() as u64).saturating_mul(points.len() as u64);
    meter.spend(pairs.saturating_mul(digits.saturating_add(1)))?;
    for by in 1..points.len() {
        for i in (by..points.len()).rev() {
            let before = i.saturating_sub(1);
            let run = &points[i] - &points[i.saturating_sub(by)];
            values[i] = (&values[i] - &values[before]) / run;
        }
    }
    let mut sum = Vec::new();
    for (x, value) in points.iter().zip(&values).rev() {
        let mut next = multiplied(&sum, &[-x, int(1)]);
        next.resize(next.len().max(1), Q::zero());
        next[0] += value;
        sum = next;
    }
    Ok(trimmed(sum))
}
