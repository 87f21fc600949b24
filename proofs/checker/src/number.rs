//! Real numbers of the fields Q(2cos(2π/n)).

use crate::decimal::{Q, int};
use crate::linear::solve;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The greatest n of a field Q(2cos(2π/n)).
pub const MAX_FIELD: u32 = 1_000;

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
    static CYCLOTOMIC: RefCell<BTreeMap<u32, Rc<Vec<BigInt>>>> =
        const { RefCell::new(BTreeMap::new()) };
}

/// The n-th cyclotomic polynomial: z^n − 1 divided by those of the proper divisors of n.
fn cyclotomic(n: u32) -> Rc<Vec<BigInt>> {
    if let Some(known) = CYCLOTOMIC.with_borrow(|known| known.get(&n).cloned()) {
        return known;
    }
    let mut rest = vec![BigInt::zero(); n as usize + 1];
    rest[0] = -BigInt::one();
    rest[n as usize] = BigInt::one();
    for d in (1..n).filter(|d| n.is_multiple_of(*d)) {
        let divisor = cyclotomic(d);
        let mut quotient = vec![BigInt::zero(); rest.len() - divisor.len() + 1];
        for i in (0..quotient.len()).rev() {
            // The divisor is monic.
            quotient[i].clone_from(&rest[i + divisor.len() - 1]);
            for (j, coefficient) in divisor.iter().enumerate() {
                rest[i + j] -= &quotient[i] * coefficient;
            }
        }
        rest = quotient;
    }
    let rest = Rc::new(rest);
    CYCLOTOMIC.with_borrow_mut(|known| known.insert(n, Rc::clone(&rest)));
    rest
}

