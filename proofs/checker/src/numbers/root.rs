//! Real numbers as roots of polynomials, and the signs of polynomials at and between them.

use super::decimal::{Q, bits, int, read_rational};
use super::meter::Meter;
use super::polynomial::{
    at, beyond_roots, divide, gcd, roots_between, signum, steps_between, steps_of_gcd, trimmed,
};
use crate::text::Stop;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;
use std::fmt;

/// The most coefficients of a polynomial.
const MAX_LENGTH: usize = 65;

/// The most binary digits of a coefficient, times the number of coefficients.
const MAX_BITS: u64 = 1 << 16;

/// The most halvings of an interval.
const MAX_HALVINGS: usize = 1_000;

/// The only root of a polynomial between two rational numbers that are no roots. If the two are
/// the same, it is that rational number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    polynomial: Vec<Q>,
    low: Q,
    high: Q,
}

impl From<Q> for Root {
    fn from(value: Q) -> Root {
        Root { polynomial: vec![-&value, int(1)], low: value.clone(), high: value }
    }
}

impl fmt::Display for Root {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.rational() {
            Some(value) => write!(f, "{value}"),
            None => write!(f, "a number from {} to {}", self.low, self.high),
        }
    }
}

impl Root {
    /// Reads a number, or `root:COEFFICIENT,…:LOW:HIGH`.
    pub fn read(text: &str, meter: &Meter) -> Result<Option<Root>, Stop> {
        let Some(said) = text.strip_prefix("root:") else {
            return Ok(read_rational(text).map(Root::from));
        };
        let [polynomial, low, high] = said.split(':').collect::<Vec<&str>>()[..] else {
            return Ok(None);
        };
        let polynomial: Option<Vec<Q>> = polynomial.split(',').map(read_rational).collect();
        let ends = read_rational(low).zip(read_rational(high));
        let Some((polynomial, ends)) = polynomial.zip(ends) else { return Ok(None) };
        Root::between(polynomial, ends.into(), meter)
    }

    /// The only root of a polynomial between two numbers; `None` if it is not the only one, or too long.
    pub fn between(
        polynomial: Vec<Q>,
        [low, high]: [Q; 2],
        meter: &Meter,
    ) -> Result<Option<Root>, Stop> {
        let ends = || [&low, &high].iter().all(|end| !at(&polynomial, end).is_zero());
        let long = polynomial.iter().chain([&low, &high]).map(bits).max().unwrap_or(0);
        let proper = low < high
            && (2..=MAX_LENGTH).contains(&polynomial.len())
            && long * polynomial.len() as u64 <= MAX_BITS
            && ends();
        let one = proper && count(&polynomial, [&low, &high], meter)? == 1;
        Ok(one.then_some(Root { polynomial, low, high }))
    }

    /// The rational number that this is, if that is known.
    pub fn rational(&self) -> Option<&Q> {
        (self.low == self.high).then_some(&self.low)
    }

    /// The ends of the interval.
    pub fn ends(&self) -> [&Q; 2] {
        [&self.low, &self.high]
    }

    /// The coefficients of the polynomial.
    pub fn polynomial(&self) -> &[Q] {
        &self.polynomial
    }

    /// The number of roots of a polynomial in the interval. It is not 0 at the ends.
    fn count(&self, p: &[Q], meter: &Meter) -> Result<usize, Stop> {
        count(p, [&self.low, &self.high], meter)
    }

    /// The number in half of the interval.
    pub fn halved(&self, meter: &Meter) -> Result<Root, Stop> {
        let (polynomial, middle) = (self.polynomial.clone(), (&self.low + &self.high) / int(2));
        if at(&polynomial, &middle).is_zero() {
            return Ok(middle.into());
        }
        let lower = Root { polynomial, low: self.low.clone(), high: middle.clone() };
        if lower.count(&self.polynomial, meter)? == 1 {
            return Ok(lower);
        }
        Ok(Root { low: middle, high: self.high.clone(), ..lower })
    }

    /// The number in an interval with so many roots of a polynomial, none of them at its ends.
    fn narrowed(&self, p: &[Q], roots: usize, meter: &Meter) -> Result<Root, Stop> {
        let mut root = self.clone();
        for _ in 0..MAX_HALVINGS {
            let ends = || [&root.low, &root.high].iter().all(|end| !at(p, end).is_zero());
            if root.rational().is_some() || ends() && root.count(p, meter)? == roots {
                return Ok(root);
            }
            root = root.halved(meter)?;
        }
        Err(Stop::Capped("the halvings of an interval"))
    }

    /// The number in an interval without other roots of a polynomial.
    fn apart_from(&self, p: &[Q], meter: &Meter) -> Result<Root, Stop> {
        self.narrowed(p, usize::from(self.sign_of(p, meter)? == 0), meter)
    }

    /// The sign of a polynomial at this number.
    pub fn sign_of(&self, p: &[Q], meter: &Meter) -> Result<i8, Stop> {
        if self.rational().is_none() {
            // A common divisor is not 0 at the ends.
            meter.spend(steps_of_gcd(p, &self.polynomial))?;
            if self.count(&gcd(p, &self.polynomial), meter)? > 0 {
                return Ok(0);
            }
        }
        Ok(signum(&at(p, &self.narrowed(p, 0, meter)?.low)))
    }

