//! The order of the eigenvalues.

use super::ball::{Ball, DIGITS};
use super::inner::Inner;
use super::lattice::Part;
use crate::enclosures::{Interval, at, is_within, without};
use crate::numbers::{Q, Ring, characteristic, count, int};
use crate::text::{Checked, Reason, Stop, require};
use num_traits::Zero;

/// The most powers of the matrix of the outer points.
const MAX_POWER: usize = 256;

/// Arithmetic of such numbers.
struct Balls;

impl Ring<Ball> for Balls {
    fn integer(&self, value: i64) -> Ball {
        Ball::from(value)
    }

    fn add(&self, sum: &mut Ball, term: &Ball) -> Result<(), Stop> {
        *sum = sum.plus(term);
        Ok(())
    }

    fn add_product(&self, sum: &mut Ball, left: &Ball, right: &Ball) -> Result<(), Stop> {
        *sum = sum.plus(&left.times(right));
        Ok(())
    }

    fn share(&self, x: &Ball, k: usize) -> Result<Ball, Stop> {
        Ok(x.times(&Ball::from(&(int(-1) / count(k)))))
    }
}

/// The coefficients of the characteristic polynomial of block k, for k = 0 divided by x − 1: the weights of a point sum to 1.
fn of_block(inner: &Inner, k: usize) -> Result<Vec<Interval>, Stop> {
    let p = characteristic(&Balls, &inner.block(k)?)?;
    let p = p.iter().map(Ball::interval).collect::<Result<Vec<Interval>, Stop>>()?;
    if k == 0 { without(&p, &Interval::from(1), DIGITS) } else { Ok(p) }
}

/// The sign of p at a number.
fn sign_at(p: &[Interval], x: &Q) -> Result<Option<i8>, Stop> {
    let sign = at(p, &Interval::point(x.clone())?, DIGITS)?.sign();
    Ok(sign.filter(|sign| *sign != 0))
}

/// Checks that 1 is a simple eigenvalue, that there is one eigenvalue between two numbers in block k, and in block n − k if
/// k ≠ 0, and that all others are below r in absolute value.
pub fn check(inner: &Inner, k: usize, [low, high]: [&Q; 2], r: &Q) -> Checked<()> {
    let size = low.clone().max(-high.clone());
    require(*r >= Q::zero() && *r <= size && size > Q::zero(), Reason::Vertex("0 ≤ r ≤ |λ|"))?;
    require(low < high && high.clone().max(-low.clone()) < int(1), Reason::Vertex("|λ| < 1"))?;
    require(k < inner.order.div_ceil(2), Reason::Vertex("k < n/2"))?;
    let between = Ball::between(low, high).interval()?;
    for block in 0..=inner.order / 2 {
        let mut p = of_block(inner, block)?;
        if block == k {
            let ends = (sign_at(&p, low)?, sign_at(&p, high)?);
            let changes = matches!(ends, (Some(a), Some(b)) if a != b);
            require(changes, Reason::Vertex("a change of sign of the characteristic polynomial"))?;
            p = without(&p, &between, DIGITS)?;
        }
        require(is_within(p, r, DIGITS)?, Reason::Vertex("all other eigenvalues below r"))?;
    }
    require(
        outer_is_within(inner.part, r),
        Reason::Vertex("the eigenvalues of the outer points below r"),
    )
}

/// Checks that block k has an eigenvalue above 1, or below −1: its characteristic polynomial, for k = 0 divided by x − 1,
/// is negative at 1, or has at −1 another sign than far to the left.
pub fn diverges(inner: &Inner, k: usize, side: i64) -> Checked<()> {
    require(k <= inner.order / 2, Reason::Vertex("k ≤ n/2"))?;
    let p = of_block(inner, k)?;
    let even = side > 0 || p.len() % 2 == 1;
    let sign = sign_at(&p, &int(side))?;
    require(
        sign == Some(if even { -1 } else { 1 }),
        Reason::Vertex("an eigenvalue beyond 1 or −1 by the sign of the characteristic polynomial"),
    )
}

/// Whether the rules of the outer points have no eigenvalue of the absolute value r or more. Their weights are not negative,
/// so that those of no block exceed the sums over all sectors.
fn outer_is_within(part: Part, r: &Q) -> bool {
    let places = part.outer();
    let row = |place: &(i32, i32)| -> Vec<Q> {
        let mut row = vec![Q::zero(); places.len()];
        for (old, weight) in part.rule(*place) {
            let home = part.turned(old).0;
            if let Some(at) = places.iter().position(|known| *known == home) {
                row[at] += weight;
            }
        }
        row
    };
    let matrix: Vec<Vec<Q>> = places.iter().map(row).collect();
    let (mut sums, mut bound) = (vec![int(1); places.len()], int(1));
    for _ in 0..MAX_POWER {
        let product = |row: &Vec<Q>| row.iter().zip(&sums).map(|(w, x)| w * x).sum();
        sums = matrix.iter().map(product).collect();
        bound *= r;
        if sums.iter().all(|sum| *sum < bound) {
            return true;
        }
    }
    false
}
