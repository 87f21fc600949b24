//! The problem of a search, and what it finds.

use super::estimate::{Place, margin};
use super::scaled::Scaled;
use crate::exact::Integer;
use std::num::NonZero;
use std::sync::LazyLock;
use std::thread;

/// What bounds the rows that are m levels below a node, for one m.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    /// fraction·q^m times an upper bound of ‖E^m‖.
    pub(super) total: Integer,
    /// Where the rows of E sum to 1.
    pub(super) place: Option<Place<Integer>>,
}

/// The greatest row, and the effort.
#[derive(Clone, Debug)]
pub(super) struct Greatest {
    /// The greatest product of the row sums, times the powers of the denominators.
    pub(super) value: Integer,
    /// The least residue class that has it.
    pub(super) class: Integer,
    /// The nodes that were split.
    pub(super) split: u64,
}

/// What a search works on.
pub(super) struct Problem<'a, const K: usize> {
    pub(super) operators: [&'a Scaled; K],
    /// For m = 0, …, c − 1.
    pub(super) reach: [&'a [Reach]; K],
    pub(super) levels: u32,
    pub(super) threads: usize,
}

/// How many threads a search may run on.
pub(super) fn threads() -> usize {
    static THREADS: LazyLock<usize> =
        LazyLock::new(|| thread::available_parallelism().map_or(1, NonZero::get).min(8));
    *THREADS
}

impl<const K: usize> Problem<'_, K> {
    /// The binary digits of every number of a search: indices and classes, and the products of
    /// the bounds of the operators.
    pub(super) fn bits(&self) -> u64 {
        let classes = Integer::from(self.operators[0].arity).pow(self.levels).bits() + 2;
        let values = self.operators.iter().zip(self.reach).map(|(operator, reach)| {
            let reach = &reach[..self.levels as usize];
            // The entries of level l are at most M·q^{l−1}·‖E^{l−1}‖, M the largest absolute row
            // sum of qE; c − l levels are left.
            let bits = reach.iter().zip(reach.iter().rev()).map(|(upper, lower)| {
                (&upper.total * &lower.total).bits() - operator.fraction.bits() + 1
            });
            bits.max().unwrap_or(0) + operator.largest().bits() + margin(operator.size)
        });
        values.sum::<u64>().max(classes)
    }
}