    /// How two numbers compare.
    pub fn compare(&self, other: &Root, meter: &Meter) -> Result<Ordering, Stop> {
        match (self.rational(), other.rational()) {
            (_, Some(value)) => return Ok(self.sign_of(&[-value, int(1)], meter)?.cmp(&0)),
            (Some(_), None) => return Ok(other.compare(self, meter)?.reverse()),
            (None, None) => {}
        }
        let against = |end: &Q| self.compare(&end.clone().into(), meter);
        let [low, high] = [&other.low, &other.high].map(against);
        if self.sign_of(&other.polynomial, meter)? == 0 && low?.is_gt() && high?.is_lt() {
            return Ok(Ordering::Equal);
        }
        let (mut one, mut other) = (self.clone(), other.clone());
        for _ in 0..MAX_HALVINGS {
            if one.high <= other.low {
                return Ok(Ordering::Less);
            }
            if other.high <= one.low {
                return Ok(Ordering::Greater);
            }
            (one, other) = (one.halved(meter)?, other.halved(meter)?);
        }
        Err(Stop::Capped("the halvings of an interval"))
    }

    /// Compares the distances of two numbers from a rational number.
    pub fn nearer(&self, other: &Root, to: &Q, meter: &Meter) -> Result<Ordering, Stop> {
        let (mut one, mut other) = (self.clone(), other.clone());
        let off = |root: &Root| {
            let off = [&root.low, &root.high].map(|end| (end - to).abs());
            let inside = root.low < *to && *to < root.high;
            let [a, b] = off;
            let (least, most) = if a < b { (a, b) } else { (b, a) };
            (if inside { Q::zero() } else { least }, most)
        };
        for _ in 0..MAX_HALVINGS {
            let ((least, most), (other_least, other_most)) = (off(&one), off(&other));
            if most < other_least {
                return Ok(Ordering::Less);
            }
            if other_most < least {
                return Ok(Ordering::Greater);
            }
            if one.rational().is_some() && other.rational().is_some() {
                return Ok(Ordering::Equal);
            }
            (one, other) = (one.halved(meter)?, other.halved(meter)?);
        }
        Err(Stop::Capped("the halvings of an interval"))
    }
}

/// The number of roots of a polynomial between two numbers that are no roots.
fn count(p: &[Q], [low, high]: [&Q; 2], meter: &Meter) -> Result<usize, Stop> {
    meter.spend(steps_between(p, low, high))?;
    Ok(roots_between(p, low, high))
}

/// The sign of p between two numbers, or a root of p there. The lower number comes first.
pub fn sign_between(
    p: &[Q],
    low: Option<&Root>,
    high: Option<&Root>,
    meter: &Meter,
) -> Result<Result<i8, Box<Root>>, Stop> {
    if p.iter().all(Zero::is_zero) {
        return Ok(Ok(0));
    }
    // Each end is replaced by a rational number, with no root of p between the two. An infinite
    // end is replaced by a number beyond all roots of p and the other end.
    let ends = [low, high].into_iter().flatten();
    let bound = beyond_roots(p) + ends.map(|end| end.low.abs() + end.high.abs()).sum::<Q>();
    let mut low = low.map_or(Ok((-&bound).into()), |low| low.apart_from(p, meter))?;
    let mut high = high.map_or(Ok(bound.into()), |high| high.apart_from(p, meter))?;
    for _ in 0..MAX_HALVINGS {
        if low.high < high.low {
            return sign_or_root(p, low.high, high.low, meter);
        }
        (low, high) = (low.halved(meter)?, high.halved(meter)?);
    }
    Err(Stop::Capped("the halvings of an interval"))
}

/// The sign of p between two rational numbers, or a root of p there.
fn sign_or_root(
    p: &[Q],
    mut low: Q,
    mut high: Q,
    meter: &Meter,
) -> Result<Result<i8, Box<Root>>, Stop> {
    // Roots at the ends are divided out. In between, x − low is positive and x − high is negative.
    let (mut p, mut turned) = (trimmed(p.to_vec()), 1);
    for (end, factor) in [(&low, 1), (&high, -1)] {
        while at(&p, end).is_zero() {
            (p, _) = divide(p, &[-end, int(1)]);
            turned *= factor;
        }
    }
    for _ in 0..MAX_HALVINGS {
        match count(&p, [&low, &high], meter)? {
            0 => return Ok(Ok(turned * signum(&at(&p, &low)))),
            1 if p.len() == 2 => return Ok(Err(Box::new((-&p[0] / &p[1]).into()))),
            1 => return Ok(Err(Box::new(Root { polynomial: p, low, high }))),
            _ => {}
        }
        let middle = (&low + &high) / int(2);
        if at(&p, &middle).is_zero() {
            return Ok(Err(Box::new(middle.into())));
        }
        let below = count(&p, [&low, &middle], meter)? > 0;
        (low, high) = if below { (low, middle) } else { (middle, high) };
    }
    Err(Stop::Capped("the halvings of an interval"))
}
