//! Real roots of polynomials, counted by Sturm's theorem. The coefficients may be enclosures: what is
//! decided holds for all polynomials with coefficients in them (THEOREMS.md, 132).

use super::interval::Interval;
use crate::numbers::{Meter, Q, common_multiple, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One, Signed};

/// The greatest degree.
const MAX_DEGREE: usize = 64;

/// Values of at most so many binary digits are computed exactly in any case.
const EXACT: u64 = 4_096;

/// The constant coefficient comes first. The leading one is not 0.
type Polynomial = Vec<Interval>;

/// A polynomial and its Sturm chain.
pub struct Sturm<'m> {
    chain: Vec<Polynomial>,
    bits: u64,
    meter: &'m Meter,
}

const LEADING: Stop = Stop::Undecided("the degree of a polynomial, or of a remainder of it");

/// Removes leading coefficients that are 0.
fn trimmed(mut p: Polynomial) -> Result<Polynomial, Stop> {
    while let Some(last) = p.last() {
        match last.sign() {
            Some(0) => _ = p.pop(),
            Some(_) => return Ok(p),
            None => return Err(LEADING),
        }
    }
    Ok(p)
}

impl<'m> Sturm<'m> {
    /// The chain p, p′, and then the negated remainders.
    pub fn new(coefficients: &[Interval], bits: u64, meter: &'m Meter) -> Result<Self, Stop> {
        let p = trimmed(coefficients.to_vec())?;
        if p.len() < 2 {
            return Err(Stop::Undefined("a constant has no roots"));
        }
        if p.len() > MAX_DEGREE + 1 {
            return Err(Stop::Capped("the degree of a polynomial"));
        }
        let mut sturm = Sturm { chain: vec![p], bits, meter };
        let slope = sturm.derivative()?;
        sturm.chain.push(slope);
        while let [.., before, last] = &sturm.chain[..]
            && last.len() > 1
        {
            let rest = trimmed(sturm.remainder(before.clone(), last)?)?;
            if rest.is_empty() {
                break;
            }
            sturm.chain.push(rest.iter().map(Interval::negated).collect());
        }
        Ok(sturm)
    }

    fn derivative(&self) -> Result<Polynomial, Stop> {
        let terms = (1_i64..).zip(&self.chain[0][1..]);
        terms.map(|(k, c)| c.times(&k.into(), self.bits)).collect()
    }

    /// The remainder of a division. The leading coefficients of both are not 0.
    fn remainder(&self, mut p: Polynomial, divisor: &Polynomial) -> Result<Polynomial, Stop> {
        let degree = divisor.len() - 1;
        let inverse = divisor[degree].inverse(self.bits)?;
        while p.len() > degree {
            let Some(leading) = p.pop() else { break };
            let factor = leading.times(&inverse, self.bits)?;
            let shift = p.len() - degree;
            for (i, coefficient) in divisor[..degree].iter().enumerate() {
                self.spend(coefficient, &factor)?;
                let product = factor.times(coefficient, self.bits)?;
                p[shift + i] = p[shift + i].minus(&product, self.bits)?;
            }
        }
        Ok(p)
    }

    /// Counts the steps of a product and a sum. Those of two rational numbers need common divisors.
    fn spend(&self, one: &Interval, other: &Interval) -> Result<(), Stop> {
        let words = |x: &Interval| x.size() / 64 + 1;
        let products = match (one, other) {
            (Interval::Point(_), Interval::Point(_)) => words(one).max(words(other)).pow(2) / 32,
            _ => words(one) * words(other) / 64,
        };
        self.meter.spend(1 + products)
    }

    /// p(x).
    fn at(&self, p: &Polynomial, x: &Interval) -> Result<Interval, Stop> {
        p.iter().rev().try_fold(Interval::from(0), |sum, coefficient| {
            self.spend(&sum, x)?;
            self.spend(&sum, coefficient)?;
            let sum = sum.times(x, self.bits)?.plus(coefficient, self.bits)?;
            // The exact values of long points would be much longer than what is asked for.
            if sum.size() <= EXACT + 8 * self.bits {
                return Ok(sum);
            }
            let (low, high, exponent) = sum.cover(4 * self.bits);
            Interval::new(low, high, exponent, 4 * self.bits)
        })
    }

    /// The changes of sign in the chain at a point. `None` if p may be 0 there, or a sign is not
    /// decided.
    fn changes(&self, x: &Q) -> Result<Option<usize>, Stop> {
        let x = Interval::point(x.clone())?;
        let (mut changes, mut before) = (0, 0);
        for (place, p) in self.chain.iter().enumerate() {
            let sign = match self.at(p, &x)?.sign() {
                None => return Ok(None),
                Some(0) if place == 0 => return Ok(None),
                Some(sign) => sign,
            };
            if sign != 0 {
                changes += usize::from(sign == -before);
                before = sign;
            }
        }
        Ok(Some(changes))
    }

    /// A number beyond the absolute values of all roots.
    fn beyond(&self) -> Result<Q, Stop> {
        let (p, mut sum) = (&self.chain[0], int(1));
        let inverse = p[p.len() - 1].inverse(self.bits)?;
        for coefficient in p {
            let (low, high) = coefficient.times(&inverse, self.bits)?.ends();
            sum += low.abs().max(high.abs());
        }
        // A power of two is short.
        let mut bound = int(1);
        while bound <= sum {
            bound *= int(2);
        }
        Ok(bound)
    }

