//! A cover of all rows by leaves that proves which norm is the greatest.

use super::descent::{Descent, WorkingMemory, product};
use super::number::Number;
use super::search_tree::{Closed, Leaf};
use crate::exact::Integer;

/// Leaves that cover all rows and prove that none has a norm above `greatest`: each leaf
/// is a row itself, or is bounded by its own rows. `None` when the work does not suffice.
pub(super) fn cover<T: Number, const K: usize>(
    descent: &Descent<'_, T, K>,
    greatest: &Integer,
    work: &mut u64,
) -> Option<Vec<Leaf>> {
    let mut space = descent.space();
    let arity = descent.problem.operators[0].arity;
    let limit = descent.limit(&T::from_integer(greatest));
    let mut leaves = Vec::new();
    let mut stack = vec![(0, Integer::zero(), descent.root().rows)];
    while let Some((level, index, rows)) = stack.pop() {
        let left = descent.problem.levels - level;
        let closed = match (level, left) {
            (_, 0) => Some(Closed::Row),
            (0, _) => None,
            _ => closed(descent, &mut space, &rows, left as usize, &limit),
        };
        if let Some(closed) = closed {
            leaves.push(Leaf { level, index, closed });
            continue;
        }
        for digit in (0..arity).rev() {
            *work = work.checked_sub(descent.cost)?;
            let mut part = descent.root().rows;
            descent.part(digit, &rows, &mut part);
            stack.push((level + 1, &index * Integer::from(arity) + Integer::from(digit), part));
        }
    }
    Some(leaves)
}

/// The bound, if there is one, that shows that no row below a node is above the limit.
fn closed<T: Number, const K: usize>(
    descent: &Descent<'_, T, K>,
    space: &mut WorkingMemory<T, K>,
    rows: &[Vec<T>; K],
    left: usize,
    limit: &T,
) -> Option<Closed> {
    let mut bounds = descent.largest(rows, left);
    let lines = descent.lines(space, rows, left, &mut bounds);
    if lines.is_some_and(|lines| lines.bound <= *limit) {
        return Some(Closed::Line);
    }
    (product(&bounds) <= *limit).then_some(Closed::Largest)
}
