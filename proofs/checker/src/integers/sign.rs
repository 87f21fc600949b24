//! Signs of polynomials in t and h = cos(π/t) for all integers t from one on (THEOREMS.md, 145).

#![warn(clippy::arithmetic_side_effects)]

use super::polynomial::{COSINE, H, PI, PLACE, Polynomial, T};
use crate::enclosures::{Circle, Interval};
use crate::numbers::{Meter, Q, bits, int, signum};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The first integer is at least this.
pub const LEAST: i64 = 16;

/// The binary digits behind the point with which u is enclosed.
const PLACES: u32 = 20;

/// The binary digits of enclosures at one integer.
const DIGITS: u64 = 512;

/// How often a later integer is tried as the first one, twice as large each time.
const LATER: u32 = 5;

/// The nearest integers at symbolic places: they are from 7 to t − 7.
const FIRST_PLACE: i64 = 7;

const OPEN: Stop = Stop::Integers("the sign of a function is not shown to be the same for all");
const PART: Stop = Stop::Integers("a sign of a cosine, or of a power of a place");

/// The signs for all integers from one on.
pub struct Signs<'m> {
    pub meter: &'m Meter,
    /// The first integer.
    pub from: i64,
    known: RefCell<BTreeMap<Polynomial, i8>>,
}

