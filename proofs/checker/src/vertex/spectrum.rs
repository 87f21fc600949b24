//! The order of the eigenvalues.

use super::ball::Ball;
use super::inner::Inner;
use super::lattice::Part;
use crate::numbers::{Q, count, int};
use crate::text::{Checked, Reason, require};
use num_traits::Zero;

/// The most powers of the matrix of the outer points.
const MAX_POWER: usize = 256;

/// The coefficients of det(x − M), from the constant one on (Faddeev and Leverrier).
fn characteristic(matrix: &[Vec<Ball>]) -> Vec<Ball> {
    let d = matrix.len();
    let mut coefficients = vec![Ball::from(1)];
    let zero = || vec![vec![Ball::from(0); d]; d];
    let mut power = zero();
    for k in 1..=d {
        // N_k = M·N_{k−1} + c_{d−k+1}·1, c_{d−k} = −tr(M·N_k)/k.
        let last = coefficients[0].clone();
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = row[i].plus(&last);
        }
        let mut next = zero();
        for i in 0..d {
            for j in 0..d {
                for (l, row) in power.iter().enumerate() {
                    next[i][j] = next[i][j].plus(&matrix[i][l].times(&row[j]));
                }
            }
        }
        let trace = (0..d).fold(Ball::from(0), |sum, i| sum.plus(&next[i][i]));
        let share = Ball::from(&(int(-1) / count(k)));
        coefficients.insert(0, trace.times(&share));
        power = next;
    }
    coefficients
}

/// The quotient of a polynomial by x − λ, of which λ is a root.
fn without(p: &[Ball], root: &Ball) -> Vec<Ball> {
    let mut quotient: Vec<Ball> = Vec::new();
    for c in p[1..].iter().rev() {
        let carried = quotient.last().map_or(Ball::from(0), |last| last.times(root));
        quotient.push(c.plus(&carried));
    }
    quotient.reverse();
    quotient
}

/// p(x).
fn at(p: &[Ball], x: &Q) -> Ball {
    let x = Ball::from(x);
    p.iter().rev().fold(Ball::from(0), |sum, c| sum.times(&x).plus(c))
}

/// Whether all complex roots are certainly below r in absolute value (Schur and Cohn).
fn is_within(p: &[Ball], r: &Q) -> bool {
    let (radius, mut scale) = (Ball::from(r), Ball::from(1));
    let mut p: Vec<Ball> = p.to_vec();
    for c in &mut p {
        *c = c.times(&scale);
        scale = scale.times(&radius);
    }
    while let [first, .., last] = &p[..] {
        if !first.size().is_below(&last.least_size()) {
            return false;
        }
        let d = p.len() - 1;
        p = (0..d).map(|j| last.times(&p[j + 1]).minus(&first.times(&p[d - 1 - j]))).collect();
    }
    true
}

/// Checks that 1 is a simple eigenvalue, that there is one eigenvalue between two numbers in block k, and in block n − k if
/// k ≠ 0, and that all others are below r in absolute value.
pub fn check(inner: &Inner, k: usize, [low, high]: [&Q; 2], r: &Q) -> Checked<()> {
    let size = low.clone().max(-high.clone());
    require(*r >= Q::zero() && *r <= size && size > Q::zero(), Reason::Vertex("0 ≤ r ≤ |λ|"))?;
    require(low < high && high.clone().max(-low.clone()) < int(1), Reason::Vertex("|λ| < 1"))?;
    require(k < inner.order.div_ceil(2), Reason::Vertex("k < n/2"))?;
    let between = Ball::between(low, high);
    for block in 0..=inner.order / 2 {
        let mut p = characteristic(&inner.block(block)?);
        if block == 0 {
            // The weights of a point sum to 1.
            p = without(&p, &Ball::from(1));
        }
        if block == k {
            let ends = [low, high].map(|end| at(&p, end).sign());
            let changes = matches!(ends, [Some(a), Some(b)] if a != b);
            require(changes, Reason::Vertex("a change of sign of the characteristic polynomial"))?;
            p = without(&p, &between);
        }
        require(is_within(&p, r), Reason::Vertex("all other eigenvalues below r"))?;
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
    let mut p = characteristic(&inner.block(k)?);
    if k == 0 {
        p = without(&p, &Ball::from(1));
    }
    let even = side > 0 || p.len() % 2 == 1;
    let sign = at(&p, &int(side)).sign();
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
