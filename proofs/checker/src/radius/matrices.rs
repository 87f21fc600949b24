//! Matrices of real numbers.

use super::element::Element;
use crate::numbers::{Meter, Q, product_steps};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

/// A square matrix, row by row.
pub type Matrix = Vec<Vec<Element>>;

/// The steps of a row times a matrix of this size where all terms are 0.
pub fn zeros(size: usize) -> u64 {
    (size * size) as u64 / 64
}

/// A row times a matrix.
pub fn times(row: &[Element], matrix: &Matrix, meter: &Meter) -> Result<Vec<Element>, Stop> {
    let mut sum = vec![Element::whole(0); matrix.len()];
    for (x, entries) in row.iter().zip(matrix) {
        for (sum, entry) in sum.iter_mut().zip(entries) {
            sum.add_product(x, entry, meter)?;
        }
    }
    Ok(sum)
}

/// The product of two matrices. Terms that are 0 take time too.
pub fn multiplied(a: &Matrix, b: &Matrix, meter: &Meter) -> Result<Matrix, Stop> {
    meter.spend(zeros(a.len()) * a.len() as u64)?;
    a.iter().map(|row| times(row, b, meter)).collect()
}

/// The sign of the determinant.
pub fn sign_of_determinant(rows: &Matrix, meter: &Meter) -> Result<i8, Stop> {
    let fractions = |row: &Vec<Element>| row.iter().map(Element::as_fraction).collect();
    match rows.iter().map(fractions).collect::<Option<Vec<Vec<Q>>>>() {
        Some(fractions) => sign_of_fractions(&fractions, meter),
        None => sign_by_elimination(rows.clone(), meter),
    }
}

/// The same over a field.
fn sign_by_elimination(mut rows: Matrix, meter: &Meter) -> Result<i8, Stop> {
    let (size, mut sign) = (rows.len(), 1);
    for step in 0..size {
        let Some(pivot) = (step..size).find(|&i| rows[i][step].sign() != 0) else { return Ok(0) };
        if pivot != step {
            rows.swap(step, pivot);
            sign = -sign;
        }
        sign *= rows[step][step].sign();
        let top = rows[step].clone();
        let inverse = top[step].inverse();
        for row in &mut rows[step + 1..] {
            let factor = row[step].metered_times(&inverse, meter)?.negated();
            for (x, t) in row.iter_mut().zip(&top).skip(step) {
                x.add_product(&factor, t, meter)?;
            }
        }
    }
    Ok(sign)
}

/// Fractions as integers over their common denominator.
pub fn cleared(rows: &[Vec<Q>], meter: &Meter) -> Result<(Vec<Vec<BigInt>>, BigInt), Stop> {
    let mut common = BigInt::one();
    for x in rows.iter().flatten() {
        meter.spend(product_steps(common.bits() + x.denom().bits()))?;
        common = common.lcm(x.denom());
    }
    let whole = |x: &Q| x.numer() * (&common / x.denom());
    let integers = rows.iter().map(|row| row.iter().map(whole).collect()).collect();
    Ok((integers, common))
}

/// The same of fractions: the rows become integers, whose minors the steps of Bareiss's elimination are.
fn sign_of_fractions(rows: &[Vec<Q>], meter: &Meter) -> Result<i8, Stop> {
    let mut integers = Vec::with_capacity(rows.len());
    for row in rows {
        integers.extend(cleared(std::slice::from_ref(row), meter)?.0);
    }
    let (size, mut sign, mut before) = (rows.len(), 1, BigInt::one());
    for step in 0..size {
        let Some(pivot) = (step..size).find(|&i| !integers[i][step].is_zero()) else {
            return Ok(0);
        };
        if pivot != step {
            integers.swap(step, pivot);
            sign = -sign;
        }
        let (above, below) = integers.split_at_mut(step + 1);
        let top = &above[step];
        for row in below {
            let factor = row[step].clone();
            for (x, t) in row.iter_mut().zip(top).skip(step) {
                let bits = [&top[step], &factor, &*x, t].map(BigInt::bits).into_iter().max();
                meter.spend(steps_of_minor(bits.unwrap_or(0)))?;
                *x = (&*x * &top[step] - &factor * t) / &before;
            }
        }
        before.clone_from(&integers[step][step]);
    }
    Ok(if before.is_negative() { -sign } else { sign })
}

/// The steps of two products of integers of so many binary digits, and a quotient: there are no common divisors.
pub fn steps_of_minor(bits: u64) -> u64 {
    let blocks = bits / 2_048;
    1 + blocks + blocks * blocks
}
