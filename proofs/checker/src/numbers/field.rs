//! The fields Q(x), x = 2cos(2π/n).

use super::polynomial::{divide, multiplied};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The binary digits of an enclosure that are found one by one.
const FIRST: u64 = 96;

/// The field Q(x), x = 2cos(2π/n), n ≥ 3.
pub struct Field {
    n: u32,
    /// The minimal polynomial ψ of x, from the constant to the leading coefficient 1.
    minimal: Vec<BigInt>,
    /// An enclosure M/2^p ≤ x ≤ (M + 1)/2^p.
    enclosure: RefCell<(BigInt, u64)>,
    /// The C_k(x) that have been computed.
    chebyshev: RefCell<BTreeMap<u32, Vec<BigInt>>>,
}

thread_local! {
    static FIELDS: RefCell<BTreeMap<u32, Rc<Field>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The n-th cyclotomic polynomial: z^n − 1 divided by those of the proper divisors of n.
pub fn cyclotomic(n: u32) -> Vec<BigInt> {
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
fn all_chebyshev() -> impl Iterator<Item = Vec<BigInt>> {
    let first = [vec![BigInt::from(2)], vec![BigInt::zero(), BigInt::one()]];
    let next = |[last, this]: &[Vec<BigInt>; 2]| {
        let mut next = [&[BigInt::zero()], &this[..]].concat();
        next.iter_mut().zip(last).for_each(|(sum, coefficient)| *sum -= coefficient);
        Some([this.clone(), next])
    };
    std::iter::successors(Some(first), next).map(|[this, _]| this)
}

/// C_k(x) in the field of n.
pub fn chebyshev(n: u32, k: u32) -> Vec<BigInt> {
    let field = field(n);
    let mut known = field.chebyshev.borrow_mut();
    let missing = || reduce(n, all_chebyshev().nth(k as usize).unwrap_or_default());
    known.entry(k).or_insert_with(missing).clone()
}

/// The field of n ≥ 3.
pub fn field(n: u32) -> Rc<Field> {
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
    for (k, chebyshev) in all_chebyshev().enumerate().take(d + 1).skip(1) {
        for (sum, coefficient) in minimal.iter_mut().zip(chebyshev) {
            *sum += coefficient * &phi[d + k];
        }
    }
    let (enclosure, chebyshev) = Default::default();
    let field = Rc::new(Field { n, minimal, enclosure, chebyshev });
    // x lies between 0 and 1 or between 1 and 2. It is −1 for n = 3, and 0 for n = 4.
    let first = BigInt::from(i8::from(!field.is_below(&BigInt::one(), 0)));
    field.enclosure.replace((first, 0));
    FIELDS.with_borrow_mut(|known| known.insert(n, Rc::clone(&field)));
    field
}

/// The value of a polynomial at top/2^p, times 2^(p·degree).
pub fn scaled(polynomial: &[BigInt], top: &BigInt, p: u64) -> BigInt {
    let mut place = 0;
    polynomial.iter().rev().fold(BigInt::zero(), |sum, coefficient| {
        let next = sum * top + (coefficient << place);
        place += p;
        next
    })
}

impl Field {
    /// The minimal polynomial of x.
    pub fn minimal(&self) -> &[BigInt] {
        &self.minimal
    }

    /// Whether x < t = top/2^p, for t < 2.
    fn is_below(&self, top: &BigInt, p: u64) -> bool {
        // x is the largest root of ψ, and x ≥ 2 − (2π/n)² > 2 − 40/n². The next root is at
        // most 2cos(4π/n) ≤ 2 − y² + y⁴/12 < 2 − 74/n², y = 4π/n, for n ≥ 5. So between
        // 2 − 40/n² and 2, ψ is negative up to x and positive beyond. For smaller n, x is rational
        // and needs no enclosure.
        let unit = BigInt::one() << p;
        let near = (&unit * 2 - top) * self.n * self.n < unit * 40;
        near && scaled(&self.minimal, top, p).is_positive()
    }

    /// The M with M/2^p ≤ x ≤ (M + 1)/2^p.
    pub fn enclose(&self, p: u64) -> BigInt {
        let mut enclosure = self.enclosure.borrow_mut();
        while enclosure.1 < p {
            *enclosure = self.newton(&enclosure, p).unwrap_or_else(|| {
                let middle: BigInt = &enclosure.0 * 2 + 1;
                let finer = enclosure.1 + 1;
                let lower = self.is_below(&middle, finer);
                (if lower { middle - 1 } else { middle }, finer)
            });
        }
        &enclosure.0 >> (enclosure.1 - p)
    }

    /// A finer enclosure, of p binary digits at most, near to where Newton's step leads, if x is there.
    fn newton(&self, (low, digits): &(BigInt, u64), p: u64) -> Option<(BigInt, u64)> {
        // The digits double but for those that ψ″/ψ′ takes, which is at most a power of n.
        let finer = p.min(2 * digits.checked_sub(FIRST / 2)?);
        let more = finer.checked_sub(*digits).filter(|more| *digits >= FIRST && *more > 1)?;
        let slope: Vec<BigInt> =
            self.minimal.iter().zip(0_u32..).skip(1).map(|(c, k)| c * k).collect();
        let slope = scaled(&slope, low, *digits);
        if slope.is_zero() {
            return None;
        }
        let step = (scaled(&self.minimal, low, *digits) << more).div_floor(&slope);
        let near: BigInt = (low << more) - step;
        let lowest = [&near - 1, near.clone(), near + 1];
        let lowest = lowest.into_iter().find(|low| {
            let above: BigInt = low + 1;
            !self.is_below(low, finer) && self.is_below(&above, finer)
        });
        Some((lowest?, finer))
    }
}

/// Reduces a polynomial in x by the minimal polynomial of x. For n = 1 it is an integer.
pub fn reduce(n: u32, polynomial: Vec<BigInt>) -> Vec<BigInt> {
    if n == 1 {
        return polynomial;
    }
    let minimal = &field(n).minimal;
    let mut rest = divide(polynomial, minimal).1;
    rest.resize(minimal.len() - 1, BigInt::zero());
    rest
}

/// The product of two polynomials in x.
pub fn multiply(n: u32, left: &[BigInt], right: &[BigInt]) -> Vec<BigInt> {
    reduce(n, multiplied(left, right))
}
