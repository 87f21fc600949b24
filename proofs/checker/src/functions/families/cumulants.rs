//! The cumulants of the symbols of a family: the derivatives of log a(e^u) at 0.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::number;
use crate::functions::steps::{add, over, plus, times};
use crate::numbers::{Meter, Q, Value};
use crate::schemes::Family;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;

/// The greatest order of a cumulant.
const MAX_ORDER: usize = 64;

const VANISHES: Stop = Stop::Family("a cumulant may be 0 for some values of the index only");
const NONE: Stop = Stop::Family("no cumulant up to order 64 is other than 0");

/// The least order from 2 on of a cumulant that is not 0, for all values of the index.
pub fn first(meter: &Meter, family: &Family) -> Result<usize, Stop> {
    // A factor of one term has the cumulants 0 of these orders.
    let several = family.factors.iter().filter(|factor| factor.has_several());
    let mut factors: Vec<(Value, Cumulants)> = several
        .map(|factor| {
            let exponent = factor.exponent(&family.integers);
            Ok((exponent, Cumulants::new(factor.dense(), factor.at_one()?)))
        })
        .collect::<Result<_, Stop>>()?;
    for order in 1..=MAX_ORDER {
        let mut sum = Value::int(0);
        for (exponent, cumulants) in &mut factors {
            let next = cumulants.next(meter)?;
            add(meter, &mut sum, exponent, &next)?;
        }
        if order >= 2 && !sum.is_zero() {
            let never = family.integers.never_zero(meter, &sum)?;
            return if never { Ok(order) } else { Err(VANISHES) };
        }
    }
    Err(NONE)
}

/// The cumulants of one factor, one after the other.
struct Cumulants {
    /// The coefficients times powers of their places, counted from the lowest one. This changes the first cumulant only.
    weights: Vec<Value>,
    /// f(1).
    sum: Value,
    /// M_1, M_2, … up to now.
    moments: Vec<Value>,
    /// κ_1, κ_2, … up to now.
    known: Vec<Value>,
    /// The binomial coefficients of the next order less 1.
    binomials: Vec<BigInt>,
}

impl Cumulants {
    fn new(weights: Vec<Value>, sum: Value) -> Cumulants {
        let (moments, known) = Default::default();
        Cumulants { weights, sum, moments, known, binomials: vec![BigInt::one()] }
    }

    /// κ_n = M_n − Σ_{0<m<n} binomial(n − 1, m − 1) κ_m M_{n−m}.
    fn next(&mut self, meter: &Meter) -> Result<Value, Stop> {
        let mut moment = Value::int(0);
        for (place, weight) in self.weights.iter_mut().enumerate() {
            *weight = times(meter, weight, &number(place))?;
            plus(meter, &mut moment, weight)?;
        }
        let moment = over(meter, &moment, &self.sum)?;
        let mut next = moment.clone();
        let terms = self.known.iter().zip(self.moments.iter().rev()).zip(&self.binomials);
        for ((kappa, moment), binomial) in terms {
            let binomial = Q::from_integer(-binomial).into();
            add(meter, &mut next, &times(meter, kappa, moment)?, &binomial)?;
        }
        self.moments.push(moment);
        self.known.push(next.clone());
        let row = &self.binomials;
        let inner = row.iter().zip(row.iter().skip(1)).map(|(a, b)| a + b);
        self.binomials = [BigInt::one()].into_iter().chain(inner).chain([BigInt::one()]).collect();
        Ok(next)
    }
}
