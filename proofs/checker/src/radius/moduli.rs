//! The moduli of eigenvalues.

use super::element::Element;
use super::matrices::{Matrix, multiplied};
use crate::numbers::{Meter, Q};
use crate::text::Stop;

/// Whether an eigenvalue of a matrix has a modulus of at least q > 0.
///
/// f is the characteristic polynomial, with its zeros divided by q, and monic. All its zeros are inside the unit circle if its constant term a is, and all
/// zeros of (f − a·f*)/((1 − a²)x) are, f* with the coefficients of f in the opposite order.
pub fn has_modulus(matrix: &Matrix, bound: &Q, meter: &Meter) -> Result<bool, Stop> {
    let one = Element::whole(1);
    let mut f = characteristic(matrix, meter)?;
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
