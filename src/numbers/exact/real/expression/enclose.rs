//! Enclosures of expressions.

use super::node::{Generator, Operation, RealExpression};
use super::rounded::outward;
use crate::exact::real::square::floor_root;
use crate::exact::{Enclosed, Enclosure, Integer, Rational};

/// From this level on, a rational number has an enclosure of width 0.
const RATIONAL_LEVEL: u32 = 2;

impl RealExpression {
    /// An enclosure that is about 2^(−64·2^level) wide, also of a rational number.
    pub(super) fn approximation(&self, level: u32) -> Enclosure {
        match self.0.enclosures.get(level as usize) {
            Some(known) => known.get_or_init(|| self.approximated(level)).clone(),
            None => self.approximated(level),
        }
    }

    fn approximated(&self, level: u32) -> Enclosure {
        let both = |a: &RealExpression, b: &RealExpression| {
            (a.approximation(level), b.approximation(level))
        };
        let value = match &self.0.operation {
            Operation::Number(value) => return value.enclosure(level),
            Operation::Sum(a, b) => {
                let (a, b) = both(a, b);
                &a + &b
            }
            Operation::Difference(a, b) => {
                let (a, b) = both(a, b);
                &a - &b
            }
            Operation::Product(a, b) => {
                let (a, b) = both(a, b);
                &a * &b
            }
            Operation::Quotient(a, b) => {
                // The divisor is not 0, so that some enclosure excludes 0.
                let (mut finer, mut divisor) = (level, b.approximation(level));
                while divisor.sign().is_none() {
                    finer += 1;
                    divisor = b.approximation(finer);
                }
                let inverse = Enclosure::new(divisor.upper().recip(), divisor.lower().recip());
                &a.approximation(level) * &inverse
            }
            Operation::Root(generator) => match &**generator {
                Generator::Square(radicand) => root(&radicand.approximation(level + 1), level),
                Generator::Isolated(root) => root.enclosure(places(level)),
            },
        };
        outward(&value, places(level) + 32)
    }
}

fn places(level: u32) -> u32 {
    64_u32.checked_shl(level).filter(|&places| places > 0).expect("a precision that fits in memory")
}

/// √x for all x ≥ 0 of an interval that contains such a number.
fn root(x: &Enclosure, level: u32) -> Enclosure {
    let places = places(level) + 32;
    let scale = Rational::from(Integer::one().shifted_left(2 * places));
    let unit = Integer::one().shifted_left(places);
    let lower = (x.lower() * &scale).floor();
    let lower = if lower.sign() < 0 { Integer::zero() } else { floor_root(&lower) };
    let upper = floor_root(&(x.upper() * &scale).ceil()) + Integer::one();
    Enclosure::new(Rational::new(lower, unit.clone()), Rational::new(upper, unit))
}

impl Enclosed for RealExpression {
    fn enclosure(&self, level: u32) -> Enclosure {
        if level >= RATIONAL_LEVEL
            && let Some(value) = self.as_rational()
        {
            return Enclosure::exact(value.clone());
        }
        self.approximation(level)
    }
}
