//! Cosines of rational multiples of π, by Taylor's series (THEOREMS.md, 131).

use super::interval::Interval;
use crate::numbers::{Q, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

/// Binary digits that are computed beyond those that are asked for.
const GUARD: u64 = 32;

/// Two integers l ≤ h: the number is from l·2^−places to h·2^−places.
type Ends = [BigInt; 2];

/// Enclosures of π and of cosines, with so many binary digits.
pub struct Circle {
    bits: u64,
    places: u64,
    pi: Ends,
}

/// ⌈n/d⌉, d > 0.
fn ceil(n: &BigInt, d: &BigInt) -> BigInt {
    -(-n).div_floor(d)
}

/// arctan(1/n) for an integer n ≥ 2.
fn arctangent(n: u32, places: u64) -> Ends {
    let (n, square) = (BigInt::from(n), BigInt::from(n) * n);
    let one = BigInt::one() << places;
    // The terms 1/((2k+1)·n^(2k+1)) fall; their signs alternate.
    let mut power = [one.div_floor(&n), ceil(&one, &n)];
    let mut sum: Ends = [BigInt::zero(), BigInt::zero()];
    for k in 0_u64.. {
        let odd = BigInt::from(2 * k + 1);
        let term = [power[0].div_floor(&odd), ceil(&power[1], &odd)];
        add(&mut sum, &term, k % 2 == 1);
        if term[1] <= BigInt::one() {
            break;
        }
        power = [power[0].div_floor(&square), ceil(&power[1], &square)];
    }
    // What follows is at most the last term, which is at most 1.
    [&sum[0] - 1, &sum[1] + 1]
}

/// Adds or subtracts a term.
fn add(sum: &mut Ends, term: &Ends, minus: bool) {
    let [low, high] = term;
    if minus {
        sum[0] -= high;
        sum[1] -= low;
    } else {
        sum[0] += low;
        sum[1] += high;
    }
}

impl Circle {
    /// Computes π by Machin's formula: π = 16·arctan(1/5) − 4·arctan(1/239).
    pub fn new(bits: u64) -> Circle {
        let places = bits + GUARD;
        let [one, other] = [5, 239].map(|n| arctangent(n, places));
        let pi = [&one[0] * 16 - &other[1] * 4, &one[1] * 16 - &other[0] * 4];
        Circle { bits, places, pi }
    }

    /// The steps that a cosine costs.
    pub fn cost(&self) -> u64 {
        let words = self.places / 64 + 1;
        self.places / 8 * (1 + words * words / 256)
    }

    /// cos(turns·2π).
    pub fn cosine(&self, turns: &Q) -> Result<Interval, Stop> {
        // cos(2πt) = cos(2π(1 − t)) = −cos(2π(1/2 − t)): t is brought between 0 and 1/4.
        let part = turns - turns.floor();
        let part = if part > Q::new(1.into(), 2.into()) { int(1) - part } else { part };
        let turned = part > Q::new(1.into(), 4.into());
        let part = if turned { Q::new(1.into(), 2.into()) - part } else { part };
        let value = match (i32::try_from(part.numer()), i32::try_from(part.denom())) {
            (Ok(0), _) => 1.into(),
            (Ok(1), Ok(4)) => 0.into(),
            (Ok(1), Ok(6)) => Interval::Point(Q::new(1.into(), 2.into())),
            _ => self.series(&part)?,
        };
        Ok(if turned { value.negated() } else { value })
    }

    /// The series for an angle of 0 to 1/4 of the turn.
    fn series(&self, part: &Q) -> Result<Interval, Stop> {
        let (top, bottom): (BigInt, &BigInt) = (part.numer() * 2, part.denom());
        let angle = [(&self.pi[0] * &top).div_floor(bottom), ceil(&(&self.pi[1] * &top), bottom)];
        let unit = BigInt::one() << self.places;
        let square =
            [(&angle[0] * &angle[0]).div_floor(&unit), ceil(&(&angle[1] * &angle[1]), &unit)];
        let mut term = [unit.clone(), unit.clone()];
        let mut sum = term.clone();
        for k in 1_u64.. {
            let divisor = (BigInt::from(2 * k) * (2 * k - 1)) << self.places;
            term = [
                (&term[0] * &square[0]).div_floor(&divisor),
                ceil(&(&term[1] * &square[1]), &divisor),
            ];
            // The sum before this term and the sum with it lie on two sides of the cosine.
            if term[1] <= BigInt::one() {
                sum = [&sum[0] - &term[1], &sum[1] + &term[1]];
                break;
            }
            add(&mut sum, &term, k % 2 == 1);
        }
        let [low, high] = sum;
        let places = i64::try_from(self.places).unwrap_or(i64::MAX);
        Interval::new(low, high, -places, self.bits)
    }
}