impl<'m> Signs<'m> {
    /// The integers from this one on.
    pub fn new(meter: &'m Meter, from: i64) -> Result<Signs<'m>, Stop> {
        // The theorem needs 4, and the places between 6 and t − 6 more.
        if from < LEAST {
            return Err(Stop::Integers("the first one is too small"));
        }
        Ok(Signs { meter, from, known: RefCell::default() })
    }

    /// The sign of a polynomial, if it is the same for all t, and for all places.
    pub fn of(&self, p: &Polynomial) -> Result<i8, Stop> {
        if let Some(number) = p.number() {
            return Ok(signum(&number));
        }
        if p.degree(PI) > 0 || p.degree(COSINE) > 0 || p.degree(PLACE) > 1 {
            return Err(PART);
        }
        if p.degree(PLACE) == 1 {
            // It has the degree 1 in the place, and lies between its values at both ends.
            let last =
                Polynomial::variable(T).plus(self.meter, -FIRST_PLACE, &Polynomial::int(1))?;
            let ends = [Polynomial::int(FIRST_PLACE), last];
            let [one, other] = ends.map(|end| self.of(&p.with(self.meter, PLACE, &end)?));
            let sign = one?;
            return if sign != 0 && sign == other? { Ok(sign) } else { Err(OPEN) };
        }
        // t and h are positive.
        let p = p.without(T).1.without(H).1.primitive(self.meter)?.1;
        if let Some(number) = p.number() {
            return Ok(signum(&number));
        }
        if let Some(known) = self.known.borrow().get(&p) {
            return Ok(*known);
        }
        let sign = self.of_both(&p)?;
        self.known.borrow_mut().insert(p, sign);
        Ok(sign)
    }

    /// The sign of a polynomial in t and h with integer coefficients: from a later integer on, and at those before it.
    fn of_both(&self, p: &Polynomial) -> Result<i8, Stop> {
        let mut from = self.from;
        for _ in 0..=LATER {
            if let Some(sign) = self.later(p, from)? {
                let before = (self.from..from).map(|t| self.at(p, t));
                for value in before {
                    if value?.sign() != Some(sign) {
                        return Err(OPEN);
                    }
                }
                return Ok(sign);
            }
            from = from.checked_mul(2).ok_or(OPEN)?;
        }
        Err(OPEN)
    }

    /// The value for one t.
    pub fn at(&self, p: &Polynomial, t: i64) -> Result<Interval, Stop> {
        let circle = Circle::new(DIGITS);
        self.meter.spend(circle.cost().saturating_mul(3))?;
        let h = circle.cosine(&Q::new(BigInt::one(), BigInt::from(t) * 2))?;
        let mut sum = Interval::from(0);
        for part in p.coefficients(H).into_iter().rev() {
            let mut c = Q::zero();
            for (monomial, term) in part.terms() {
                let power = monomial.get(T).copied().unwrap_or(0);
                self.meter.spend(u64::from(power) / 16)?;
                self.meter.spend(8)?;
                c += term * Q::from_integer(BigInt::from(t).pow(power.into()));
            }
            sum = sum.times(&h, DIGITS)?.plus(&Interval::point(c)?, DIGITS)?;
        }
        Ok(sum)
    }

    /// The sign for all t ≥ B, if all r_k(u) have it or are 0, and r_0(u) has it: t^{2J}p(t, 1 − u/t²) = Σ_k r_k(u)(t − B)^k.
    fn later(&self, p: &Polynomial, from: i64) -> Result<Option<i8>, Stop> {
        let rows = self.shifted(p, from)?;
        let (middle, radius) = range(from);
        let powers = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut sign = None;
        for k in 0..powers {
            let row: Vec<BigInt> =
                rows.iter().map(|row| row.get(k).cloned().unwrap_or_default()).collect();
            let [low, high] = self.bounds(row, &middle, &radius)?;
            let found = if low.is_positive() {
                1
            } else if high.is_negative() {
                -1
            } else if low.is_zero() && high.is_zero() {
                0
            } else {
                return Ok(None);
            };
            match sign {
                None if found == 0 => return Ok(None),
                None => sign = Some(found),
                Some(known) if found == 0 || found == known => {}
                Some(_) => return Ok(None),
            }
        }
        Ok(sign)
    }

    /// For each power u^i the polynomial in t − B that stands with it in t^{2J}p(t, 1 − u/t²).
    fn shifted(&self, p: &Polynomial, from: i64) -> Result<Vec<Vec<BigInt>>, Stop> {
        let degree = usize::from(p.degree(H));
        let longest = p.terms().map(|(_, c)| bits(c)).max().unwrap_or(0);
        let mut rows = Vec::new();
        for i in 0..=degree {
            let mut row: Vec<BigInt> = Vec::new();
            for (monomial, c) in p.terms() {
                let [t, h] = [T, H].map(|place| monomial.get(place).copied().unwrap_or(0).into());
                if h < i {
                    continue;
                }
                // c·t^a·h^b has the term c·(b over i)·(−u)^i·t^{a + 2(J − i)}.
                let at = degree.saturating_sub(i).saturating_mul(2).saturating_add(t);
                row.resize(row.len().max(at.saturating_add(1)), BigInt::zero());
                let binomial = num_integer::binomial(BigInt::from(h), BigInt::from(i));
                self.meter.spend((i as u64).saturating_add(1))?;
                if let Some(sum) = row.get_mut(at) {
                    let term = c.to_integer() * binomial;
                    *sum += if i % 2 == 0 { term } else { -term };
                }
            }
            let count = row.len() as u64;
            let limbs = longest.saturating_add(count.saturating_mul(8)) / 64;
            let steps = (limbs / 16).saturating_add(1);
            self.meter.spend(count.saturating_mul(count).saturating_mul(steps) / 2)?;
            turn(&mut row, &BigInt::from(from));
            rows.push(row);
        }
        Ok(rows)
    }

    /// Bounds of a positive multiple of Σ c_i u^i.
    fn bounds(
        &self,
        mut row: Vec<BigInt>,
        middle: &BigInt,
        radius: &BigInt,
    ) -> Result<[BigInt; 2], Stop> {
        while row.last().is_some_and(Zero::is_zero) {
            row.pop();
        }
        let count = row.len() as u64;
        let longest = row.iter().map(BigInt::bits).max().unwrap_or(0);
        let limbs = longest.saturating_add(count.saturating_mul(u64::from(PLACES))) / 64;
        let steps = (limbs / 8).saturating_add(1);
        self.meter.spend(count.saturating_mul(count).saturating_mul(steps))?;
        for (c, behind) in row.iter_mut().rev().zip(0_u32..) {
            *c <<= u64::from(PLACES).saturating_mul(behind.into());
        }
        turn(&mut row, middle);
        let mut row = row.into_iter();
        let value = row.next().unwrap_or_default();
        let (mut off, mut power) = (BigInt::zero(), BigInt::one());
        for c in row {
            power *= radius;
            off += c.abs() * &power;
        }
        Ok([&value - &off, value + off])
    }
}

/// Changes the coefficients of p(x) to those of p(x + by).
fn turn(p: &mut [BigInt], by: &BigInt) {
    let mut rest = p;
    while let [_, ..] = rest {
        let mut above = BigInt::zero();
        for c in rest.iter_mut().rev() {
            *c += &above * by;
            above.clone_from(c);
        }
        rest = rest.split_first_mut().map_or(&mut [], |(_, rest)| rest);
    }
}

/// An interval around u = t²(1 − cos(π/t)) for all t ≥ B: its middle and its radius, times 2^20.
fn range(from: i64) -> (BigInt, BigInt) {
    let hundred_million = BigInt::from(100_000_000);
    let pi = [314_159_265_i64, 314_159_266].map(|n| Q::new(n.into(), hundred_million.clone()));
    let [low, high] = pi.map(|pi| &pi * &pi);
    let off = &high * &high / (int(from) * int(from) * int(24));
    let unit = Q::from_integer(BigInt::one() << PLACES);
    let ends = [(low / int(2) - off) * &unit, high / int(2) * unit];
    let [low, high] = [ends[0].floor().to_integer(), ends[1].ceil().to_integer()];
    let middle: BigInt = (&low + &high) / 2;
    let radius = (&middle - low).max(high - &middle);
    (middle, radius)
}

/// The integer that a number is, if it fits.
pub fn machine(x: &Q) -> Option<i64> {
    if x.is_integer() { x.numer().to_i64() } else { None }
}
