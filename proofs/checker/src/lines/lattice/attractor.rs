//! The integer points of attractors.

#![warn(clippy::arithmetic_side_effects)]

use super::motion::{Motion, UNIT};
use crate::numbers::{Meter, Q, int};
use crate::schemes::{Dilation, Vector, plus, times};
use crate::text::{Checked, Reason, Stop};
use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};
use std::collections::BTreeSet;

/// The most integer points of an attractor.
const MAX_POINTS: usize = 400;

/// The most integer points of the box in which they are looked for.
const MAX_BOX: u64 = 1 << 20;

/// The most vectors p − q.
const MAX_STEPS: usize = 1 << 16;

/// The most powers of M^{−1} that a box adds up.
const MAX_POWERS: usize = 256;

/// The integer points, in lexicographic order, of the compact set X = M^{−1}(X + P − Q).
///
/// An integer x is in X if and only if there are integers x_0 = x, x_1, … in a bounded set with x_{k+1} = Mx_k − p_k + q_k: then x is the sum of the
/// M^{−k}(p_{k−1} − q_{k−1}), and all x_k are in X. So of the integer points of a box that contains X, those go for which no such next
/// point is left, until all have one.
pub fn points(
    meter: &Meter,
    dilation: &Dilation,
    (plus_side, minus_side): (&[Vector], &[Vector]),
) -> Result<Vec<Vector>, Stop> {
    let pairs = (plus_side.len() as u64).saturating_mul(minus_side.len() as u64);
    meter.spend(pairs)?;
    let mut steps = BTreeSet::new();
    for p in plus_side {
        for q in minus_side {
            steps.insert((UNIT, plus(*q, -1, *p)?));
        }
        if steps.len() > MAX_STEPS {
            return Err(TOO_MANY);
        }
    }
    left_in(meter, dilation, &around(meter, dilation, (plus_side, minus_side))?, &steps)
}

/// The largest finite set of places α of which each has a place β in the set with Mα + t − Gβ in a support, for a part (G, t), in lexicographic
/// order. The G are of a group of matrices H with MHM^{−1} = H.
///
/// The set is in the attractor Y = M^{−1}(Y + D), D the h(γ − t) for all h of the group and γ of the support: Y is fixed by the group, and
/// α = M^{−1}(Gβ + γ − t).
pub fn places(
    meter: &Meter,
    dilation: &Dilation,
    (support, parts, group): (&[Vector], &[Motion], &BTreeSet<[Vector; 3]>),
) -> Checked<Vec<Vector>> {
    let count = support.len().saturating_mul(parts.len()) as u64;
    meter.spend(count.saturating_mul(group.len() as u64))?;
    let (mut steps, mut moved) = (BTreeSet::new(), BTreeSet::new());
    for part in parts {
        let back = inverse(&part.turn, group)?;
        for place in support {
            let by = plus(part.by, -1, *place)?;
            steps.insert((back, by));
            for turn in group {
                moved.insert(times(turn, plus([0; 3], -1, by)?)?);
            }
        }
        if steps.len().max(moved.len()) > MAX_STEPS {
            return Err(TOO_MANY.into());
        }
    }
    let moved: Vec<Vector> = moved.into_iter().collect();
    Ok(left_in(meter, dilation, &around(meter, dilation, (&moved, &[[0; 3]]))?, &steps)?)
}

/// The inverse of a matrix in a finite group.
fn inverse(turn: &[Vector; 3], group: &BTreeSet<[Vector; 3]>) -> Checked<[Vector; 3]> {
    for other in group {
        let columns = [0, 1, 2].map(|j: usize| times(other, turn.map(|row| row[j])));
        if columns.into_iter().zip(UNIT).all(|(column, unit)| column == Ok(unit)) {
            return Ok(*other);
        }
    }
    Err(Reason::Lattice("the group of the tile has the matrices of the parts").into())
}

/// The largest set of points x of a box of which each has a point B(Mx + b) in the set, for a step (B, b).
fn left_in(
    meter: &Meter,
    dilation: &Dilation,
    around: &Around,
    steps: &BTreeSet<([Vector; 3], Vector)>,
) -> Result<Vec<Vector>, Stop> {
    let mut left = around.points();
    meter.spend(left.len() as u64)?;
    let mut there = vec![true; left.len()];
    loop {
        let (before, mut tried) = (left.len(), 0_u64);
        let mut kept = Vec::new();
        for point in left {
            let image = dilation.times(point)?;
            let mut has_next = false;
            for (turn, step) in steps {
                tried = tried.saturating_add(1);
                let next = plus(image, 1, *step)?;
                let next = if *turn == UNIT { next } else { times(turn, next)? };
                let place = around.place(next);
                if place.is_some_and(|place| there[place]) {
                    has_next = true;
                    break;
                }
            }
            meter.spend(std::mem::take(&mut tried))?;
            if has_next {
                kept.push(point);
            } else if let Some(place) = around.place(point) {
                there[place] = false;
            }
        }
        left = kept;
        if left.len() == before {
            break;
        }
    }
    if left.len() > MAX_POINTS {
        return Err(Stop::Capped("the points of a window"));
    }
    Ok(left)
}

