//! Chooses the width of the integers of a search.

use super::cover::cover;
use super::descent::Descent;
use super::number::Number;
use super::problem::{Greatest, Problem};
use super::search::Search;
use super::search_tree::Leaf;
use super::wide::Wide;
use crate::exact::Integer;

impl<const K: usize> Problem<'_, K> {
    /// The greatest value over all rows of the product of the operators' absolute row sums
    /// in their c-th powers. `None` when the work, in products of words, does not suffice.
    ///
    /// All integers have the least of the available widths that provably suffices.
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
            0..=126 if narrow => run.run(Descent::<i128, K>::new(self, 2)?, work),
            0..=254 if narrow => run.run(Descent::<Wide<4>, K>::new(self, 4)?, work),
            0..=510 if narrow => run.run(Descent::<Wide<8>, K>::new(self, 8)?, work),
            0..=1022 if narrow => run.run(Descent::<Wide<16>, K>::new(self, 16)?, work),
            0..=2046 if narrow => run.run(Descent::<Wide<32>, K>::new(self, 32)?, work),
            _ => run.run(Descent::<Integer, K>::new(self, bits / 64 + 1)?, work),
        }
    }

    /// The leaves of a tree that proves that no row is greater than `greatest`, in the order
    /// of their indices.
    pub(super) fn leaves(&self, greatest: &Greatest, work: &mut u64) -> Option<Vec<Leaf>> {
        self.dispatch(work, Leaves(&greatest.value))
    }
}

/// A computation on a problem in integers of any width.
trait Run<const K: usize> {
    type Output;
    fn run<T: Number>(self, descent: Descent<'_, T, K>, work: &mut u64) -> Option<Self::Output>;
}

struct GreatestRow;

impl<const K: usize> Run<K> for GreatestRow {
    type Output = Greatest;
    fn run<T: Number>(self, descent: Descent<'_, T, K>, work: &mut u64) -> Option<Greatest> {
        Search::new(descent, work).run()
    }
}

struct Leaves<'a>(&'a Integer);

impl<const K: usize> Run<K> for Leaves<'_> {
    type Output = Vec<Leaf>;
    fn run<T: Number>(self, descent: Descent<'_, T, K>, work: &mut u64) -> Option<Vec<Leaf>> {
        cover(&descent, self.0, work)
    }
}
