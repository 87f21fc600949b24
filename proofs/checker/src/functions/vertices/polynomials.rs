//! Polynomials with coefficients in fields of cosines, and their factors without multiple roots. The constant
//! coefficient comes first.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::number;
use crate::functions::steps::{Values, add, over, plus, times};
use crate::numbers::{Meter, Ring, Value, characteristic};
use crate::text::Stop;

/// A polynomial whose leading coefficient is not 0.
pub type Polynomial = Vec<Value>;

/// An element c_0 + c_1 x + … of the numbers with an x of x^n = 1.
pub type Cyclic = Vec<Value>;

/// For each entry of a matrix, by columns and rows, the coefficients of its polynomial.
pub type Entries = Vec<Vec<Vec<Cyclic>>>;

/// Such elements for this n.
struct Cycles<'m>(&'m Meter, usize);

impl Ring<Cyclic> for Cycles<'_> {
    fn integer(&self, value: i64) -> Cyclic {
        let mut element = vec![Value::int(0); self.1];
        if let Some(first) = element.first_mut() {
            *first = Value::int(value);
        }
        element
    }

    fn add(&self, sum: &mut Cyclic, other: &Cyclic) -> Result<(), Stop> {
        sum.iter_mut().zip(other).try_for_each(|(sum, term)| plus(self.0, sum, term))
    }

    fn add_product(&self, sum: &mut Cyclic, left: &Cyclic, right: &Cyclic) -> Result<(), Stop> {
        let not_zero = |x: &Cyclic| -> Vec<(usize, Value)> {
            x.iter().cloned().enumerate().filter(|(_, c)| !c.is_zero()).collect()
        };
        let right = not_zero(right);
        self.0.spend(1)?;
        for (i, a) in not_zero(left) {
            for (j, b) in &right {
                let place = i.saturating_add(*j).checked_rem(sum.len());
                if let Some(sum) = place.and_then(|place| sum.get_mut(place)) {
                    add(self.0, sum, &a, b)?;
                }
            }
        }
        Ok(())
    }

    fn share(&self, x: &Cyclic, k: usize) -> Result<Cyclic, Stop> {
        x.iter().map(|c| Values(self.0).share(c, k)).collect()
    }
}

/// The coefficients of det(t − M). A multiple dM has integers as coordinates, whose sums need no common divisors; those of M are its
/// coefficients over powers of d.
pub fn characteristic_of_cycles(
    meter: &Meter,
    n: usize,
    matrix: &[Vec<Cyclic>],
) -> Result<Vec<Cyclic>, Stop> {
    let denominator = Value::denominator(matrix.iter().flatten().flatten())?;
    let scaled = |entry: &Cyclic| multiple(meter, entry, &denominator);
    let rows = matrix.iter().map(|row| row.iter().map(scaled).collect());
    let rows = rows.collect::<Result<Vec<Vec<Cyclic>>, Stop>>()?;
    let mut coefficients = characteristic(&Cycles(meter, n), &rows)?;
    let (inverse, mut share) = (over(meter, &Value::int(1), &denominator)?, Value::int(1));
    for c in coefficients.iter_mut().rev() {
        *c = multiple(meter, c, &share)?;
        share = times(meter, &share, &inverse)?;
    }
    Ok(coefficients)
}

/// The entries of adj(t/d − M), each as a polynomial in t with such coefficients and up to one positive factor, and d: B_0 = 1,
/// B_k = dM·B_{k−1} + c_{m−k} are those on t^{m−1−k}, the c_i those of det(t − dM).
pub fn adjugate_of_cycles(
    meter: &Meter,
    n: usize,
    matrix: &[Vec<Cyclic>],
) -> Result<(Entries, Value), Stop> {
    let denominator: Value = Value::denominator(matrix.iter().flatten().flatten())?;
    let scaled = |entry: &Cyclic| multiple(meter, entry, &denominator);
    let rows = matrix.iter().map(|row| row.iter().map(scaled).collect());
    let rows = rows.collect::<Result<Vec<Vec<Cyclic>>, Stop>>()?;
    let (ring, size) = (Cycles(meter, n), rows.len());
    let coefficients = characteristic(&ring, &rows)?;
    let zero = || vec![vec![ring.integer(0); size]; size];
    let (mut power, mut entries) = (zero(), vec![vec![Vec::new(); size]; size]);
    // From B_0 on: the coefficient c_m = 1, and then the others downwards.
    for c in coefficients.iter().skip(1).rev() {
        let mut next = zero();
        for (i, (row, sums)) in rows.iter().zip(&mut next).enumerate() {
            for (entry, other) in row.iter().zip(&power) {
                for (sum, x) in sums.iter_mut().zip(other) {
                    ring.add_product(sum, entry, x)?;
                }
            }
            if let Some(sum) = sums.get_mut(i) {
                ring.add(sum, c)?;
            }
        }
        for (entries, row) in entries.iter_mut().zip(&next) {
            for (entry, x) in entries.iter_mut().zip(row) {
                entry.push(x.clone());
            }
        }
        power = next;
    }
    entries.iter_mut().flatten().for_each(|entry| entry.reverse());
    Ok((entries, denominator))
}

