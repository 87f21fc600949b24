//! Nodes, their parts, and bounds of the rows below nodes.

use super::estimate::{Estimator, Line, Place};
use super::number::Number;
use super::problem::Problem;
use super::tree::Tree;
use crate::exact::Integer;
use std::cmp::{Ordering, Reverse};

/// A node that is not closed.
pub(super) struct Node<T, const K: usize> {
    /// An upper bound of the norm, or product of norms, of every row below the node,
    /// times the product of fraction·q^c over the operators.
    pub(super) bound: T,
    /// An estimate of the greatest value below the node, at the scale of `bound`. It only
    /// decides the order of the search.
    pub(super) promise: T,
    /// The least residue class of the rows below the node.
    pub(super) class: T,
    pub(super) level: u32,
    pub(super) index: T,
    pub(super) rows: [Vec<T>; K],
}

/// The bounds of the rows below a node that the lines through two of its rows give.
pub(super) struct Lines<T> {
    pub(super) bound: T,
    /// The greatest norm, or product of norms, at the ends of the lines themselves.
    promise: T,
}

/// A row. The best of several rows has the greatest value, and of equal values the least
/// class.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Best<T> {
    pub(super) value: T,
    pub(super) class: Reverse<T>,
    /// The product of the operators' fractions times the value: the scale of
    /// [`Node::bound`].
    threshold: T,
}

/// The parts of some nodes that are not closed, and the best row if the parts are rows.
pub(super) type Parts<T, const K: usize> = (Vec<Node<T, K>>, Option<Best<T>>);

/// The data that bound the rows m levels below a node, for one operator and one m.
struct Below<T> {
    total: T,
    place: Option<Place<T>>,
}

/// A problem in integers of one width.
pub(super) struct Descent<'a, T: Number, const K: usize> {
    pub(super) problem: &'a Problem<'a, K>,
    trees: [Tree<T>; K],
    below: [Vec<Below<T>>; K],
    /// n^0, …, n^c.
    classes: Vec<T>,
    /// The class of index 0 of level c.
    start: T,
    /// The product of the operators' fractions.
    fraction: T,
    /// The cost of a part, in products of words.
    pub(super) cost: u64,
}

/// Working memory for splitting nodes, with rows for reuse.
pub(super) struct WorkingMemory<T, const K: usize> {
    estimators: [Estimator<T>; K],
    pub(super) pool: Vec<[Vec<T>; K]>,
}

impl<T: Number> Best<T> {
    /// Whether no row with this upper bound and a class of at least `class` can be better
    /// than this row.
    pub(super) fn closes(&self, bound: &T, class: &T) -> bool {
        match bound.cmp(&self.threshold) {
            Ordering::Less => true,
            Ordering::Equal => *class >= self.class.0,
            Ordering::Greater => false,
        }
    }
}

