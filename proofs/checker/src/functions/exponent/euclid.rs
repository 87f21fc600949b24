//! Euclid's algorithm on a piece, for polynomials in z whose coefficients are polynomials in its symbol v.
//!
//! Leading coefficients are not 0 on the piece, so that the steps are those for each number of the piece, up to factors that are not
//! 0 there.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{
    Meter, Piece, Q, Value, bits, divide, gcd, int, multiplied, steps_of_gcd, trimmed,
};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Zero as _};

/// A polynomial in v, the constant coefficient first. The last one is not 0.
pub type Coefficient = Vec<Q>;

/// A polynomial in z, the constant coefficient first.
pub type Polynomial = Vec<Coefficient>;

/// Euclid's algorithm on a piece that is more than one number.
pub struct Euclid<'e> {
    pub meter: &'e Meter,
    pub piece: &'e Piece<'e>,
}

impl Euclid<'_> {
    /// Whether no z ≠ 0 is a common zero of the parts of a symbol, and no set of z ≠ 1 is closed under z ↦ z^n, of which A(wω) = 0 for
    /// all w in it and all ω ≠ 1, ω^n = 1. The first and the last coefficient are not 0 on the piece.
    pub fn is_independent(&self, symbol: &Polynomial, n: usize) -> Result<bool, Stop> {
        // The parts have a common zero other than 0, which is none, as the first part begins with a_l.
        let mut common = Vec::new();
        for e in 0..n {
            let part = symbol.iter().skip(e).step_by(n).cloned().collect();
            common = self.gcd(common, part)?;
        }
        if common.len() != 1 {
            return Ok(false);
        }
        // A(wω) = 0 for all ω ≠ 1, ω^n = 1, if and only if all w^eA_e(w^n) agree.
        let mut common = Vec::new();
        for e in 0..n.saturating_sub(1) {
            let term = |(i, a): (usize, &Coefficient)| match i.checked_rem(n) {
                Some(class) if class == e => a.clone(),
                Some(class) if class == e.saturating_add(1) => a.iter().map(|c| -c).collect(),
                _ => Vec::new(),
            };
            common = self.gcd(common, symbol.iter().enumerate().map(term).collect())?;
        }
        let mut closed = self.without_one(common)?;
        // What is left are the z for which z^n is among them, up to multiplicities.
        while closed.len() > 1 {
            let mut stretched = Vec::new();
            for c in &closed {
                stretched.resize(stretched.len().next_multiple_of(n), Vec::new());
                stretched.push(c.clone());
            }
            let next = self.gcd(closed.clone(), stretched)?;
            if next.len() == closed.len() {
                return Ok(false);
            }
            closed = next;
        }
        Ok(closed.len() == 1)
    }

    /// The quotient by the greatest power of z − 1 that divides a polynomial.
    fn without_one(&self, mut p: Polynomial) -> Result<Polynomial, Stop> {
        loop {
            // The sums of the coefficients from above are those of the quotient, and the last sum is p(1).
            let (mut sum, mut sums) = (Vec::new(), Vec::with_capacity(p.len()));
            for c in p.iter().rev() {
                self.meter.spend(cost(&sum, c))?;
                sum = combined(sum, c, false);
                sums.push(sum.clone());
            }
            if p.is_empty() || !self.is_zero(&sum)? {
                return Ok(p);
            }
            sums.pop();
            sums.reverse();
            p = sums;
        }
    }

    /// Whether a coefficient is 0 on the piece. Then it is the polynomial 0.
    fn is_zero(&self, a: &Coefficient) -> Result<bool, Stop> {
        if a.len() < 2 {
            return Ok(a.is_empty());
        }
        Value::polynomial(self.piece.symbol(), a.clone()).is_zero_on(Some(self.piece))
    }

    /// Removes the leading coefficients that are 0, and a common divisor of all of them. It divides the leading one, and so it
    /// is not 0 on the piece.
    fn primitive(&self, mut p: Polynomial) -> Result<Polynomial, Stop> {
        while let Some(leading) = p.last()
            && self.is_zero(leading)?
        {
            p.pop();
        }
        let mut divisor = Vec::new();
        for c in p.iter().filter(|c| !c.is_empty()) {
            divisor = self.divisor(&divisor, c)?;
            if divisor.len() == 1 {
                break;
            }
        }
        if divisor.len() > 1 {
            for c in &mut p {
                *c = self.share(c, &divisor)?;
            }
        }
        let over = p.iter().flatten().fold(BigInt::one(), |over, c| over.lcm(c.denom()));
        let whole = |c: &Q| c.numer() * (&over / c.denom());
        let common = p.iter().flatten().fold(BigInt::zero(), |common, c| common.gcd(&whole(c)));
        if !common.is_zero() {
            let by = Q::new(over, common);
            p.iter_mut().flatten().for_each(|c| *c *= &by);
        }
        Ok(p)
    }

    /// A greatest common divisor in v.
    fn divisor(&self, a: &Coefficient, b: &Coefficient) -> Result<Coefficient, Stop> {
        match (&a[..], &b[..]) {
            ([], _) => return Ok(b.clone()),
            (_, []) => return Ok(a.clone()),
            ([_], _) | (_, [_]) => return Ok(vec![int(1)]),
            _ => {}
        }
        self.meter.spend(steps_of_gcd(a, b))?;
        Ok(gcd(a, b))
    }

    /// a/b.
    fn share(&self, a: &Coefficient, b: &Coefficient) -> Result<Coefficient, Stop> {
        self.meter.spend(cost(a, b))?;
        Ok(if b.len() == 1 { scaled(a, &b[0].recip()) } else { divide(a.clone(), b).0 })
    }

    fn times(&self, a: &Coefficient, b: &Coefficient) -> Result<Coefficient, Stop> {
        self.meter.spend(cost(a, b))?;
        Ok(match (&a[..], &b[..]) {
            ([], _) | (_, []) => Vec::new(),
            ([x], _) => scaled(b, x),
            (_, [x]) => scaled(a, x),
            _ => multiplied(a, b),
        })
    }

    /// A remainder of p by q, times a factor that is not 0 on the piece. The leading coefficient of q is not 0.
    fn rest(&self, mut p: Polynomial, q: &Polynomial) -> Result<Polynomial, Stop> {
        let Some((leading, lower)) = q.split_last() else { return Ok(p) };
        while p.len() >= q.len() {
            let Some(top) = p.pop().filter(|top| !top.is_empty()) else { continue };
            let divisor = self.divisor(leading, &top)?;
            let (factor, top) = (self.share(leading, &divisor)?, self.share(&top, &divisor)?);
            let from = p.len().saturating_sub(lower.len());
            for c in &mut p {
                *c = self.times(c, &factor)?;
            }
            for (c, d) in p.iter_mut().skip(from).zip(lower) {
                let less = self.times(&top, d)?;
                *c = combined(std::mem::take(c), &less, true);
            }
        }
        Ok(p)
    }

    /// A greatest common divisor in z; without coefficients if both are 0.
    fn gcd(&self, p: Polynomial, q: Polynomial) -> Result<Polynomial, Stop> {
        let (mut one, mut other) = (self.primitive(p)?, self.primitive(q)?);
        while !other.is_empty() {
            if other.len() == 1 {
                return Ok(vec![vec![int(1)]]);
            }
            let rest = self.primitive(self.rest(one, &other)?)?;
            (one, other) = (other, rest);
        }
        Ok(one)
    }
}

/// a + b, or a − b.
fn combined(mut a: Coefficient, b: &Coefficient, minus: bool) -> Coefficient {
    a.resize(a.len().max(b.len()), Q::zero());
    for (x, y) in a.iter_mut().zip(b) {
        if minus { *x -= y } else { *x += y }
    }
    trimmed(a)
}

fn scaled(a: &Coefficient, by: &Q) -> Coefficient {
    a.iter().map(|x| x * by).collect()
}

/// The steps of a product: those of the products of all pairs of coefficients.
fn cost(a: &Coefficient, b: &Coefficient) -> u64 {
    let digits = |p: &Coefficient| p.iter().map(bits).max().unwrap_or(0);
    let blocks = (digits(a) / 64).saturating_mul(digits(b) / 64) / 16;
    let pairs = a.len().max(1).saturating_mul(b.len().max(1));
    (pairs as u64).saturating_mul(blocks.saturating_add(1))
}
