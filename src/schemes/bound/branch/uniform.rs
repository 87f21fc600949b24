//! A common bound of the norms of all powers.

use super::estimate::{Estimator, margin};
use super::number::Number;
use super::reach::{Moments, place, rounded_up};
use super::scaled::Scaled;
use super::tree::Tree;
use super::wide::Wide;
use crate::exact::{Integer, Rational};

/// The greatest level of a node, and the greatest number of nodes.
const LEVELS: u32 = 16;
const NODES: u32 = 4096;

/// The values i for which 1 + 2^−i times the largest known norm is tried as the bound.
const EXCESS: [u32; 6] = [8, 6, 4, 2, 1, 0];

/// ‖E^m‖ ≤ τ for every m, and the tree that proves it: `proofs/THEOREMS.md`, 63.
#[derive(Clone, Debug, PartialEq)]
pub struct UniformBound {
    /// τ.
    pub bound: Rational,
    /// The leaves of the tree as (level, index), in the order of the rows below them.
    pub leaves: Vec<(u32, Integer)>,
}

/// A bound of all norms, if the rows of E sum to 1 and a bound is found. It is slightly
/// above `largest`, the largest known norm.
pub(super) fn bound(operator: &Scaled, largest: &Rational) -> Option<UniformBound> {
    let largest_row = operator.largest();
    // Every bound that is tried is at most twice `largest`, rounded up.
    let total = largest.ceil().bits() + 1 + operator.fraction.bits();
    let entry = largest_row.pow(LEVELS).bits();
    let bits = largest_row.to_i64().map(|_| entry + total + margin(operator.size));
    match bits {
        Some(0..=126) => seek::<i128>(operator, largest),
        Some(127..=510) => seek::<Wide<8>>(operator, largest),
        _ => seek::<Integer>(operator, largest),
    }
}

fn seek<T: Number>(operator: &Scaled, largest: &Rational) -> Option<UniformBound> {
    let shift = operator.shift.as_ref()?;
    let tree = Tree::<T>::new(operator)?;
    let tried = EXCESS.iter().map(|&excess| {
        let factor = Rational::one() + Rational::from(2).pow(-excess.cast_signed());
        rounded_up(&(largest * factor))
    });
    tried.into_iter().find_map(|bound| {
        let hull = Moments::hull(operator.arity, shift, &bound);
        let place = place(operator, (&hull, &Rational::zero()), &Integer::one(), &bound)?.fixed();
        // 2^PLACES·τ is an integer.
        let limit = (&bound * Rational::from(operator.fraction.clone())).numerator();
        let fraction = T::from_integer(&operator.fraction);
        let limits = (0..=LEVELS).map(|level| &limit * operator.denominator.pow(level));
        let limits: Vec<T> = limits.map(|limit| T::from_integer(&limit)).collect();
        let mut estimator = Estimator::new(tree.size);
        let closes =
            |rows: &[T], level: u32| estimator.bound(&tree, rows, &place) <= limits[level as usize];
        let fits =
            |rows: &[T], level: u32| tree.norm(rows).product(&fraction) <= limits[level as usize];
        let leaves = leaves(&tree, operator.arity, fits, closes)?;
        Some(UniformBound { bound, leaves })
    })
}

/// The leaves of a tree in which every node satisfies `fits` and every leaf satisfies
/// `closes`; `None` if there is none within the caps.
fn leaves<T: Number>(
    tree: &Tree<T>,
    arity: usize,
    fits: impl Fn(&[T], u32) -> bool,
    mut closes: impl FnMut(&[T], u32) -> bool,
) -> Option<Vec<(u32, Integer)>> {
    let mut leaves = Vec::new();
    let mut stack = vec![(0, Integer::zero(), tree.root())];
    let mut nodes = 0;
    while let Some((level, index, rows)) = stack.pop() {
        nodes += 1;
        if !fits(&rows, level) || nodes > NODES {
            return None;
        }
        if level > 0 && closes(&rows, level) {
            leaves.push((level, index));
            continue;
        }
        if level == LEVELS {
            return None;
        }
        for digit in (0..arity).rev() {
            let mut part = tree.root();
            tree.part(digit, &rows, &mut part);
            stack.push((level + 1, &index * Integer::from(arity) + Integer::from(digit), part));
        }
    }
    Some(leaves)
}
