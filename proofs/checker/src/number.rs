//! Real numbers of the fields Q(2cos(2π/n)).

use crate::decimal::{Q, int};
use crate::linear::solve;
use crate::polynomial::{divide, signum};
use crate::reject::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The greatest n of a field Q(2cos(2π/n)).
const MAX_FIELD: u32 = 1_000;

/// The most binary digits of an enclosure of 2cos(2π/n).
const MAX_PRECISION: u64 = 1 << 14;

/// A number of Q(x), x = 2cos(2π/n): integers on 1, x, x², …, over one denominator.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// n; 1 if it is rational.
    n: u32,
    /// As many as the degree of the field; in lowest terms with the denominator.
    top: Vec<BigInt>,
    /// Positive.
    bottom: BigInt,
}

/// The field Q(x), x = 2cos(2π/n), n ≥ 3.
struct Field {
    n: u32,
    /// The minimal polynomial ψ of x, from the constant to the leading coefficient 1.
    minimal: Vec<BigInt>,
    /// M and p with M/2^p ≤ x ≤ (M + 1)/2^p.
    enclosure: RefCell<(BigInt, u64)>,
}

thread_local! {
    static FIELDS: RefCell<BTreeMap<u32, Rc<Field>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The n-th cyclotomic polynomial: z^n − 1 divided by those of the proper divisors of n.
fn cyclotomic(n: u32) -> Vec<BigInt> {
    let mut known: Vec<(u32, Vec<BigInt>)> = Vec::new();
    for m in (1..=n).filter(|m| n.is_multiple_of(*m)) {
        let mut rest = vec![BigInt::zero(); m as usize + 1];
        (rest[0], rest[m as usize]) = (-BigInt::one(), BigInt::one());
        for (_, divisor) in known.iter().filter(|(d, _)| m.is_multiple_of(*d)) {
            rest = divide(rest, divisor).0;
        }
        known.push((m, rest));
    }
    known.pop().map_or(Vec::new(), |(_, last)| last)
}

/// C_k, with 2cos(kt) = C_k(2cos t): C_0 = 2, C_1 = x, C_{k+1} = x·C_k − C_{k−1}.
fn chebyshev(k: usize) -> Vec<BigInt> {
    let (mut last, mut this) = (vec![BigInt::from(2)], vec![BigInt::zero(), BigInt::one()]);
    for _ in 0..k {
        let mut next = [&[BigInt::zero()], &this[..]].concat();
        next.iter_mut().zip(&last).for_each(|(sum, coefficient)| *sum -= coefficient);
        (last, this) = (this, next);
    }
    last
}

fn field(n: u32) -> Rc<Field> {
    if let Some(known) = FIELDS.with_borrow(|known| known.get(&n).cloned()) {
        return known;
    }
    // The cyclotomic polynomial Φ of n ≥ 3 is a palindrome of even degree 2d, so z^−d·Φ
    // is a sum of z^k + z^−k = C_k(x) with x = z + 1/z, and x is 2cos(2π/n) for z = e^(2πi/n).
    // Of degree d it is the minimal polynomial, since Φ is irreducible.
    let phi = cyclotomic(n);
    let d = (phi.len() - 1) / 2;
    let mut minimal = vec![BigInt::zero(); d + 1];
    minimal[0].clone_from(&phi[d]);
    for k in 1..=d {
        for (sum, coefficient) in minimal.iter_mut().zip(chebyshev(k)) {
            *sum += coefficient * &phi[d + k];
        }
    }
    let field = Rc::new(Field { n, minimal, enclosure: RefCell::default() });
    // Between 0 and 1, or 1 and 2; that of n = 3 is −1, and of n = 4 it is 0.
    let first = BigInt::from(i8::from(!field.is_below(&BigInt::one(), 0)));
    field.enclosure.replace((first, 0));
    FIELDS.with_borrow_mut(|known| known.insert(n, Rc::clone(&field)));
    field
}

/// The value of a polynomial at top/2^p, times 2^(p·degree).
fn scaled(polynomial: &[BigInt], top: &BigInt, p: u64) -> BigInt {
    let mut place = 0;
    polynomial.iter().rev().fold(BigInt::zero(), |sum, coefficient| {
        let next = sum * top + (coefficient << place);
        place += p;
        next
    })
}

impl Field {
    /// Whether x < t = top/2^p, for t < 2.
    fn is_below(&self, top: &BigInt, p: u64) -> bool {
        // x is the largest root of ψ, and x ≥ 2 − (2π/n)² > 2 − 40/n². The next root is at
        // most 2cos(4π/n) ≤ 2 − y² + y⁴/12 < 2 − 74/n², y = 4π/n, for n ≥ 5. So between
        // 2 − 40/n² and 2, ψ is negative up to x and positive beyond. What has a smaller n is
        // rational, and is not asked for.
        let unit = BigInt::one() << p;
        let near = (&unit * 2 - top) * self.n * self.n < unit * 40;
        near && scaled(&self.minimal, top, p).is_positive()
    }

    /// M with M/2^p ≤ x ≤ (M + 1)/2^p.
    fn enclose(&self, p: u64) -> BigInt {
        let mut enclosure = self.enclosure.borrow_mut();
        while enclosure.1 < p {
            let middle: BigInt = &enclosure.0 * 2 + 1;
            let finer = enclosure.1 + 1;
            let lower = self.is_below(&middle, finer);
            *enclosure = (if lower { middle - 1 } else { middle }, finer);
        }
        &enclosure.0 >> (enclosure.1 - p)
    }
}

/// The remainder of a polynomial in x, for n = 1 of an integer.
fn reduce(n: u32, polynomial: Vec<BigInt>) -> Vec<BigInt> {
    if n == 1 {
        return polynomial;
    }
    let minimal = &field(n).minimal;
    let mut rest = divide(polynomial, minimal).1;
    rest.resize(minimal.len() - 1, BigInt::zero());
    rest
}

/// The product of two polynomials in x.
fn multiply(n: u32, left: &[BigInt], right: &[BigInt]) -> Vec<BigInt> {
    let mut product = vec![BigInt::zero(); left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    reduce(n, product)
}

impl From<Q> for Number {
    fn from(value: Q) -> Number {
        let (top, bottom) = value.into();
        Number { n: 1, top: vec![top], bottom }
    }
}

impl Number {
    /// A number of the field of n, from integers over a positive denominator.
    fn new(mut n: u32, mut top: Vec<BigInt>, mut bottom: BigInt) -> Number {
        if top[1..].iter().all(Zero::is_zero) {
            top.truncate(1);
            n = 1;
        }
        if !bottom.is_one() {
            let gcd = |a: BigInt, b: &BigInt| match (a.to_u64(), b.abs().to_u64()) {
                // Most numbers are small, and for these machine integers are quicker.
                (Some(a), Some(b)) => a.gcd(&b).into(),
                _ => a.gcd(b),
            };
            let common = top.iter().fold(bottom.clone(), gcd);
            for coefficient in &mut top {
                *coefficient /= &common;
            }
            bottom /= common;
        }
        Number { n, top, bottom }
    }

    /// cos(2π·turn).
    pub fn cosine(turn: &Q) -> Result<Number, Stop> {
        let n = turn.denom().to_u32().filter(|n| *n <= MAX_FIELD);
        let n = n.ok_or(Stop::Capped("the field of the cosines"))?;
        let p = (turn - turn.floor()).numer().to_u32().unwrap_or(0);
        if n < 3 {
            return Ok(Number::from(int(if p == 0 { 1 } else { -1 })));
        }
        let double = reduce(n, chebyshev(p.min(n - p) as usize));
        Ok(Number::new(n, double, BigInt::from(2)))
    }

    /// The coefficients of both in one field, and its n.
    fn lifted(&self, other: &Number) -> Result<(u32, Vec<BigInt>, Vec<BigInt>), Stop> {
        let n = self.n.lcm(&other.n);
        if n > MAX_FIELD {
            return Err(Stop::Capped("the field of the cosines"));
        }
        Ok((n, self.lift(n), other.lift(n)))
    }

    /// Its coefficients in the field of a multiple of its n.
    fn lift(&self, n: u32) -> Vec<BigInt> {
        if self.n == n || self.n == 1 {
            return reduce(n, self.top.clone());
        }
        let x = reduce(n, chebyshev((n / self.n) as usize));
        self.top.iter().rev().fold(vec![BigInt::zero()], |sum, coefficient| {
            let mut next = multiply(n, &sum, &x);
            next[0] += coefficient;
            next
        })
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Number) -> Result<Number, Stop> {
        let (n, mut top, more) = self.lifted(other)?;
        let (p, q) = (&self.bottom, &other.bottom);
        for (a, b) in top.iter_mut().zip(more) {
            *a = if p == q { &*a + b * factor } else { &*a * q + b * p * factor };
        }
        Ok(Number::new(n, top, if p == q { p.clone() } else { p * q }))
    }

    /// self · factor.
    pub fn times_integer(&self, factor: i64) -> Number {
        let top = self.top.iter().map(|coefficient| coefficient * factor).collect();
        Number::new(self.n, top, self.bottom.clone())
    }

    /// self · other.
    pub fn times(&self, other: &Number) -> Result<Number, Stop> {
        let (n, left, right) = self.lifted(other)?;
        Ok(Number::new(n, multiply(n, &left, &right), &self.bottom * &other.bottom))
    }

    /// 1/self, for self ≠ 0.
    pub fn inverse(&self) -> Option<Number> {
        if let Some(value) = self.rational() {
            return (!value.is_zero()).then(|| Number::from(value.recip()));
        }
        // The y with top·y = 1: linear equations, one column top·x^j for each unknown.
        let d = self.top.len();
        let mut rows = vec![vec![Q::zero(); d + 1]; d];
        let mut column = self.top.clone();
        for j in 0..d {
            for (row, value) in rows.iter_mut().zip(&column) {
                row[j] = value.clone().into();
            }
            column = multiply(self.n, &column, &[BigInt::zero(), BigInt::one()]);
        }
        rows[0][d] = int(1);
        let solution = solve(rows)?;
        let common = solution.iter().fold(BigInt::one(), |common, y| common.lcm(y.denom()));
        let scale = Q::from_integer(&common * &self.bottom);
        let top = solution.into_iter().map(|y| (y * &scale).to_integer()).collect();
        Some(Number::new(self.n, top, common))
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> Result<i8, Stop> {
        if self.n == 1 {
            return Ok(signum(&self.top[0]));
        }
        // It is not 0, so that some enclosure of x shows its sign. As |x| ≤ 2, x^i changes by
        // at most i·2^i/2^p when x does by 1/2^p.
        let degree = self.top.len() as u64 - 1;
        let steps = self.top.iter().enumerate();
        let slope: BigInt = steps.map(|(i, coefficient)| (coefficient.abs() * i) << i).sum();
        let mut p = 64;
        while p <= MAX_PRECISION {
            let value = scaled(&self.top, &field(self.n).enclose(p), p);
            if value.abs() > (&slope << (p * (degree - 1))) {
                return Ok(signum(&value));
            }
            p *= 2;
        }
        Err(Stop::Capped("the precision of a sign"))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.n == 1 && self.top[0].is_zero()
    }

    /// This as a rational number, if it is one.
    pub fn rational(&self) -> Option<Q> {
        (self.n == 1).then(|| Q::new_raw(self.top[0].clone(), self.bottom.clone()))
    }

    /// The denominator.
    pub fn bottom(&self) -> &BigInt {
        &self.bottom
    }

    /// The greatest integer that is not above it.
    pub fn floor(&self) -> Result<BigInt, Stop> {
        // By halving between −bound and bound.
        let bound: BigInt = self.top.iter().enumerate().map(|(i, c)| c.abs() << i).sum();
        let bound = bound / &self.bottom + 1;
        let (mut low, mut high) = (-&bound, bound + 1);
        while &high - &low > BigInt::one() {
            let middle: BigInt = (&low + &high) >> 1;
            let above = self.plus(-1, &Number::from(Q::from_integer(middle.clone())))?.sign()?;
            if above < 0 { high = middle } else { low = middle }
        }
        Ok(low)
    }

    /// Its size in binary digits.
    pub fn bits(&self) -> u64 {
        self.top.iter().map(BigInt::bits).sum::<u64>() + self.bottom.bits()
    }
}
