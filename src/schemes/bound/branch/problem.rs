//! The input and the result of a search.

use super::estimate::{Place, margin};
use super::scaled::Scaled;
use crate::bound::budget::Budget;
use crate::cores::cores;
use crate::exact::Integer;

/// The data that bound the rows m levels below a node, for one m.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    /// fraction·q^m times an upper bound of ‖E^m‖.
    pub(super) total: Integer,
    /// The data for bounds by lines; present only if the rows of E sum to 1.
    pub(super) place: Option<Place<Integer>>,
}

impl Reach {
    /// These data without bounds of single entries.
    pub(super) fn without_entries(&self) -> Reach {
        let place = self.place.as_ref().map(Place::without_entries);
        Reach { total: self.total.clone(), place }
    }
}

/// The greatest row, and the effort of the search.
#[derive(Clone, Debug)]
pub(super) struct Greatest {
    /// The greatest product of absolute row sums, times q^c for each operator.
    pub(super) value: Integer,
    /// The least residue class that attains it.
    pub(super) class: Integer,
    /// The number of nodes that were split.
    pub(super) split: u64,
}

/// The input of a search.
pub(super) struct Problem<'a, const K: usize> {
    pub(super) operators: [&'a Scaled; K],
    /// For each operator, the entries for m = 0, …, c − 1.
    pub(super) reach: [&'a [Reach]; K],
    pub(super) levels: u32,
    pub(super) threads: usize,
    /// The search ends when this is stopped.
    pub(super) budget: &'a Budget,
}

/// The greatest number of threads of a search.
pub(super) fn threads() -> usize {
    cores().min(8)
}

impl<const K: usize> Problem<'_, K> {
    /// A number of binary digits that suffices for every number of a search: indices, classes,
    /// and products of the bounds of the operators.
    pub(super) fn bits(&self) -> u64 {
        let classes = Integer::from(self.operators[0].arity).pow(self.levels).bits() + 2;
        let values = self.operators.iter().zip(self.reach).map(|(operator, reach)| {
            let reach = &reach[..self.levels as usize];
            // The entries of level l are at most M·q^{l−1}·‖E^{l−1}‖, where M is the largest
            // absolute row sum of qE; c − l levels are left.
            let bits = reach.iter().zip(reach.iter().rev()).map(|(upper, lower)| {
                (&upper.total * &lower.total).bits() - operator.fraction.bits() + 1
            });
            bits.max().unwrap_or(0)
                + operator.largest().bits()
                + margin(operator.size)
                + u64::from(operator.size.ilog2())
                + 1
        });
        values.sum::<u64>().max(classes)
    }
}