impl<'a, T: Number, const K: usize> Descent<'a, T, K> {
    /// `None` if a coefficient does not fit.
    pub(super) fn new(problem: &'a Problem<'a, K>, words: u64) -> Option<Descent<'a, T, K>> {
        let trees = problem.operators.iter().map(|operator| Tree::new(operator));
        let trees: [Tree<T>; K] = trees.collect::<Option<Vec<_>>>()?.try_into().ok()?;
        let arity = Integer::from(problem.operators[0].arity);
        let classes: Vec<Integer> = (0..=problem.levels).map(|level| arity.pow(level)).collect();
        // Row r at the offset of R is row r + moved·(n + … + n^c) at this one.
        let shift: Integer = classes[1..].iter().sum::<Integer>() * &problem.operators[0].moved;
        let start = (-shift).div_rem_floor(&classes[problem.levels as usize]).1;
        let cost = |tree: &Tree<T>| (tree.cost() + 4 * (tree.size * tree.size) as u64) * words;
        Some(Descent {
            below: problem.reach.map(|reach| {
                let below = reach[..problem.levels as usize].iter().map(|reach| Below {
                    total: T::from_integer(&reach.total),
                    place: reach.place.as_ref().map(Place::fixed),
                });
                below.collect()
            }),
            cost: trees.iter().map(cost).sum(),
            problem,
            trees,
            classes: classes.iter().map(T::from_integer).collect(),
            start: T::from_integer(&start),
            fraction: problem.operators.iter().fold(T::one(), |product, operator| {
                product.product(&T::from_integer(&operator.fraction))
            }),
        })
    }

    pub(super) fn space(&self) -> WorkingMemory<T, K> {
        let estimators = self.trees.each_ref().map(|tree| Estimator::new(tree.size));
        WorkingMemory { estimators, pool: Vec::new() }
    }

    pub(super) fn root(&self) -> Node<T, K> {
        Node {
            bound: T::zero(),
            promise: T::zero(),
            class: T::zero(),
            level: 0,
            index: T::zero(),
            rows: self.trees.each_ref().map(Tree::root),
        }
    }

    /// The parts of these nodes that are not closed, and the greatest row, if they are of the
    /// last level.
    pub(super) fn split(
        &self,
        space: &mut WorkingMemory<T, K>,
        nodes: &[Node<T, K>],
        best: Option<&Best<T>>,
    ) -> Parts<T, K> {
        let mut parts = (Vec::new(), None);
        for node in nodes {
            self.split_one(space, node, best, &mut parts);
        }
        parts
    }

    fn split_one(
        &self,
        space: &mut WorkingMemory<T, K>,
        node: &Node<T, K>,
        best: Option<&Best<T>>,
        (parts, greatest): &mut Parts<T, K>,
    ) {
        let level = node.level + 1;
        let first = node.index.product(&self.classes[1]);
        for (digit, step) in (0..self.problem.operators[0].arity).zip(0..) {
            let index = T::times(&T::one(), step).plus(&first);
            let class = self.least_class(&index, level);
            let rows = space.pool.pop();
            let mut rows = rows.unwrap_or_else(|| self.trees.each_ref().map(Tree::root));
            self.part(digit, &node.rows, &mut rows);
            let (bound, promise) = (T::zero(), T::zero());
            let mut part = Node { bound, promise, class, level, index, rows };
            if level == self.problem.levels {
                *greatest = greatest.take().max(Some(self.row(&part)));
            } else if !self.estimate(space, &mut part, (level > 1).then_some(&node.bound), best) {
                parts.push(part);
                continue;
            }
            space.pool.push(part.rows);
        }
    }

    /// Writes the rows of the part with this digit into `part`.
    pub(super) fn part(&self, digit: usize, rows: &[Vec<T>; K], part: &mut [Vec<T>; K]) {
        for ((tree, from), to) in self.trees.iter().zip(rows).zip(part) {
            tree.part(digit, from, to);
        }
    }

    /// The least class of the rows below the node of this index and level.
    fn least_class(&self, index: &T, level: u32) -> T {
        let below = &self.classes[(self.problem.levels - level) as usize];
        let all = &self.classes[self.problem.levels as usize];
        let first = index.product(below).plus(&self.start);
        let first = if first < *all { first } else { first.minus(all) };
        if first.clone().plus(below) > *all { T::zero() } else { first }
    }

    /// The row of a node of the last level.
    fn row(&self, node: &Node<T, K>) -> Best<T> {
        let norms = self.trees.iter().zip(&node.rows).map(|(tree, rows)| tree.norm(rows));
        let value = norms.reduce(|x, y| x.product(&y)).expect("at least one operator");
        Best { threshold: self.limit(&value), value, class: Reverse(node.class.clone()) }
    }

    /// A norm, or product of norms, at the scale of the bounds.
    pub(super) fn limit(&self, value: &T) -> T {
        value.product(&self.fraction)
    }

    /// Sets the bound and the promise of a node, from its own rows and the bound of the
    /// node above it. Returns whether the bound closes the node.
    fn estimate(
        &self,
        space: &mut WorkingMemory<T, K>,
        node: &mut Node<T, K>,
        above: Option<&T>,
        best: Option<&Best<T>>,
    ) -> bool {
        let closes =
            |node: &Node<T, K>| best.is_some_and(|best| best.closes(&node.bound, &node.class));
        let left = (self.problem.levels - node.level) as usize;
        // The cheaper bound first.
        let mut bounds = self.largest(&node.rows, left);
        node.bound = product(&bounds);
        if closes(node) {
            return true;
        }
        let lines = self.lines(space, &node.rows, left, &mut bounds);
        node.bound = product(&bounds);
        node.promise = node.bound.clone();
        if let Some(lines) = lines {
            node.bound = node.bound.clone().min(lines.bound);
            node.promise = lines.promise;
        }
        if let Some(above) = above.filter(|above| **above < node.bound) {
            node.bound.clone_from(above);
        }
        closes(node)
    }

    /// The bounds by lines for a node with m = `left` levels left. Also lowers the bound of each
    /// operator in `bounds`. `None` if an operator has no line.
    pub(super) fn lines(
        &self,
        space: &mut WorkingMemory<T, K>,
        rows: &[Vec<T>; K],
        left: usize,
        bounds: &mut [T; K],
    ) -> Option<Lines<T>> {
        let mut lines: Vec<Line<T>> = Vec::with_capacity(K);
        for (k, bound) in bounds.iter_mut().enumerate() {
            let place = self.below[k][left].place.as_ref()?;
            let (tree, rows) = (&self.trees[k], &rows[k]);
            let line = space.estimators[k].line(tree, rows, place);
            let greatest = line.greatest();
            if greatest < *bound {
                *bound = greatest;
            }
            lines.push(if K > 1 { Estimator::strayed(line, tree, rows, place) } else { line });
        }
        let bound = match &lines[..] {
            [first, second] => first.product(second),
            _ => lines[0].greatest(),
        };
        Some(Lines { bound, promise: Line::promise(&lines) })
    }

    /// For each operator, the norm of its largest row times the bound of ‖E^m‖, with m =
    /// `left`.
    pub(super) fn largest(&self, rows: &[Vec<T>; K], left: usize) -> [T; K] {
        let below = |k: usize| &self.below[k][left].total;
        std::array::from_fn(|k| self.trees[k].largest(&rows[k]).product(below(k)))
    }
}

pub(super) fn product<T: Number, const K: usize>(factors: &[T; K]) -> T {
    let (first, rest) = factors.split_first().expect("at least one operator");
    rest.iter().fold(first.clone(), |product, factor| product.product(factor))
}
