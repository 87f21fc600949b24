//! Matrices of polynomials in one parameter.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Q, bits, int, product_steps};
use crate::radius::Rational;
use crate::text::Stop;
use num_traits::Zero as _;

/// The greatest degree of an entry.
const MAX_DEGREE: usize = 256;

/// sum + x·y, for steps.
fn accumulate(meter: &Meter, sum: &mut Q, x: &Q, y: &Q) -> Result<(), Stop> {
    if x.is_zero() || y.is_zero() {
        return Ok(());
    }
    let length = [&*sum, x, y].map(bits).into_iter().fold(0, u64::saturating_add);
    meter.spend(product_steps(length))?;
    *sum += x * y;
    Ok(())
}

/// The matrix 0 of this size.
fn zero(size: usize) -> Rational {
    vec![vec![Q::zero(); size]; size]
}

/// Adds a product of matrices.
fn add_product(meter: &Meter, sum: &mut Rational, a: &Rational, b: &Rational) -> Result<(), Stop> {
    let size = a.len() as u64;
    meter.spend((size.saturating_mul(size) / 64).saturating_mul(size))?;
    for (row, entries) in sum.iter_mut().zip(a) {
        for (x, others) in entries.iter().zip(b) {
            for (sum, y) in row.iter_mut().zip(others) {
                accumulate(meter, sum, x, y)?;
            }
        }
    }
    Ok(())
}

/// All products of so many matrices, of which there are at most so many, times a number: each by its coefficients on the powers, which are all as many. The
/// matrices are given power by power.
pub fn products(
    meter: &Meter,
    of_powers: &[Vec<Rational>],
    (count, most): (usize, usize),
    factor: &Q,
) -> Result<Vec<Vec<Rational>>, Stop> {
    let of_part = |i: usize| -> Vec<Rational> {
        of_powers.iter().filter_map(|all| all.get(i).cloned()).collect()
    };
    let own: Vec<Vec<Rational>> = (0..of_powers.first().map_or(0, Vec::len)).map(of_part).collect();
    let mut all = own.clone();
    for _ in 1..count {
        let mut next = Vec::new();
        if all.len().saturating_mul(own.len()) > most {
            return Err(Stop::Capped("the number of products of matrices"));
        }
        for a in &all {
            for b in &own {
                next.push(product(meter, a, b)?);
            }
        }
        all = next;
    }
    for x in all.iter_mut().flatten().flatten().flatten() {
        meter.spend(product_steps(bits(x).saturating_add(bits(factor))))?;
        *x *= factor;
    }
    // Of the greatest degree of an entry.
    let is_zero = |matrix: &Rational| matrix.iter().flatten().all(Q::is_zero);
    while all.iter().all(|powers| powers.len() > 1 && powers.last().is_some_and(is_zero)) {
        for powers in &mut all {
            powers.pop();
        }
    }
    Ok(all)
}

/// The product of two matrices of polynomials.
fn product(meter: &Meter, a: &[Rational], b: &[Rational]) -> Result<Vec<Rational>, Stop> {
    let count = a.len().saturating_add(b.len()).saturating_sub(1);
    if count > MAX_DEGREE.saturating_add(1) {
        return Err(Stop::Capped("the degree of a product of matrices"));
    }
    let mut sum = vec![zero(a.first().map_or(0, Vec::len)); count];
    for (i, x) in a.iter().enumerate() {
        for (y, sum) in b.iter().zip(sum.iter_mut().skip(i)) {
            add_product(meter, sum, x, y)?;
        }
    }
    Ok(sum)
}

/// The matrices C_0, …, C_D of each, for which it is Σ C_j·binomial(D, j)t^j(1 − t)^{D−j} at a + (b − a)t.
pub fn bernstein(
    meter: &Meter,
    all: &[Vec<Rational>],
    (a, b): (&Q, &Q),
) -> Result<Vec<Rational>, Stop> {
    let degree = all.first().map_or(0, Vec::len).saturating_sub(1);
    let weights = weights(meter, degree, (a, &(b - a)))?;
    let mut found = Vec::new();
    for powers in all {
        let size = powers.first().map_or(0, Vec::len);
        for weights in &weights {
            let mut sum = zero(size);
            for (weight, matrix) in weights.iter().zip(powers) {
                for (row, others) in sum.iter_mut().zip(matrix) {
                    for (sum, x) in row.iter_mut().zip(others) {
                        accumulate(meter, sum, weight, x)?;
                    }
                }
            }
            found.push(sum);
        }
    }
    Ok(found)
}

/// For each j the coefficient of Bernstein j of (a + lt)^p, p = 0, …, D. That of t^i is binomial(j, i)/binomial(D, i).
fn weights(meter: &Meter, degree: usize, (a, l): (&Q, &Q)) -> Result<Vec<Vec<Q>>, Stop> {
    // (a + lt)^p by its coefficients on the t^i.
    let mut powers: Vec<Vec<Q>> = vec![vec![int(1)]];
    for p in 0..degree {
        let before = &powers[p];
        let mut next = vec![Q::zero(); before.len().saturating_add(1)];
        for (i, c) in before.iter().enumerate() {
            accumulate(meter, &mut next[i], c, a)?;
            accumulate(meter, &mut next[i.saturating_add(1)], c, l)?;
        }
        powers.push(next);
    }
    let of = |j: usize| -> Result<Vec<Q>, Stop> {
        // binomial(j, i)/binomial(D, i) is the product of the (j − h)/(D − h), h < i.
        let mut ratios = vec![int(1)];
        for h in 0..j {
            let number = |x: usize| Q::from_integer(x.saturating_sub(h).into());
            let last = ratios.last().cloned().unwrap_or_default();
            ratios.push(last * number(j) / number(degree));
        }
        let mut sums = Vec::new();
        for power in &powers {
            let mut sum = Q::zero();
            for (c, ratio) in power.iter().zip(&ratios) {
                accumulate(meter, &mut sum, c, ratio)?;
            }
            sums.push(sum);
        }
        Ok(sums)
    };
    (0..=degree).map(of).collect()
}
