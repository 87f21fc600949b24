//! The functions of formulas on intervals. proofs/format/shipped.md defines them.

use crate::enclosures::{Interval, Sturm};
use crate::formulas::MAX_INTEGER;
use crate::numbers::{Meter, Q};
use crate::text::Stop;
use num_traits::Zero;
use std::cmp::Ordering;

/// The greatest lower index of a binomial coefficient.
const MAX_BINOMIAL: i64 = 10_000;

/// The greatest integer whose factorial is taken.
const MAX_FACTORIAL: i64 = 1_000;

/// What functions need beside their arguments.
#[derive(Clone, Copy)]
pub struct Call<'m> {
    /// The binary digits of enclosures.
    pub bits: u64,
    /// The meter of the claim.
    pub meter: &'m Meter,
}

impl Call<'_> {
    /// The value of a function other than `cos`.
    pub fn value(self, function: &str, arguments: &[Interval]) -> Result<Interval, Stop> {
        let bits = self.bits;
        match (function, arguments) {
            ("abs", [x]) => Ok(x.absolute()),
            ("max" | "min", [first, rest @ ..]) => {
                rest.iter().try_fold(first.clone(), |best, x| self.join(function, &best, x))
            }
            ("floor", [x]) => floor(x),
            ("ceil", [x]) => Ok(floor(&x.negated())?.negated()),
            ("mod", [x, m]) => {
                let quotient = x.times(&m.inverse(bits)?, bits)?;
                x.minus(&m.times(&floor(&quotient)?, bits)?, bits)
            }
            ("kronecker", [a, b]) => match a.compare(b) {
                Some(order) => Ok(i64::from(order == Ordering::Equal).into()),
                None => Err(Stop::Undecided("whether two numbers are equal")),
            },
            ("binomial", [top, bottom]) => self.binomial(top, bottom.integer(MAX_BINOMIAL)?),
            ("factorial", [n]) => self.factorial(n.integer(MAX_FACTORIAL)?),
            ("sqrt", [x]) => x.root(bits),
            ("root", [coefficients @ .., number]) => {
                let number = number.integer(MAX_INTEGER)?;
                Sturm::new(coefficients, bits, self.meter)?.root(number)
            }
            (_, arguments) => {
                let count = arguments.len();
                Err(Stop::Wrong(format!("there is no `{function}` of {count} arguments")))
            }
        }
    }

    /// The `sum`, `product`, `max` or `min` of two values.
    pub fn join(self, fold: &str, a: &Interval, b: &Interval) -> Result<Interval, Stop> {
        match fold {
            "sum" => a.plus(b, self.bits),
            "product" => {
                let steps = (a.size() / 64).saturating_mul(b.size() / 64) / 256;
                self.meter.spend(steps.saturating_add(1))?;
                a.times(b, self.bits)
            }
            "max" => a.max(b, self.bits),
            _ => Ok(a.negated().max(&b.negated(), self.bits)?.negated()),
        }
    }

    /// n!.
    fn factorial(self, n: i64) -> Result<Interval, Stop> {
        if n < 0 {
            return Err(Stop::Wrong("`factorial` of a negative number".to_owned()));
        }
        (1..=n).try_fold(Interval::from(1), |product, i| self.join("product", &product, &i.into()))
    }

    /// top(top − 1)…(top − bottom + 1)/bottom!, and 0 for bottom < 0.
    fn binomial(self, top: &Interval, bottom: i64) -> Result<Interval, Stop> {
        let first = Interval::from(i64::from(bottom >= 0));
        (0..bottom).try_fold(first, |product, i| {
            self.meter.spend(1 + product.size() / 64)?;
            let factor = top.minus(&i.into(), self.bits)?;
            let product = product.times(&factor, self.bits)?;
            product.times(&Interval::from(i + 1).inverse(self.bits)?, self.bits)
        })
    }
}

/// ⌊x⌋.
fn floor(x: &Interval) -> Result<Interval, Stop> {
    Interval::point(Q::from_integer(x.floor()?))
}

/// Whether this is exactly 0.
pub fn is_zero(x: &Interval) -> bool {
    x.exact().is_some_and(Zero::is_zero)
}
