//! A real number at some number of binary digits.

#![warn(clippy::arithmetic_side_effects)]

use super::size::Size;
use crate::enclosures::{Interval, Sturm, enclosed};
use crate::functions::Real;
use crate::numbers::{Meter, Number, Q, common_multiple, roots_between};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;

/// The most binary digits.
pub const MOST: u64 = 16_384;

/// The longest name of a number.
const MAX_KEY: usize = 4_096;

/// What is known of a real number.
#[derive(Clone, Debug)]
pub struct Known {
    /// An interval that contains it.
    pub near: Interval,
    /// The number, if it is known to be one of a field Q(2cos(2π/n)).
    pub number: Option<Number>,
    /// Its size, if it is an algebraic number, which is known with any number of digits.
    pub size: Option<Size>,
    /// How it is made. Numbers that are made alike are equal.
    key: String,
}

/// The digits with which numbers are enclosed, and the meter of the claim.
#[derive(Clone, Copy)]
pub struct Digits<'m> {
    pub bits: u64,
    pub meter: &'m Meter,
}

impl Digits<'_> {
    /// A number of a field Q(2cos(2π/n)).
    pub fn exact(self, number: &Number) -> Result<Known, Stop> {
        let near = enclosed(self.meter, number, self.bits)?;
        let (size, key) = Size::of(self.meter, number)?;
        Ok(Known { near, number: Some(number.clone()), size: Some(size), key })
    }

    /// A value of a function.
    pub fn found(self, found: &Real) -> Result<Known, Stop> {
        match found {
            Real::Exact(value) => self.exact(value.number()?),
            Real::Between(ends) => {
                let [low, high] = &**ends;
                let near = self.between(low, high)?;
                Ok(Known { near, number: None, size: None, key: format!("{low}..{high}") })
            }
            Real::Root(polynomial, ends) => {
                let [low, high] = &**ends;
                let bound = crate::numbers::beyond_roots(polynomial);
                self.meter.spend(crate::numbers::steps_between(polynomial, low, high))?;
                let before = roots_between(polynomial, &-bound, low);
                let coefficients: Vec<Number> =
                    polynomial.iter().cloned().map(Number::from).collect();
                let number = i64::try_from(before).unwrap_or(i64::MAX).saturating_add(1);
                self.root(&coefficients, number)
            }
            Real::RootOf(coefficients, number) => self.root(coefficients, *number),
            Real::At(polynomial, of) => {
                let (x, mut sum) = (self.found(of)?, self.integer(0)?);
                for c in polynomial.iter().rev() {
                    sum = self.sum(&self.product(&sum, &x)?, 1, &self.exact(c)?)?;
                }
                Ok(sum)
            }
            Real::SquareRoot(of) => self.square_root(&self.found(of)?),
            Real::Ratio(top, bottom) => self.quotient(&self.found(top)?, &self.found(bottom)?),
        }
    }

    /// The real root of a polynomial, counted from 1.
    pub fn root(self, coefficients: &[Number], number: i64) -> Result<Known, Stop> {
        // Without denominators, which would count several times.
        let bottoms: Vec<BigInt> = coefficients.iter().map(Number::bottom).collect();
        let common = Number::from(Q::from_integer(common_multiple(&bottoms)?));
        let known = coefficients.iter().map(|c| self.exact(&c.times(&common)?));
        let known = known.collect::<Result<Vec<Known>, Stop>>()?;
        self.root_of(&known, number)
    }

    /// The same with coefficients that are numbers of any kind.
    pub fn root_of(self, coefficients: &[Known], number: i64) -> Result<Known, Stop> {
        let near: Vec<Interval> = coefficients.iter().map(|c| c.near.clone()).collect();
        let near = Sturm::new(&near, self.bits, self.meter)?.root(number)?;
        if let Some(value) = near.exact() {
            return self.exact(&value.clone().into());
        }
        let names: Vec<&str> = coefficients.iter().map(|c| c.key.as_str()).collect();
        let key = key(format!("root({};{number})", names.join(",")))?;
        let sizes: Option<Vec<Size>> = coefficients.iter().map(|c| c.size.clone()).collect();
        let size = sizes.and_then(|sizes| Size::root(&sizes, &key));
        Ok(Known { near, number: None, size, key })
    }

    fn between(self, low: &Q, high: &Q) -> Result<Interval, Stop> {
        let [low, high] = [low, high].map(|end| Interval::Point(end.clone()));
        let ([low, _], [_, high], exponent) = low.aligned(&high, self.bits.saturating_add(8));
        Interval::new(low, high, exponent, self.bits)
    }

    fn made(
        self,
        near: Interval,
        (one, sign, other): (&Known, char, &Known),
        size: fn(&Size, &Size) -> Size,
    ) -> Result<Known, Stop> {
        let size = one.size.as_ref().zip(other.size.as_ref()).map(|(one, other)| size(one, other));
        let key = key(format!("({}{sign}{})", one.key, other.key))?;
        self.meter.spend(1_u64.saturating_add(self.bits / 64))?;
        Ok(Known { near, number: None, size, key })
    }

    /// one + factor·other, the factor 1 or −1.
    pub fn sum(self, one: &Known, factor: i64, other: &Known) -> Result<Known, Stop> {
        if let (Some(a), Some(b)) = (&one.number, &other.number)
            && let Ok(sum) = a.plus(factor, b)
        {
            return self.exact(&sum);
        }
        let near = if factor < 0 {
            one.near.minus(&other.near, self.bits)?
        } else {
            one.near.plus(&other.near, self.bits)?
        };
        self.made(near, (one, if factor < 0 { '-' } else { '+' }, other), Size::sum)
    }

    pub fn product(self, one: &Known, other: &Known) -> Result<Known, Stop> {
        if let (Some(a), Some(b)) = (&one.number, &other.number)
            && let Ok(product) = a.times(b)
        {
            return self.exact(&product);
        }
        let near = one.near.times(&other.near, self.bits)?;
        self.made(near, (one, '*', other), Size::product)
    }

    pub fn quotient(self, one: &Known, other: &Known) -> Result<Known, Stop> {
        if let (Some(a), Some(b)) = (&one.number, &other.number) {
            let inverse = b.inverse().ok_or(Stop::Undefined("it divides by 0"))?;
            if let Ok(quotient) = a.times(&inverse) {
                return self.exact(&quotient);
            }
        }
        let near = one.near.times(&other.near.inverse(self.bits)?, self.bits)?;
        self.made(near, (one, '/', other), |one, other| one.product(&other.inverse()))
    }

    /// √x.
    pub fn square_root(self, of: &Known) -> Result<Known, Stop> {
        let near = of.near.root(self.bits)?;
        if let Some(value) = near.exact() {
            return self.exact(&value.clone().into());
        }
        let key = key(format!("√{}", of.key))?;
        let size = of.size.as_ref().map(|size| size.square_root(&key));
        Ok(Known { near, number: None, size, key })
    }

    /// An integer.
    pub fn integer(self, value: i64) -> Result<Known, Stop> {
        self.exact(&Number::Small(value, 1))
    }
}