/// C_k, with 2cos(kt) = C_k(2cos t): C_0 = 2, C_1 = x, C_{k+1} = x·C_k − C_{k−1}.
fn chebyshev(k: usize) -> Vec<BigInt> {
    let (mut last, mut this) = (vec![BigInt::from(2)], vec![BigInt::zero(), BigInt::one()]);
    for _ in 0..k {
        let mut next = vec![BigInt::zero()];
        next.extend(this.iter().cloned());
        for (sum, coefficient) in next.iter_mut().zip(&last) {
            *sum -= coefficient;
        }
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
    let enclosure = RefCell::new((BigInt::zero(), 0));
    let field = Rc::new(Field { n, minimal, enclosure });
    if !field.is_below(&BigInt::one(), 0) {
        field.enclosure.replace((BigInt::one(), 0));
    }
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

    /// The remainder of a polynomial in x.
    fn reduce(&self, mut polynomial: Vec<BigInt>) -> Vec<BigInt> {
        let degree = self.minimal.len() - 1;
        while polynomial.len() > degree {
            let leading = polynomial.pop().unwrap_or_default();
            let from = polynomial.len() - degree;
            for (sum, coefficient) in polynomial[from..].iter_mut().zip(&self.minimal) {
                *sum -= coefficient * &leading;
            }
        }
        polynomial.resize(degree, BigInt::zero());
        polynomial
    }
}

/// The product of two polynomials in x of the field of n, or of two integers for n = 1.
pub fn multiply(n: u32, left: &[BigInt], right: &[BigInt]) -> Vec<BigInt> {
    let mut product = vec![BigInt::zero(); left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    if n == 1 { product } else { field(n).reduce(product) }
}

impl From<Q> for Number {
    fn from(value: Q) -> Number {
        let (top, bottom) = value.into();
        Number { n: 1, top: vec![top], bottom }
    }
}

impl Number {
    /// A number of the field of n, from integers over a positive denominator.
    pub fn new(mut n: u32, mut top: Vec<BigInt>, mut bottom: BigInt) -> Number {
        if top[1..].iter().all(Zero::is_zero) {
            top.truncate(1);
            n = 1;
        }
        let common = top.iter().fold(bottom.clone(), |common, coefficient| {
            // Most numbers are small, and for these machine integers are quicker.
            match (common.to_u64(), coefficient.abs().to_u64()) {
                (Some(1), _) => common,
                (Some(a), Some(b)) => a.gcd(&b).into(),
                _ => common.gcd(coefficient),
            }
        });
        if !common.is_one() {
            for coefficient in &mut top {
                *coefficient /= &common;
            }
            bottom /= common;
        }
        Number { n, top, bottom }
    }

    /// cos(2π·turn); `None` beyond [`MAX_FIELD`].
    pub fn cosine(turn: &Q) -> Option<Number> {
        let n = turn.denom().to_u32().filter(|n| *n <= MAX_FIELD)?;
        let p = (turn - turn.floor()).numer().to_u32()?;
        if n < 3 {
            return Some(Number::from(int(if p == 0 { 1 } else { -1 })));
        }
        let double = field(n).reduce(chebyshev(p.min(n - p) as usize));
        Some(Number::new(n, double, BigInt::from(2)))
    }

    /// A field that holds these numbers too; `None` beyond [`MAX_FIELD`].
    pub fn common_field(&self, n: u32) -> Option<u32> {
        let factor = self.n / self.n.gcd(&n);
        factor.checked_mul(n).filter(|n| *n <= MAX_FIELD)
    }

    /// Its coefficients in the field of a multiple of its n, and their denominator.
    pub fn lift(&self, n: u32) -> (Vec<BigInt>, &BigInt) {
        if self.n == n {
            return (self.top.clone(), &self.bottom);
        }
        let field = field(n);
        if self.n == 1 {
            return (field.reduce(self.top.clone()), &self.bottom);
        }
        let x = field.reduce(chebyshev((n / self.n) as usize));
        let top = self.top.iter().rev().fold(vec![BigInt::zero()], |sum, coefficient| {
            let mut next = multiply(n, &sum, &x);
            next[0] += coefficient;
            next
        });
        (field.reduce(top), &self.bottom)
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Number) -> Option<Number> {
        let n = self.common_field(other.n)?;
        let ((mut top, p), (other, q)) = (self.lift(n), other.lift(n));
        if p == q {
            for (a, b) in top.iter_mut().zip(other) {
                *a += b * factor;
            }
            return Some(Number::new(n, top, p.clone()));
        }
        for (a, b) in top.iter_mut().zip(other) {
            *a = &*a * q + b * p * factor;
        }
        Some(Number::new(n, top, p * q))
    }

    /// self · other.
    pub fn times(&self, other: &Number) -> Option<Number> {
        let n = self.common_field(other.n)?;
        let bottom = &self.bottom * &other.bottom;
        if self.n == 1 || other.n == 1 {
            let (scalar, other) = if self.n == 1 { (self, other) } else { (other, self) };
            let top = other.top.iter().map(|coefficient| coefficient * &scalar.top[0]).collect();
            return Some(Number::new(n, top, bottom));
        }
        Some(Number::new(n, multiply(n, &self.lift(n).0, &other.lift(n).0), bottom))
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

    /// −1, 0 or 1; `None` if [`MAX_PRECISION`] does not tell.
    pub fn sign(&self) -> Option<i8> {
        let sign = |value: &BigInt| i8::from(value.is_positive()) - i8::from(value.is_negative());
        if self.n == 1 {
            return Some(sign(&self.top[0]));
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
                return Some(sign(&value));
            }
            p *= 2;
        }
        None
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.n == 1 && self.top[0].is_zero()
    }

    /// This as a rational number, if it is one.
    pub fn rational(&self) -> Option<Q> {
        (self.n == 1).then(|| Q::new_raw(self.top[0].clone(), self.bottom.clone()))
    }

    /// The greatest integer that is not above it.
    pub fn floor(&self) -> Option<BigInt> {
        // By halving between −bound and bound.
        let bound: BigInt = self.top.iter().enumerate().map(|(i, c)| c.abs() << i).sum();
        let bound = bound / &self.bottom + 1;
        let (mut low, mut high) = (-&bound, bound + 1);
        while &high - &low > BigInt::one() {
            let middle: BigInt = (&low + &high) >> 1;
            let above = self.plus(-1, &Number::from(Q::from_integer(middle.clone())))?.sign()?;
            if above < 0 { high = middle } else { low = middle }
        }
        Some(low)
    }

    /// Its size in binary digits.
    pub fn bits(&self) -> u64 {
        self.top.iter().map(BigInt::bits).sum::<u64>() + self.bottom.bits()
    }
}
