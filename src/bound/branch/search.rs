//! Branch and bound over the rows of a power.

use super::estimate::{Estimator, PLACES, Place, margin};
use super::leaf::{Closed, Leaf};
use super::number::Number;
use super::scaled::Scaled;
use super::tree::Tree;
use super::wide::Wide;
use crate::exact::Integer;
use std::cell::Cell;
use std::cmp::Reverse;

/// What bounds the rows that are m levels below a node, for one m.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    /// 2^PLACES·q^m times an upper bound of ‖E^m‖.
    pub(super) total: Integer,
    /// Where the rows of E sum to 1.
    pub(super) place: Option<Place>,
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
    /// The products of words that may still be computed.
    pub(super) work: &'a Cell<u64>,
}

impl<const K: usize> Problem<'_, K> {
    /// The greatest product of the row sums of the c-th powers over a common row, or `None`
    /// when the work does not suffice.
    ///
    /// The integers are of the least width that is proven to hold all of them.
    pub(super) fn greatest(&self) -> Option<Greatest> {
        if self.levels == 0 {
            return Some(Greatest { value: Integer::one(), class: Integer::zero(), split: 0 });
        }
        self.dispatch(GreatestRow)
    }

    fn dispatch<R: Run<K>>(&self, run: R) -> Option<R::Output> {
        let bits = self.operators.iter().map(|operator| bits(operator, self.levels));
        let bits = bits.max().unwrap_or(0);
        let narrow = self.operators.iter().all(|operator| operator.largest().to_i64().is_some());
        match bits {
            0..=126 if narrow => run.run(Search::<i128, K>::new(self, 2)?),
            0..=254 if narrow => run.run(Search::<Wide<4>, K>::new(self, 4)?),
            0..=510 if narrow => run.run(Search::<Wide<8>, K>::new(self, 8)?),
            0..=1022 if narrow => run.run(Search::<Wide<16>, K>::new(self, 16)?),
            0..=2046 if narrow => run.run(Search::<Wide<32>, K>::new(self, 32)?),
            _ => run.run(Search::<Integer, K>::new(self, bits / 64 + 1)?),
        }
    }
}

/// The binary digits of every number of a search: the entries of q^l·E^l are at most M^l, M
/// the largest absolute row sum of qE.
fn bits(operator: &Scaled, levels: u32) -> u64 {
    operator.largest().pow(levels).bits() + margin(operator.size)
}

impl Problem<'_, 1> {
    /// The leaves of a tree that shows that no row is greater than this one, in the order of
    /// their indices.
    pub(super) fn leaves(&self, greatest: &Greatest) -> Option<Vec<Leaf>> {
        self.dispatch(Leaves(&greatest.value))
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

impl Run<1> for Leaves<'_> {
    type Output = Vec<Leaf>;
    fn run<T: Number>(self, search: Search<'_, T, 1>) -> Option<Vec<Leaf>> {
        search.leaves(self.0)
    }
}

/// A node whose bound does not close it.
struct Node<T, const K: usize> {
    /// 2^{PLACES·K}·q^c times the bound, q the product of the denominators.
    bound: Integer,
    /// The same by its own rows alone: of several with one bound, what is likely to be greater.
    promise: Integer,
    /// The least class below it.
    class: Reverse<Integer>,
    level: u32,
    index: Integer,
    rows: [Vec<T>; K],
}

struct Search<'a, T: Number, const K: usize> {
    problem: &'a Problem<'a, K>,
    trees: [Tree<T>; K],
    estimators: [Estimator<T>; K],
    /// For each operator q^0, q^1, …, q^c, and n^0, …, n^c.
    scales: [Vec<Integer>; K],
    classes: Vec<Integer>,
    /// The class of index 0 of level c.
    start: Integer,
    /// The value and its class, and 2^{PLACES·K} times the value.
    best: Option<(Integer, Integer)>,
    threshold: Integer,
    /// What parts cost, and rows to be written again.
    cost: u64,
    pool: Vec<[Vec<T>; K]>,
}