/// A key that is not too long.
fn key(key: String) -> Result<String, Stop> {
    if key.len() > MAX_KEY { Err(Stop::Capped("the size of a formula of roots")) } else { Ok(key) }
}

impl Known {
    /// The same number under a name that no other number has.
    pub fn named(self, name: String) -> Known {
        Known { key: name, ..self }
    }

    /// Whether both are made alike.
    pub fn is_made_as(&self, other: &Known) -> bool {
        self.key == other.key
    }

    /// −x, or x, so that it is not negative; the sign has to be known.
    pub fn negated(&self, digits: Digits<'_>) -> Result<Known, Stop> {
        digits.sum(&digits.integer(0)?, -1, self)
    }
}

/// Whether a number is 0, if so many digits tell.
pub fn is_zero(of: &Known) -> Result<bool, Stop> {
    if let Some(number) = &of.number {
        return Ok(number.is_zero());
    }
    if let Some(sign) = of.near.sign() {
        return Ok(sign == 0);
    }
    let undecided = Stop::Undecided("whether a number is 0");
    let separation = of.size.as_ref().ok_or(undecided.clone())?.separation();
    if separation > MOST {
        return Err(Stop::Capped("the digits that separate a number from 0"));
    }
    if of.most() * Q::from_integer(BigInt::one() << separation) < Q::one() {
        return Ok(true);
    }
    Err(undecided)
}
