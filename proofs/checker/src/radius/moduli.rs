//! The moduli of eigenvalues.

use super::element::Element;
use super::matrices::{Matrix, cleared, multiplied, steps_of_minor};
use crate::numbers::{Meter, Q};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

/// Whether an eigenvalue of a matrix has a modulus of at least q > 0.
///
/// f is the characteristic polynomial, with its zeros divided by q, and monic. All its zeros are inside the unit circle if its constant term a is, and all
/// zeros of (f − a·f*)/((1 − a²)x) are, f* with the coefficients of f in the opposite order.
pub fn has_modulus(matrix: &Matrix, bound: &Q, meter: &Meter) -> Result<bool, Stop> {
    let one = Element::whole(1);
    let fractions = |row: &Vec<Element>| row.iter().map(Element::as_fraction).collect();
    let fractions: Option<Vec<Vec<Q>>> = matrix.iter().map(fractions).collect();
    // The eigenvalues of an integer multiple are multiples.
    let (mut f, bound): (Vec<Element>, Q) = match fractions {
        Some(fractions) => {
            let (integers, common) = cleared(&fractions, meter)?;
            let whole = |c: BigInt| Element::fraction(&Q::from_integer(c));
            let f = of_integers(&integers, meter)?.into_iter().map(whole).collect();
            (f, bound * Q::from_integer(common))
        }
        None => (characteristic(matrix, meter)?, bound.clone()),
    };
    let (inverse, mut power) = (Element::fraction(&bound.recip()), one.clone());
    for c in f.iter_mut().rev() {
        *c = c.metered_times(&power, meter)?;
        power = power.metered_times(&inverse, meter)?;
    }
    while f.len() > 1 {
        let less = f[0].negated();
        let mut rest = one.clone();
        rest.add_product(&f[0], &less, meter)?;
        if rest.sign() <= 0 {
            return Ok(true);
        }
        let scale = rest.inverse();
        let mut next = Vec::with_capacity(f.len() - 1);
        for (i, c) in f.iter().enumerate().skip(1) {
            let mut sum = c.clone();
            sum.add_product(&less, &f[f.len() - 1 - i], meter)?;
            next.push(sum.metered_times(&scale, meter)?);
        }
        f = next;
    }
    Ok(false)
}

/// det(xI − A), from the constant term upwards, by Faddeev and LeVerrier: B_1 = A, c_k = −tr(B_k)/k, B_{k+1} = A(B_k + c_kI).
fn characteristic(matrix: &Matrix, meter: &Meter) -> Result<Vec<Element>, Stop> {
    let mut coefficients = vec![Element::whole(1)];
    let mut power = matrix.clone();
    for k in 1..=matrix.len() {
        let trace = (0..matrix.len()).fold(Element::whole(0), |sum, i| sum.plus(&power[i][i]));
        let c = trace.scaled(&Q::new((-1).into(), k.into()));
        if k < matrix.len() {
            for (i, row) in power.iter_mut().enumerate() {
                row[i] = row[i].plus(&c);
            }
            power = multiplied(matrix, &power, meter)?;
        }
        coefficients.push(c);
    }
    coefficients.reverse();
    Ok(coefficients)
}

/// The same of integers, which the coefficients then are too.
fn of_integers(matrix: &[Vec<BigInt>], meter: &Meter) -> Result<Vec<BigInt>, Stop> {
    let size = matrix.len();
    let mut coefficients = vec![BigInt::one()];
    let mut power = matrix.to_vec();
    for k in 1..=size {
        let trace: BigInt = (0..size).map(|i| &power[i][i]).sum();
        let c = -trace / BigInt::from(k);
        if k < size {
            for (i, row) in power.iter_mut().enumerate() {
                row[i] += &c;
            }
            let bits = matrix.iter().chain(&power).flatten().map(BigInt::bits).max().unwrap_or(0);
            meter.spend((size * size * size) as u64 * steps_of_minor(bits))?;
            let entry = |row: &Vec<BigInt>, j: usize| {
                let terms = row.iter().zip(&power).filter(|(x, _)| !x.is_zero());
                terms.map(|(x, other)| x * &other[j]).sum()
            };
            power = matrix.iter().map(|row| (0..size).map(|j| entry(row, j)).collect()).collect();
        }
        coefficients.push(c);
    }
    coefficients.reverse();
    Ok(coefficients)
}
