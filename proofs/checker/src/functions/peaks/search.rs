//! Branch and bound: the cell with the greatest upper bound is split, until the bounds are near each other.

#![warn(clippy::arithmetic_side_effects)]

use super::cell::Cell;
use super::fixed::{DIGITS, Fixed, one};
use super::sums::{Sum, unit};
use crate::numbers::{Meter, Q};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The most cells that are split for one bound.
const MAX_SPLITS: usize = 4_096;

/// The highest level of a cell.
const MAX_LEVEL: u32 = 96;

/// The binary digits of 1 over the greatest difference of the bounds.
const ENOUGH: u64 = 40;

/// The binary digits behind the point of the result.
const PLACES: u64 = 64;

/// A cell, by its upper bound.
struct Bounded(BigInt, Cell);

impl PartialEq for Bounded {
    fn eq(&self, other: &Bounded) -> bool {
        self.0 == other.0
    }
}

impl Eq for Bounded {}

impl PartialOrd for Bounded {
    fn partial_cmp(&self, other: &Bounded) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Bounded {
    fn cmp(&self, other: &Bounded) -> Ordering {
        self.0.cmp(&other.0)
    }
}

/// C ≥ Σ_k |φ(x − k)| for all x. On a cell, the sum is at most A + Cr, with the absolute values A of the middles of the d_q and their
/// half differences r: at the x where it is greatest, C(1 − r) ≤ A.
fn total(meter: &Meter, fixed: &Fixed) -> Result<BigInt, Stop> {
    let endless = one() << DIGITS;
    let bounded = |cell: Cell| {
        let mut sums = [BigInt::default(), BigInt::default()];
        for row in &cell.rows {
            sums.iter_mut().zip(row.spread()).for_each(|(sum, x)| *sum += x);
        }
        let [radius, middle] = sums;
        let rest = one() - &radius;
        let fits = &rest << 4_u8 > one();
        let bound = if fits { (middle << DIGITS) / rest + 1_u8 } else { endless.clone() };
        (bound, radius, cell)
    };
    let (bound, mut radius, cell) = bounded(unit(fixed));
    let mut cells = BinaryHeap::from([Bounded(bound, cell)]);
    for _ in 0..MAX_SPLITS {
        let Some(Bounded(bound, cell)) = cells.pop() else { break };
        if bound < endless && (&radius << 3_u8 < one()) {
            return Ok(bound);
        }
        radius = BigInt::default();
        for part in cell.parts(fixed, meter)? {
            let (bound, of_part, part) = bounded(part);
            radius = radius.max(of_part);
            cells.push(Bounded(bound, part));
        }
    }
    Err(Stop::Capped("the cells of a limit function"))
}

/// Bounds of the supremum of a sum, or of 1, which all these sums reach.
pub fn greatest(meter: &Meter, fixed: &Fixed, sum: Sum) -> Result<[Q; 2], Stop> {
    let total = total(meter, fixed)?;
    let (mut low, near) = (one(), one() >> ENOUGH);
    let mut cells = BinaryHeap::new();
    for cell in sum.cells(fixed) {
        low = low.max(sum.at_start(&cell, fixed, &total));
        cells.push(Bounded(sum.above(&cell, &total), cell));
    }
    for _ in 0..MAX_SPLITS {
        let Some(Bounded(bound, cell)) = cells.peek() else { break };
        if *bound <= &low + &near || cell.level >= MAX_LEVEL {
            break;
        }
        let parts = cell.parts(fixed, meter)?;
        cells.pop();
        for part in parts {
            low = low.max(sum.at_start(&part, fixed, &total));
            cells.push(Bounded(sum.above(&part, &total), part));
        }
    }
    let high = cells.peek().map_or_else(|| low.clone(), |cell| cell.0.clone().max(low.clone()));
    let by = DIGITS.saturating_sub(PLACES);
    let unit = BigInt::one() << PLACES;
    Ok([Q::new(low >> by, unit.clone()), Q::new(-((-high) >> by), unit)])
}
