//! The coordinates of a number of the field Q(x), x = 2cos(2π/n).

use super::decimal::{Q, int};
use super::field::{chebyshev, field, multiply, reduce, scaled};
use super::linear::solve;
use super::polynomial::signum;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// The most binary digits of an enclosure of 2cos(2π/n).
const MAX_PRECISION: u64 = 1 << 14;

/// A number of the field: integers on 1, x, x², …, over one denominator.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Element {
    /// The n of the field. It is 1 if the number is rational.
    pub n: u32,
    /// The integers. There are as many as the degree of the field.
    pub top: Vec<BigInt>,
    /// The positive denominator, in lowest terms with the integers.
    pub bottom: BigInt,
}

impl Element {
    /// The same number in the field of a multiple of its n.
    pub fn lifted(self, n: u32) -> Element {
        if self.n == n {
            return self;
        }
        let mut top = reduce(n, vec![BigInt::zero()]);
        if self.n == 1 {
            top[0].clone_from(&self.top[0]);
            return Element { n, top, ..self };
        }
        let x = chebyshev(n, n / self.n);
        for coefficient in self.top.iter().rev() {
            top = multiply(n, &top, &x);
            top[0] += coefficient;
        }
        Element { n, top, ..self }
    }

    /// The reciprocal. It need not be in lowest terms.
    pub fn inverse(self) -> Option<Element> {
        // The y with top·y = 1 solves linear equations, one column top·x^j for each unknown.
        let Element { n, top, bottom } = self;
        let d = top.len();
        let mut rows = vec![vec![Q::zero(); d + 1]; d];
        let mut column = top;
        for j in 0..d {
            for (row, value) in rows.iter_mut().zip(&column) {
                row[j] = value.clone().into();
            }
            column = multiply(n, &column, &[BigInt::zero(), BigInt::one()]);
        }
        rows[0][d] = int(1);
        let solution = solve(rows)?;
        let common = solution.iter().fold(BigInt::one(), |common, y| common.lcm(y.denom()));
        let scale = Q::from_integer(&common * bottom);
        let top = solution.into_iter().map(|y| (y * &scale).to_integer()).collect();
        Some(Element { n, top, bottom: common })
    }

    /// The greatest integer that is not above it.
    pub fn floor(self) -> Result<BigInt, Stop> {
        // The floor is found by bisection between −bound and bound.
        let Element { n, mut top, bottom } = self;
        let bound: BigInt =
            top.iter().enumerate().map(|(i, c)| BigInt::from(c.magnitude() << i)).sum();
        let bound = bound / &bottom + 1;
        let (mut low, mut high) = (-&bound, bound + 1);
        let constant = top[0].clone();
        while &high - &low > BigInt::one() {
            let middle: BigInt = (&low + &high) >> 1;
            top[0] = &constant - &middle * &bottom;
            if sign(n, &top)? < 0 { high = middle } else { low = middle }
        }
        Ok(low)
    }
}

/// The sign of Σ top_i·x^i, x = 2cos(2π/n).
pub fn sign(n: u32, top: &[BigInt]) -> Result<i8, Stop> {
    if top[1..].iter().all(Zero::is_zero) {
        return Ok(signum(&top[0]));
    }
    // It is not 0, so that some enclosure of x shows its sign. As |x| ≤ 2, x^i changes by
    // at most i·2^i/2^p when x does by 1/2^p.
    let degree = top.len() as u64 - 1;
    let steps = top.iter().enumerate();
    let slope: BigInt = steps.map(|(i, coefficient)| (coefficient.abs() * i) << i).sum();
    let mut p = 64;
    while p <= MAX_PRECISION {
        let value = scaled(top, &field(n).enclose(p), p);
        if (&slope << (p * (degree - 1))) < value.abs() {
            return Ok(signum(&value));
        }
        p *= 2;
    }
    Err(Stop::Capped("the precision of a sign"))
}