/// A multiple of an element.
fn multiple(meter: &Meter, element: &Cyclic, factor: &Value) -> Result<Cyclic, Stop> {
    element.iter().map(|c| times(meter, c, factor)).collect()
}

/// Removes leading coefficients that are 0.
pub fn trimmed(mut p: Polynomial) -> Polynomial {
    while p.last().is_some_and(Value::is_zero) {
        p.pop();
    }
    p
}

/// p with the leading coefficient 1.
pub fn monic(meter: &Meter, p: &[Value]) -> Result<Polynomial, Stop> {
    let Some(leading) = p.last() else { return Ok(Vec::new()) };
    if *leading == Value::int(1) {
        return Ok(p.to_vec());
    }
    let inverse = over(meter, &Value::int(1), leading)?;
    p.iter().map(|c| times(meter, c, &inverse)).collect()
}

/// The quotient and the remainder of a division by a polynomial with the leading coefficient 1.
pub fn divided(
    meter: &Meter,
    p: &[Value],
    divisor: &[Value],
) -> Result<(Polynomial, Polynomial), Stop> {
    let (mut rest, mut quotient) = (p.to_vec(), Vec::new());
    let degree = divisor.len().saturating_sub(1);
    while rest.len() > degree {
        let Some(leading) = rest.pop() else { break };
        let factor = leading.negated()?;
        let shift = rest.len().saturating_sub(degree);
        for (sum, c) in rest.iter_mut().skip(shift).zip(divisor) {
            add(meter, sum, &factor, c)?;
        }
        quotient.push(leading);
    }
    quotient.reverse();
    Ok((quotient, trimmed(rest)))
}

/// p′.
fn slope(meter: &Meter, p: &[Value]) -> Result<Polynomial, Stop> {
    (1..).zip(p.iter().skip(1)).map(|(k, c)| times(meter, c, &number(k))).collect()
}

/// The greatest common divisor with the leading coefficient 1.
pub fn common(meter: &Meter, p: &[Value], q: &[Value]) -> Result<Polynomial, Stop> {
    let (mut p, mut q) = (monic(meter, p)?, monic(meter, q)?);
    while !q.is_empty() {
        let rest = divided(meter, &p, &q)?.1;
        (p, q) = (q, monic(meter, &rest)?);
    }
    Ok(p)
}

/// p(x).
pub fn at(meter: &Meter, p: &[Value], x: &Value) -> Result<Value, Stop> {
    let mut sum = Value::int(0);
    for c in p.iter().rev() {
        sum = times(meter, &sum, x)?;
        plus(meter, &mut sum, c)?;
    }
    Ok(sum)
}

/// How often a number is a root of p ≠ 0, and the quotient without it.
pub fn without(meter: &Meter, p: &[Value], x: &Value) -> Result<(usize, Polynomial), Stop> {
    let (mut rest, mut count) = (p.to_vec(), 0_usize);
    while rest.len() > 1 && at(meter, &rest, x)?.is_zero() {
        rest = divided(meter, &rest, &[x.negated()?, Value::int(1)])?.0;
        count = count.saturating_add(1);
    }
    Ok((count, rest))
}

/// Polynomials f_m without multiple roots and without common ones, of which p is a multiple of the product of the f_m^m (Yun).
pub fn square_free(meter: &Meter, p: &[Value]) -> Result<Vec<(Polynomial, usize)>, Stop> {
    let p = monic(meter, p)?;
    let derivative = slope(meter, &p)?;
    let first = common(meter, &p, &derivative)?;
    let (mut b, mut c) = (divided(meter, &p, &first)?.0, divided(meter, &derivative, &first)?.0);
    let (mut found, mut multiplicity) = (Vec::new(), 1_usize);
    while b.len() > 1 {
        let mut d = c;
        let of_b = slope(meter, &b)?;
        d.resize(d.len().max(of_b.len()), Value::int(0));
        for (d, s) in d.iter_mut().zip(&of_b) {
            plus(meter, d, &s.negated()?)?;
        }
        let d = trimmed(d);
        let factor = common(meter, &b, &d)?;
        (b, c) = (divided(meter, &b, &factor)?.0, divided(meter, &d, &factor)?.0);
        if factor.len() > 1 {
            found.push((factor, multiplicity));
        }
        multiplicity = multiplicity.saturating_add(1);
    }
    Ok(found)
}
