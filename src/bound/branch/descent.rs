//! Branch and bound over the rows of a power.

use super::estimate::{Estimator, Line, Place};
use super::number::Number;
use super::search::{Greatest, Problem};
use super::tree::Tree;
use crate::exact::Integer;
use std::cmp::Ordering;

/// After so many improvements a search looks for a great row with a beam of so many nodes.
const WANDERING: u32 = 8;
const BEAM: usize = 16;

/// A node whose bound does not close it.
struct Node<T, const K: usize> {
    /// The product of fraction·q^c of the operators, times the bound.
    bound: T,
    /// The same by its own rows alone: of several with one bound, what is likely to be greater.
    promise: T,
    /// The least class below it.
    class: T,
    level: u32,
    index: T,
    rows: [Vec<T>; K],
}

/// What bounds the rows m levels below a node, for one operator and one m.
struct Below<T> {
    total: T,
    place: Option<Place<T>>,
}

/// A search, with the space it works in.
pub(super) struct Search<'a, T: Number, const K: usize> {
    pub(super) problem: &'a Problem<'a, K>,
    pub(super) trees: [Tree<T>; K],
    estimators: [Estimator<T>; K],
    below: [Vec<Below<T>>; K],
    /// n^0, …, n^c.
    classes: Vec<T>,
    /// The class of index 0 of level c.
    start: T,
    /// What bounds are multiples of one part of, for rows of the last level.
    pub(super) fraction: T,
    /// The value and its class, and `fraction` times the value.
    best: Option<(T, T)>,
    threshold: T,
    /// How often a greater row was found.
    improvements: u32,
    splits: u64,
    /// What a part costs, and rows to be written again.
    cost: u64,
    pool: Vec<[Vec<T>; K]>,
}