/// A box of integer points, by its lower corner and the numbers of points in each direction.
struct Around {
    low: Vector,
    sizes: [u64; 3],
}

impl Around {
    /// The number of a point in lexicographic order.
    fn place(&self, point: Vector) -> Option<usize> {
        let mut place = 0_u64;
        for ((x, low), size) in point.into_iter().zip(self.low).zip(self.sizes) {
            let i = u64::try_from(x.checked_sub(low)?).ok().filter(|i| *i < size)?;
            place = place.checked_mul(size)?.checked_add(i)?;
        }
        usize::try_from(place).ok()
    }

    /// All points in lexicographic order.
    fn points(&self) -> Vec<Vector> {
        let [first, second, third] = [0, 1, 2].map(|i: usize| {
            let low = self.low[i];
            (0..self.sizes[i]).map(move |k| low.saturating_add_unsigned(k))
        });
        let plane = |x: i64| {
            let third = third.clone();
            second.clone().flat_map(move |y| third.clone().map(move |z| [x, y, z]))
        };
        first.flat_map(plane).collect()
    }
}

/// A box that contains the attractor.
///
/// X = Σ_{j≤J} M^{−j}(P − Q) + M^{−J}X. The sum is between its extremes in each coordinate, which are at most R in absolute value. Let q_i be
/// the sums of the absolute values of the entries of M^{−J} row by row. Where the greatest q is below 1, coordinates of X are at most
/// r = R/(1 − q) in absolute value, and coordinate i is at most q_i·r from those of the sum.
fn around(
    meter: &Meter,
    dilation: &Dilation,
    (plus_side, minus_side): (&[Vector], &[Vector]),
) -> Result<Around, Stop> {
    let d = dilation.d;
    let (adjugate, determinant) = dilation.adjugate();
    let integers = adjugate.map(|row| row.map(BigInt::from));
    // The rows of det^J·M^{−J}.
    let mut power = integers.clone();
    let (mut over, mut ends) = (BigInt::from(determinant), vec![(Q::zero(), Q::zero()); d]);
    let count = (plus_side.len() as u64).saturating_add(minus_side.len() as u64);
    for _ in 0..MAX_POWERS {
        meter.spend(count.saturating_add(1))?;
        for ((low, high), row) in ends.iter_mut().zip(&power) {
            let [first, second] = [plus_side, minus_side].map(|side| extremes(row, side));
            // p − q, divided by a power of the determinant, which may be negative.
            let of = [first.0 - &second.1, first.1 - &second.0].map(|x| Q::new(x, over.clone()));
            let [one, other] = of;
            *low += (&one).min(&other);
            *high += one.max(other);
        }
        let sums = power
            .iter()
            .take(d)
            .map(|row| Q::new(row.iter().take(d).map(BigInt::abs).sum::<BigInt>(), over.abs()));
        let sums: Vec<Q> = sums.collect();
        let q = sums.iter().max().cloned().unwrap_or_default();
        if q <= Q::new(1.into(), 16.into()) {
            let greatest = ends.iter().flat_map(|(low, high)| [low.abs(), high.abs()]).max();
            let r = greatest.unwrap_or_default() / (int(1) - q);
            return boxed(ends.into_iter().zip(sums).map(|((low, high), q)| {
                let by = q * &r;
                (low - &by, high + by)
            }));
        }
        power = [0, 1, 2].map(|i: usize| {
            [0, 1, 2].map(|j: usize| (0..3).map(|k| &power[i][k] * &integers[k][j]).sum())
        });
        over *= determinant;
    }
    Err(Stop::Capped("the size of an attractor"))
}

/// The least and the greatest product of a row with vectors.
fn extremes(row: &[BigInt; 3], vectors: &[Vector]) -> (BigInt, BigInt) {
    let product = |vector: &Vector| row.iter().zip(vector).map(|(c, x)| c * x).sum::<BigInt>();
    let mut products = vectors.iter().map(product);
    let first = products.next().unwrap_or_default();
    products.fold((first.clone(), first), |(low, high), x| {
        if x < low {
            (x, high)
        } else if x > high {
            (low, x)
        } else {
            (low, high)
        }
    })
}

/// The box of the integers between these ends.
fn boxed(ends: impl Iterator<Item = (Q, Q)>) -> Result<Around, Stop> {
    let (mut low, mut sizes, mut count) = ([0; 3], [1; 3], 1_u64);
    for ((start, size), (from, to)) in low.iter_mut().zip(&mut sizes).zip(ends) {
        let (from, to) = (from.ceil().to_integer(), to.floor().to_integer());
        let length: BigInt = &to - &from + 1_u8;
        let found = (i64::try_from(from), u64::try_from(length.max(BigInt::zero())));
        let (Ok(from), Ok(length)) = found else { return Err(TOO_LARGE) };
        (*start, *size) = (from, length);
        count = count.checked_mul(length).filter(|count| *count <= MAX_BOX).ok_or(TOO_LARGE)?;
    }
    Ok(Around { low, sizes })
}

const TOO_MANY: Stop = Stop::Capped("the digits of an attractor");

const TOO_LARGE: Stop = Stop::Capped("the points of a box around an attractor");