impl<'a, T: Number, const K: usize> Search<'a, T, K> {
    fn new(problem: &'a Problem<'a, K>, words: u64) -> Option<Search<'a, T, K>> {
        let mut trees = Vec::with_capacity(K);
        for operator in problem.operators {
            trees.push(Tree::new(operator)?);
        }
        let trees: [Tree<T>; K] = trees.try_into().ok()?;
        let powers = |base: &Integer| -> Vec<Integer> {
            let next = |power: &Integer| Some(power * base);
            std::iter::successors(Some(Integer::one()), next)
                .take(problem.levels as usize + 1)
                .collect()
        };
        let classes = powers(&Integer::from(problem.operators[0].arity));
        // Row r at the offset of R is row r + moved·(n + … + n^c) at this one.
        let shift: Integer = classes[1..].iter().sum::<Integer>() * &problem.operators[0].moved;
        let start = (-shift).div_rem_floor(&classes[problem.levels as usize]).1;
        Some(Search {
            estimators: trees.each_ref().map(|tree| Estimator::new(tree.size)),
            scales: problem.operators.map(|operator| powers(&operator.denominator)),
            cost: trees
                .iter()
                .map(|tree| (tree.cost() + 4 * (tree.size * tree.size) as u64) * words)
                .sum(),
            problem,
            trees,
            classes,
            start,
            best: None,
            threshold: Integer::from(-1),
            pool: Vec::new(),
        })
    }

    fn run(mut self) -> Option<Greatest> {
        let root = Node {
            bound: Integer::zero(),
            promise: Integer::zero(),
            class: Reverse(Integer::zero()),
            level: 0,
            index: Integer::zero(),
            rows: self.trees.each_ref().map(Tree::root),
        };
        let mut split = 0;
        let mut stack = vec![root];
        while let Some(node) = stack.pop() {
            if node.level == 0 || !self.closes(&node.bound, &node.class.0) {
                split += 1;
                let parts = self.split(&node)?;
                stack.extend(parts);
            }
            self.pool.push(node.rows);
        }
        let (value, class) = self.best?;
        Some(Greatest { value, class, split })
    }

    /// Whether no row under this bound is greater, or as great and of a lower class.
    fn closes(&self, bound: &Integer, class: &Integer) -> bool {
        let best = self.best.as_ref();
        match bound.cmp(&self.threshold) {
            std::cmp::Ordering::Less => true,
            std::cmp::Ordering::Equal => best.is_some_and(|(_, least)| class >= least),
            std::cmp::Ordering::Greater => false,
        }
    }

    /// The parts of a node that are not closed, the most promising one last.
    fn split(&mut self, node: &Node<T, K>) -> Option<Vec<Node<T, K>>> {
        let arity = self.problem.operators[0].arity;
        let level = node.level + 1;
        let mut parts = Vec::with_capacity(arity);
        for digit in 0..arity {
            self.spend()?;
            let index = &node.index * &self.classes[1] + Integer::from(digit);
            let class = Reverse(self.least_class(&index, level));
            let mut rows = self.pool.pop().unwrap_or_else(|| self.trees.each_ref().map(Tree::root));
            for ((tree, from), to) in self.trees.iter().zip(&node.rows).zip(&mut rows) {
                tree.part(digit, from, to);
            }
            let (bound, promise) = (Integer::zero(), Integer::zero());
            let mut part = Node { bound, promise, class, level, index, rows };
            let last = level == self.problem.levels;
            if last {
                self.value(&part);
            } else {
                self.estimate(&mut part, (level > 1).then_some(&node.bound));
            }
            if last || self.closes(&part.bound, &part.class.0) {
                self.pool.push(part.rows);
            } else {
                parts.push(part);
            }
        }
        parts.sort_by(|a, b| {
            (&a.bound, &a.promise, &a.class).cmp(&(&b.bound, &b.promise, &b.class))
        });
        Some(parts)
    }

    fn spend(&self) -> Option<()> {
        let work = self.problem.work;
        work.set(work.get().checked_sub(self.cost)?);
        Some(())
    }

    /// The least class of the rows below an index.
    fn least_class(&self, index: &Integer, level: u32) -> Integer {
        let below = &self.classes[(self.problem.levels - level) as usize];
        let all = &self.classes[self.problem.levels as usize];
        let first = (index * below + &self.start).div_rem_floor(all).1;
        if &first + below > *all { Integer::zero() } else { first }
    }

    /// Takes the row of a node of the last level into account.
    fn value(&mut self, node: &Node<T, K>) {
        let norms =
            self.trees.iter().zip(&node.rows).map(|(tree, rows)| tree.norm(rows).to_integer());
        let value = norms.reduce(|product, norm| product * norm).expect("at least one operator");
        let class = &node.class.0;
        let better = self
            .best
            .as_ref()
            .is_none_or(|(best, least)| value > *best || value == *best && class < least);
        if better {
            self.threshold = value.shifted_left(Self::places());
            self.best = Some((value, class.clone()));
        }
    }

    fn places() -> u32 {
        PLACES * u32::try_from(K).expect("one or two operators")
    }

    /// Bounds the rows below a node, from its own rows and the bound of the node above it.
    fn estimate(&mut self, node: &mut Node<T, K>, above: Option<&Integer>) {
        let left = (self.problem.levels - node.level) as usize;
        let product = |bounds: &[Integer; K]| bounds.iter().fold(Integer::one(), |x, y| x * y);
        // The cheaper bound first.
        let mut bounds: [Integer; K] =
            std::array::from_fn(|k| self.largest(k, &node.rows[k], left));
        node.bound = product(&bounds);
        if self.closes(&node.bound, &node.class.0) {
            return;
        }
        let mut promises = bounds.clone();
        for k in 0..K {
            if let Some(line) = self.line(k, &node.rows[k], left) {
                bounds[k] = line.clone().min(bounds[k].clone());
                promises[k] = line;
            }
        }
        node.bound = product(&bounds);
        node.promise = product(&promises);
        if let Some(above) = above.filter(|above| **above < node.bound) {
            node.bound.clone_from(above);
        }
    }

    /// The bound by the line through two rows of a node, m levels left.
    fn line(&mut self, k: usize, rows: &[T], left: usize) -> Option<Integer> {
        let place = self.problem.reach[k][left].place.as_ref()?;
        let bound = self.estimators[k].bound(&self.trees[k], rows, place);
        Some(bound.scaled(place, &self.scales[k][left]))
    }

    /// The bound by its largest row and ‖E^m‖.
    fn largest(&self, k: usize, rows: &[T], left: usize) -> Integer {
        self.trees[k].largest(rows).to_integer() * &self.problem.reach[k][left].total
    }
}

impl<T: Number> Search<'_, T, 1> {
    /// A cover of all rows that shows the greatest one: each leaf is a row, or bounded by its
    /// own rows.
    fn leaves(mut self, greatest: &Integer) -> Option<Vec<Leaf>> {
        let limit = greatest.shifted_left(PLACES);
        let mut leaves = Vec::new();
        let mut stack = vec![(0, Integer::zero(), self.trees[0].root())];
        while let Some((level, index, rows)) = stack.pop() {
            let left = (self.problem.levels - level) as usize;
            let closed = if left == 0 {
                Some(Closed::Row)
            } else if level == 0 {
                None
            } else if self.line(0, &rows, left).is_some_and(|bound| bound <= limit) {
                Some(Closed::Line)
            } else {
                (self.largest(0, &rows, left) <= limit).then_some(Closed::Largest)
            };
            if let Some(closed) = closed {
                leaves.push(Leaf { level, index, closed });
                continue;
            }
            for digit in (0..self.problem.operators[0].arity).rev() {
                self.spend()?;
                let mut part = self.trees[0].root();
                self.trees[0].part(digit, &rows, &mut part);
                stack.push((level + 1, &index * &self.classes[1] + Integer::from(digit), part));
            }
        }
        Some(leaves)
    }
}
