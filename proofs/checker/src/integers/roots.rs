//! Square roots of functions of an integer, and estimates of functions.

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions, UNKNOWN};
use super::polynomial::{COSINE, H, PI, PLACE, Polynomial, T};
use super::quotient::Quotient;
use crate::enclosures::Interval;
use crate::numbers::{Q, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, Zero as _};
use std::collections::BTreeMap;

/// The most square roots.
const MAX_ROOTS: usize = 4;

/// The greatest number by whose square radicands are divided.
const MAX_SQUARE: u32 = 100;

/// The digits of an estimate.
const DIGITS: u64 = 128;

impl Functions<'_> {
    /// √x, where x is negative for none of the integers.
    pub fn square_root(&self, x: &Function) -> Result<Function, Stop> {
        match self.sign(x)? {
            0 => return Ok(Function::default()),
            1 => {}
            _ => return Err(Stop::Undefined("the square root of a negative number")),
        }
        let value = x.quotient().ok_or(Stop::Integers("a square root under another"))?;
        if [COSINE, PLACE, PI].iter().any(|place| value.top.degree(*place) > 0) {
            return Err(UNKNOWN);
        }
        let meter = self.meter();
        // √(p/Πf^e) = √(p·Πf^(e mod 2))/Πf^⌈e/2⌉.
        let mut radicand = value.top;
        let mut bottom = BTreeMap::new();
        for (factor, exponent) in value.bottom {
            if exponent % 2 == 1 {
                radicand = radicand.times(meter, &factor)?;
            }
            bottom.insert(factor, exponent.div_ceil(2));
        }
        let (content, rest) = radicand.primitive(meter)?;
        let (t, rest) = rest.without(T);
        let (h, rest) = rest.without(H);
        let mut outside = Polynomial::int(1);
        let mut inside = rest;
        for (place, exponent) in [(T, t), (H, h)] {
            let variable = Polynomial::variable(place);
            for _ in 0..exponent / 2 {
                outside = outside.times(meter, &variable)?;
            }
            if exponent % 2 == 1 {
                inside = inside.times(meter, &variable)?;
            }
        }
        let (factor, under) = squares(&content);
        outside = outside.scaled(&factor);
        if under.is_one()
            && let Some(root) = inside.square_root(meter)?
        {
            let sign = int(i64::from(self.signs.of(&root)?));
            let top = outside.times(meter, &root.scaled(&sign))?;
            return Ok(Quotient { top, bottom }.reduced(meter)?.into());
        }
        let bit = self.root(inside.scaled(&under))?;
        let value = Quotient { top: outside, bottom }.reduced(meter)?;
        Ok(Function(BTreeMap::from([(bit, value)])))
    }

    /// The bit of the square root of a positive polynomial.
    fn root(&self, radicand: Polynomial) -> Result<u8, Stop> {
        let mut roots = self.roots.borrow_mut();
        let known = roots.iter().position(|known| *known == radicand);
        let place = known.unwrap_or(roots.len());
        if known.is_none() {
            if roots.len() == MAX_ROOTS {
                return Err(Stop::Integers("more than four different square roots"));
            }
            roots.push(radicand);
        }
        Ok(1 << place)
    }

    /// The value for the first integer, and for the place 7.
    pub fn first(&self, x: &Function) -> Result<Interval, Stop> {
        let at = |p: &Polynomial| {
            let p = p.with(self.meter(), PLACE, &Polynomial::int(7))?;
            self.signs.at(&p, self.signs.from)
        };
        let mut sum = Interval::from(0);
        for (key, value) in &x.0 {
            let mut term = at(&value.top)?;
            term = term.times(&at(&value.divisor(self.meter())?)?.inverse(DIGITS)?, DIGITS)?;
            for (place, root) in self.roots.borrow().iter().enumerate() {
                if key & (1 << place) != 0 {
                    term = term.times(&at(root)?.root(DIGITS)?, DIGITS)?;
                }
            }
            sum = sum.plus(&term, DIGITS)?;
        }
        Ok(sum)
    }
}

/// f and r with f²r = x > 0, where r is an integer without small square factors.
fn squares(x: &Q) -> (Q, Q) {
    let mut rest: BigInt = x.numer() * x.denom();
    let mut factor = Q::new(BigInt::one(), x.denom().clone());
    let whole = rest.sqrt();
    if &whole * &whole == rest {
        return (factor * Q::from_integer(whole), Q::one());
    }
    for number in 2..=MAX_SQUARE {
        let square = BigInt::from(number) * number;
        while (&rest % &square).is_zero() && rest.is_positive() {
            rest /= &square;
            factor *= Q::from_integer(number.into());
        }
    }
    (factor, Q::from_integer(rest))
}