    /// The real root with this number, from 1 on, ascending.
    pub fn root(&self, number: i64) -> Result<Interval, Stop> {
        let bound = self.beyond()?;
        let undecided = Stop::Undecided("the signs of a polynomial between its roots");
        let (mut low, mut high) = (-&bound, bound);
        let (Some(first), Some(last)) = (self.changes(&low)?, self.changes(&high)?) else {
            return Err(undecided);
        };
        let all = first.saturating_sub(last);
        let number = usize::try_from(number).ok().filter(|number| (1..=all).contains(number));
        let number = number.ok_or(Stop::Undefined("the polynomial has no such real root"))?;
        let mut alone = all == 1;
        let (mut below, mut above) = (first, last);
        // 0 is known exactly, and no enclosure of it is as fine as its own size.
        let zero = self.chain[0][0].sign() == Some(0);
        loop {
            if alone {
                if zero && low.is_negative() && high.is_positive() {
                    return Ok(Interval::from(0));
                }
                if let Some(root) = self.rational(&low, &high)? {
                    return Ok(Interval::Point(root));
                }
                if self.is_fine(&low, &high) {
                    return self.interval(&low, &high);
                }
                if let Some((inner, outer)) = self.newton(&low, &high)? {
                    let (a, b) = (self.changes(&inner)?, self.changes(&outer)?);
                    if let (Some(a), Some(b)) = (a, b) {
                        (low, high, below, above) = (inner, outer, a, b);
                        continue;
                    }
                }
            }
            // The cut must not hit a root.
            let cuts = [(1, 2), (3, 8), (5, 8), (7, 16)].map(|(a, b)| Q::new(a.into(), b.into()));
            let cut = cuts.iter().find_map(|part| {
                let cut = &low + (&high - &low) * part;
                self.changes(&cut).map(|changes| changes.map(|changes| (cut, changes))).transpose()
            });
            let Some(cut) = cut else {
                // The enclosures of the coefficients allow no finer one.
                return if alone { self.interval(&low, &high) } else { Err(undecided) };
            };
            let (cut, changes) = cut?;
            if first.saturating_sub(changes) >= number {
                (high, above) = (cut, changes);
            } else {
                (low, below) = (cut, changes);
            }
            alone = below.saturating_sub(above) == 1;
        }
    }

    /// The number of different real roots.
    pub fn count(&self) -> Result<i64, Stop> {
        let bound = self.beyond()?;
        let (Some(first), Some(last)) = (self.changes(&-&bound)?, self.changes(&bound)?) else {
            return Err(Stop::Undecided("the number of roots of a polynomial"));
        };
        Ok(i64::try_from(first.saturating_sub(last)).unwrap_or(0))
    }

    /// Whether no root is multiple.
    pub fn is_simple(&self) -> bool {
        self.chain.last().is_some_and(|last| last.len() == 1)
    }

    fn interval(&self, low: &Q, high: &Q) -> Result<Interval, Stop> {
        let [low, high] = [low, high].map(|end| Interval::Point(end.clone()));
        let ([low, _], [_, high], exponent) = low.aligned(&high, self.bits + 8);
        Interval::new(low, high, exponent, self.bits)
    }

    /// Whether an interval is as short as so many digits can be.
    fn is_fine(&self, low: &Q, high: &Q) -> bool {
        let scale = Q::from_integer(BigInt::one() << self.bits);
        low.is_positive() == high.is_positive() && (high - low) * scale <= low.abs().min(high.abs())
    }

    /// A step of Newton's method on an interval with one root: a shorter interval with the root.
    fn newton(&self, low: &Q, high: &Q) -> Result<Option<(Q, Q)>, Stop> {
        let whole = self.interval(low, high)?;
        let slope = self.at(&self.derivative()?, &whole)?;
        if slope.sign().is_none_or(|sign| sign == 0) {
            return Ok(None);
        }
        let middle = Interval::point((low + high) / int(2))?;
        let step =
            self.at(&self.chain[0], &middle)?.times(&slope.inverse(self.bits)?, self.bits)?;
        let next = middle.minus(&step, self.bits)?;
        // The ends are made short, and a little wider than needed, so that p is not 0 there.
        let (a, b) = next.ends();
        let margin = if a < b { (&b - &a) / int(8) } else { (high - low) / int(1 << 20) };
        let (a, b) = self.interval(&(a - &margin), &(b + margin))?.ends();
        let (a, b) = (a.max(low.clone()), b.min(high.clone()));
        // Halving does as much.
        Ok(((&b - &a) * int(2) < high - low).then_some((a, b)))
    }

    /// The root, if it is rational and the coefficients are. Its denominator divides the leading one of
    /// the integers that the coefficients are multiples of.
    fn rational(&self, low: &Q, high: &Q) -> Result<Option<Q>, Stop> {
        let p = &self.chain[0];
        let Some(known) = p.iter().map(Interval::exact).collect::<Option<Vec<&Q>>>() else {
            return Ok(None);
        };
        let over = common_multiple(known.iter().map(|c| c.denom()))?;
        let leading = known[known.len() - 1] * Q::from_integer(over);
        if int(1) <= (high - low) * leading.abs() {
            return Ok(None);
        }
        let candidate = (high * leading.abs()).floor() / leading.abs();
        let x = Interval::point(candidate.clone())?;
        let inside = candidate > *low && self.at(p, &x)?.sign() == Some(0);
        Ok(inside.then_some(candidate))
    }
}
