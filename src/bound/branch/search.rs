//! The problem of a search, and the width of its integers.

use super::descent::Descent;
use super::estimate::{Place, margin};
use super::leaf::Leaf;
use super::number::Number;
use super::scaled::Scaled;
use super::sweep::Search;
use super::wide::Wide;
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
    /// The greatest product of the row sums of the c-th powers over a common row, or `None`
    /// when the work, products of words, does not suffice.
    ///
    /// The integers are of the least width that is proven to hold all of them.
    pub(super) fn greatest(&self, work: &mut u64) -> Option<Greatest> {
        if self.levels == 0 {
            return Some(Greatest { value: Integer::one(), class: Integer::zero(), split: 0 });
        }
        self.dispatch(work, GreatestRow)
    }

    fn dispatch<R: Run<K>>(&self, work: &mut u64, run: R) -> Option<R::Output> {
        let bits = self.bits();
        let narrow = self.operators.iter().all(|operator| operator.largest().to_i64().is_some());
        match bits {
            0..=126 if narrow => run.run(Search::new(Descent::<i128, K>::new(self, 2)?, work)),
            0..=254 if narrow => run.run(Search::new(Descent::<Wide<4>, K>::new(self, 4)?, work)),
            0..=510 if narrow => run.run(Search::new(Descent::<Wide<8>, K>::new(self, 8)?, work)),
            0..=1022 if narrow => {
                run.run(Search::new(Descent::<Wide<16>, K>::new(self, 16)?, work))
            }
            0..=2046 if narrow => {
                run.run(Search::new(Descent::<Wide<32>, K>::new(self, 32)?, work))
            }
            _ => run.run(Search::new(Descent::<Integer, K>::new(self, bits / 64 + 1)?, work)),
        }
    }

    /// The binary digits of every number of a search: indices and classes, and the products of
    /// the bounds of the operators.
    fn bits(&self) -> u64 {
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

    /// The leaves of a tree that shows that no row is greater than this one, in the order of
    /// their indices.
    pub(super) fn leaves(&self, greatest: &Greatest, work: &mut u64) -> Option<Vec<Leaf>> {
        self.dispatch(work, Leaves(&greatest.value))
    }
}

/// What is done with a search, whatever its numbers.
trait Run<const K: usize> {
    type Output;
    fn run<T: Number>(self, search: Search<'_, T, K>) -> Option<Self::Output>;
}

struct GreatestRow;

impl<const K: usize> Run<K> for GreatestRow {
    type Output = Greatest;
    fn run<T: Number>(self, search: Search<'_, T, K>) -> Option<Greatest> {
        search.run()
    }
}

struct Leaves<'a>(&'a Integer);

impl<const K: usize> Run<K> for Leaves<'_> {
    type Output = Vec<Leaf>;
    fn run<T: Number>(self, search: Search<'_, T, K>) -> Option<Vec<Leaf>> {
        search.leaves(self.0)
    }
}