impl<'a, T: Number, const K: usize> Search<'a, T, K> {
    /// `None` if a coefficient does not fit.
    pub(super) fn new(problem: &'a Problem<'a, K>, words: u64) -> Option<Search<'a, T, K>> {
        let trees = problem.operators.iter().map(|operator| Tree::new(operator));
        let trees: [Tree<T>; K] = trees.collect::<Option<Vec<_>>>()?.try_into().ok()?;
        let arity = Integer::from(problem.operators[0].arity);
        let classes: Vec<Integer> = (0..=problem.levels).map(|level| arity.pow(level)).collect();
        // Row r at the offset of R is row r + moved·(n + … + n^c) at this one.
        let shift: Integer = classes[1..].iter().sum::<Integer>() * &problem.operators[0].moved;
        let start = (-shift).div_rem_floor(&classes[problem.levels as usize]).1;
        let cost = |tree: &Tree<T>| (tree.cost() + 4 * (tree.size * tree.size) as u64) * words;
        Some(Search {
            estimators: trees.each_ref().map(|tree| Estimator::new(tree.size)),
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
            best: None,
            threshold: T::times(&T::one(), -1),
            improvements: 0,
            splits: 0,
            pool: Vec::new(),
        })
    }

    /// The greatest row; `None` when the work does not suffice.
    pub(super) fn run(mut self) -> Option<Greatest> {
        let mut beamed = false;
        let mut stack = vec![self.root()];
        while let Some(node) = stack.pop() {
            if node.level == 0 || !self.closes(&node.bound, &node.class) {
                let first = stack.len();
                self.split(&node, &mut stack)?;
                stack[first..].sort_by(|a, b| {
                    let least_class = || b.class.cmp(&a.class);
                    (&a.bound, &a.promise).cmp(&(&b.bound, &b.promise)).then_with(least_class)
                });
            }
            self.pool.push(node.rows);
            if self.improvements >= WANDERING && !beamed {
                beamed = true;
                self.beam()?;
            }
        }
        let (value, class) = self.best?;
        let (value, class) = (value.to_integer(), class.to_integer());
        Some(Greatest { value, class, split: self.splits })
    }

    /// Looks for a great row from level to level, keeping the nodes that promise most.
    fn beam(&mut self) -> Option<()> {
        let (mut beam, mut parts) = (vec![self.root()], Vec::new());
        while !beam.is_empty() {
            for node in beam.drain(..) {
                self.split(&node, &mut parts)?;
                self.pool.push(node.rows);
            }
            parts.sort_by(|a, b| b.promise.cmp(&a.promise).then_with(|| a.class.cmp(&b.class)));
            self.pool.extend(parts.drain(BEAM.min(parts.len())..).map(|part| part.rows));
            std::mem::swap(&mut beam, &mut parts);
        }
        Some(())
    }

    fn root(&self) -> Node<T, K> {
        Node {
            bound: T::zero(),
            promise: T::zero(),
            class: T::zero(),
            level: 0,
            index: T::zero(),
            rows: self.trees.each_ref().map(Tree::root),
        }
    }

    /// Whether no row under this bound is greater, or as great and of a lower class.
    fn closes(&self, bound: &T, class: &T) -> bool {
        match bound.cmp(&self.threshold) {
            Ordering::Less => true,
            Ordering::Equal => self.best.as_ref().is_some_and(|(_, least)| class >= least),
            Ordering::Greater => false,
        }
    }

    /// Adds the parts of a node that are not closed.
    fn split(&mut self, node: &Node<T, K>, parts: &mut Vec<Node<T, K>>) -> Option<()> {
        self.splits += 1;
        let level = node.level + 1;
        let first = node.index.product(&self.classes[1]);
        for (digit, step) in (0..self.problem.operators[0].arity).zip(0..) {
            self.spend()?;
            let index = T::times(&T::one(), step).plus(&first);
            let class = self.least_class(&index, level);
            let mut rows = self.pool.pop().unwrap_or_else(|| self.trees.each_ref().map(Tree::root));
            for ((tree, from), to) in self.trees.iter().zip(&node.rows).zip(&mut rows) {
                tree.part(digit, from, to);
            }
            let (bound, promise) = (T::zero(), T::zero());
            let mut part = Node { bound, promise, class, level, index, rows };
            let last = level == self.problem.levels;
            if last {
                self.value(&part);
            } else {
                self.estimate(&mut part, (level > 1).then_some(&node.bound));
            }
            if last || self.closes(&part.bound, &part.class) {
                self.pool.push(part.rows);
            } else {
                parts.push(part);
            }
        }
        Some(())
    }

    /// Takes the cost of a part from the work that is left.
    pub(super) fn spend(&self) -> Option<()> {
        let work = self.problem.work;
        work.set(work.get().checked_sub(self.cost)?);
        Some(())
    }

    /// The least class of the rows below an index.
    fn least_class(&self, index: &T, level: u32) -> T {
        let below = &self.classes[(self.problem.levels - level) as usize];
        let all = &self.classes[self.problem.levels as usize];
        let first = index.product(below).plus(&self.start);
        let first = if first < *all { first } else { first.minus(all) };
        if first.clone().plus(below) > *all { T::zero() } else { first }
    }

    /// Takes the row of a node of the last level into account.
    fn value(&mut self, node: &Node<T, K>) {
        let norms = self.trees.iter().zip(&node.rows).map(|(tree, rows)| tree.norm(rows));
        let value = norms.reduce(|x, y| x.product(&y)).expect("at least one operator");
        let better = self.best.as_ref().is_none_or(|(best, least)| {
            value.cmp(best).then_with(|| least.cmp(&node.class)).is_gt()
        });
        if better {
            self.threshold = value.product(&self.fraction);
            self.improvements += 1;
            self.best = Some((value, node.class.clone()));
        }
    }

    /// Bounds the rows below a node, from its own rows and the bound of the node above it.
    fn estimate(&mut self, node: &mut Node<T, K>, above: Option<&T>) {
        let left = (self.problem.levels - node.level) as usize;
        // The cheaper bound first.
        let mut bounds: [T; K] = std::array::from_fn(|k| self.largest(k, &node.rows[k], left));
        node.bound = product(&bounds);
        if self.closes(&node.bound, &node.class) {
            return;
        }
        let promise = self.promise(node, left, &mut bounds);
        node.bound = product(&bounds);
        if let Some(promise) = &promise {
            node.bound = node.bound.clone().min(promise.clone());
        }
        node.promise = promise.unwrap_or_else(|| node.bound.clone());
        if let Some(above) = above.filter(|above| **above < node.bound) {
            node.bound.clone_from(above);
        }
    }

    /// The bound of the rows below a node by the lines through two of its rows, which also
    /// improve the bounds of each operator; `None` if one has no line.
    fn promise(&mut self, node: &Node<T, K>, left: usize, bounds: &mut [T; K]) -> Option<T> {
        let mut promise: Option<(T, Line<T>)> = None;
        for (k, bound) in bounds.iter_mut().enumerate() {
            let place = self.below[k][left].place.as_ref()?;
            let (tree, rows) = (&self.trees[k], &node.rows[k]);
            let mut line = self.estimators[k].line(tree, rows, place);
            let greatest = line.greatest();
            if greatest < *bound {
                bound.clone_from(&greatest);
            }
            if K > 1 {
                line = Estimator::strayed(line, tree, rows, place);
            }
            let bound = promise.map_or(greatest, |(_, before)| before.product(&line));
            promise = Some((bound, line));
        }
        promise.map(|(bound, _)| bound)
    }

    /// The bound by the line through two rows of a node, m levels left.
    pub(super) fn line(&mut self, k: usize, rows: &[T], left: usize) -> Option<T> {
        let place = self.below[k][left].place.as_ref()?;
        Some(self.estimators[k].bound(&self.trees[k], rows, place))
    }

    /// The bound by its largest row and ‖E^m‖.
    pub(super) fn largest(&self, k: usize, rows: &[T], left: usize) -> T {
        self.trees[k].largest(rows).product(&self.below[k][left].total)
    }
}

fn product<T: Number, const K: usize>(factors: &[T; K]) -> T {
    let (first, rest) = factors.split_first().expect("at least one operator");
    rest.iter().fold(first.clone(), |product, factor| product.product(factor))
}
