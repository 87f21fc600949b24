//! Roots of polynomials without multiple ones, their enclosures and their absolute values.

#![warn(clippy::arithmetic_side_effects)]

use super::polynomials::Polynomial;
use crate::enclosures::{Interval, Sturm, enclosed, is_within, without};
use crate::functions::real::Real;
use crate::numbers::{Meter, Number, Q, Value};
use crate::text::Stop;
use std::cmp::Ordering;
use std::rc::Rc;

/// The binary digits of enclosures. The next ones are tried if some do not decide.
pub const DIGITS: [u64; 3] = [128, 512, 2_048];

/// What some precision decides.
pub fn decide<T>(decision: impl Fn(u64) -> Result<Option<T>, Stop>) -> Result<T, Stop> {
    for bits in DIGITS {
        match decision(bits) {
            Ok(None) | Err(Stop::Undecided(_)) => {}
            Ok(Some(found)) => return Ok(found),
            Err(stop) => return Err(stop),
        }
    }
    Err(Stop::Capped("the precision to which roots are compared"))
}

/// A polynomial without multiple roots.
#[derive(PartialEq)]
pub struct Factor {
    /// The polynomial.
    pub p: Polynomial,
    /// The number of its real roots.
    pub real: i64,
}

impl Factor {
    /// Counts the real roots.
    pub fn new(meter: &Meter, p: Polynomial) -> Result<Factor, Stop> {
        let real = decide(|bits| Factor::sturm(meter, &p, bits)?.count().map(Some))?;
        Ok(Factor { p, real })
    }

    /// The Sturm chain of enclosures.
    pub fn sturm<'m>(meter: &'m Meter, p: &[Value], bits: u64) -> Result<Sturm<'m>, Stop> {
        Sturm::new(&Factor::enclosure(meter, p, bits)?, bits, meter)
    }

    /// Enclosures of the coefficients.
    pub fn enclosure(meter: &Meter, p: &[Value], bits: u64) -> Result<Vec<Interval>, Stop> {
        p.iter().map(|c| enclosed(meter, c.number()?, bits)).collect()
    }

    /// An enclosure of a root.
    fn root(&self, meter: &Meter, index: i64, bits: u64) -> Result<Interval, Stop> {
        Factor::sturm(meter, &self.p, bits)?.root(index)
    }

    /// Whether all roots that are not real are below r in absolute value.
    pub fn is_within(&self, meter: &Meter, r: &Q, bits: u64) -> Result<bool, Stop> {
        let mut p = Factor::enclosure(meter, &self.p, bits)?;
        for index in 1..=self.real {
            let root = self.root(meter, index, bits)?;
            p = without(&p, &root, bits)?;
        }
        meter.spend((p.len() as u64).saturating_pow(2))?;
        is_within(p, r, bits)
    }
}

/// Where a root is.
#[derive(Clone)]
pub enum Place {
    /// This number.
    Exact(Value),
    /// The real root of a factor with this number, from 1 on, ascending.
    Of(Rc<Factor>, i64),
}

impl Place {
    /// As a real number.
    pub fn real(&self) -> Result<Real, Stop> {
        Ok(match self {
            Place::Exact(value) => Real::Exact(value.clone()),
            Place::Of(factor, index) => {
                let p = factor.p.iter().map(|c| c.number().cloned());
                Real::RootOf(p.collect::<Result<Vec<Number>, Stop>>()?, *index)
            }
        })
    }

    /// An enclosure.
    pub fn enclosed(&self, meter: &Meter, bits: u64) -> Result<Interval, Stop> {
        match self {
            Place::Exact(value) => enclosed(meter, value.number()?, bits),
            Place::Of(factor, index) => factor.root(meter, *index, bits),
        }
    }

    /// The sign.
    pub fn sign(&self, meter: &Meter) -> Result<i8, Stop> {
        match self {
            Place::Exact(value) => value.number()?.sign(),
            Place::Of(..) => decide(|bits| Ok(self.enclosed(meter, bits)?.sign())),
        }
    }

    /// How two roots compare.
    pub fn compare(&self, meter: &Meter, other: &Place) -> Result<Ordering, Stop> {
        match (self, other) {
            (Place::Exact(a), Place::Exact(b)) => {
                meter.spend(a.steps(b))?;
                a.number()?.compare(b.number()?)
            }
            (Place::Of(f, i), Place::Of(g, j)) if f == g => Ok(i.cmp(j)),
            _ => decide(|bits| {
                Ok(self.enclosed(meter, bits)?.compare(&other.enclosed(meter, bits)?))
            }),
        }
    }

    /// The absolute value.
    pub fn absolute(&self, meter: &Meter) -> Result<Place, Stop> {
        if self.sign(meter)? >= 0 {
            return Ok(self.clone());
        }
        Ok(match self {
            Place::Exact(value) => Place::Exact(value.negated()?),
            Place::Of(factor, index) => {
                // The roots of p(−x) in the other order; the leading coefficient remains.
                let degree = factor.p.len().saturating_sub(1);
                let turned = |(k, c): (usize, &Value)| {
                    let even = degree.abs_diff(k).is_multiple_of(2);
                    if even { Ok(c.clone()) } else { c.negated() }
                };
                let p = factor.p.iter().enumerate().map(turned);
                let p = p.collect::<Result<Polynomial, Stop>>()?;
                let index = factor.real.saturating_add(1).saturating_sub(*index);
                Place::Of(Rc::new(Factor { p, real: factor.real }), index)
            }
        })
    }
}
