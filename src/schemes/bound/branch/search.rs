//! The order in which the nodes of a search are split.
//!
//! Several nodes are split at a time, and all are compared with the best row found before.
//! So the tree of a search does not depend on the number of threads.

use super::descent::{Best, Descent, Node, WorkingMemory};
use super::number::Number;
use super::problem::Greatest;
use crate::cores::together;

/// The number of nodes that are split at a time: until the first row is found, and after
/// that.
const FIRST: usize = 4;
const CHUNK: usize = 8;

/// After this many splits per level, beam searches of growing width are run.
const PATIENCE: u64 = 32;

/// The widths of the beam searches. They are run in this order until one leaves out no
/// node.
const WIDTHS: [usize; 3] = [64, 512, 4096];

/// A width is used only if the parts of one level cost at most this many products of words.
/// Their memory in words is at most a quarter of their cost.
const LEVEL: u64 = 1 << 25;

/// The least work, in products of words, for each thread.
const SHARE: u64 = 1 << 18;

/// The state of a search.
pub(super) struct Search<'a, T: Number, const K: usize> {
    descent: Descent<'a, T, K>,
    /// The number of products of words that may still be computed.
    work: &'a mut u64,
    /// One space for each thread.
    spaces: Vec<WorkingMemory<T, K>>,
    best: Option<Best<T>>,
    splits: u64,
}

impl<'a, T: Number, const K: usize> Search<'a, T, K> {
    pub(super) fn new(descent: Descent<'a, T, K>, work: &'a mut u64) -> Search<'a, T, K> {
        let spaces = (0..descent.problem.threads).map(|_| descent.space()).collect();
        Search { descent, work, spaces, best: None, splits: 0 }
    }

    /// The greatest row; `None` when the work does not suffice, or the budget is stopped.
    pub(super) fn run(mut self) -> Option<Greatest> {
        let mut complete = self.exhaust(PATIENCE * u64::from(self.descent.problem.levels))?;
        for width in WIDTHS {
            complete = complete || self.cost(width) <= LEVEL && self.beam(width)?;
        }
        if !complete {
            self.exhaust(u64::MAX)?;
        }
        let best = self.best?;
        let (value, class) = (best.value.to_integer(), best.class.0.to_integer());
        Some(Greatest { value, class, split: self.splits })
    }

    /// Splits all nodes that are not closed, the latest first. Returns `false` if it
    /// stops because more than `most` nodes have been split.
    fn exhaust(&mut self, most: u64) -> Option<bool> {
        let mut stack = vec![self.descent.root()];
        while !stack.is_empty() {
            if self.splits > most {
                return Some(false);
            }
            let count = if self.best.is_some() { CHUNK } else { FIRST };
            let mut nodes = stack.split_off(stack.len().saturating_sub(count));
            if let Some(best) = &self.best {
                nodes.retain(|node| node.level == 0 || !best.closes(&node.bound, &node.class));
            }
            let mut parts = self.split(nodes)?;
            parts.sort_by(|a, b| (&a.promise, &b.class).cmp(&(&b.promise, &a.class)));
            stack.append(&mut parts);
        }
        Some(true)
    }

    /// A beam search: it goes from level to level, and keeps the `width` most promising nodes
    /// of each. Returns whether it left out no node, so that the search is complete.
    fn beam(&mut self, width: usize) -> Option<bool> {
        let (mut nodes, mut complete) = (vec![self.descent.root()], true);
        while !nodes.is_empty() {
            nodes = self.split(nodes)?;
            if nodes.len() > width {
                complete = false;
                // The mean of the promise and the bound, times 2.
                let key = |node: &Node<T, K>| node.promise.clone().plus(&node.bound);
                nodes.sort_by(|a, b| (key(b), &a.class).cmp(&(key(a), &b.class)));
                nodes.truncate(width);
            }
        }
        Some(complete)
    }

    /// The cost of the parts of `nodes` nodes, in products of words.
    fn cost(&self, nodes: usize) -> u64 {
        let parts = (nodes * self.descent.problem.operators[0].arity) as u64;
        parts.saturating_mul(self.descent.cost)
    }

    /// The parts of these nodes that are not closed. Also updates the best row.
    fn split(&mut self, nodes: Vec<Node<T, K>>) -> Option<Vec<Node<T, K>>> {
        if self.descent.problem.budget.is_stopped() {
            return None;
        }
        let cost = self.cost(nodes.len());
        *self.work = self.work.checked_sub(cost)?;
        self.splits += nodes.len() as u64;
        let threads = usize::try_from(cost / SHARE).unwrap_or(usize::MAX);
        let share = nodes.len().div_ceil(threads.clamp(1, self.spaces.len())).max(1);
        let (descent, best) = (&self.descent, self.best.as_ref());
        let tasks = nodes
            .chunks(share)
            .zip(&mut self.spaces)
            .map(|(nodes, space)| move || descent.split(space, nodes, best));
        let results = together(tasks);
        let mut rows = nodes.into_iter().map(|node| node.rows);
        for space in &mut self.spaces {
            space.pool.extend(rows.by_ref().take(share));
        }
        let mut parts = Vec::new();
        for (more, row) in results {
            parts.extend(more);
            self.best = self.best.take().max(row);
        }
        Some(parts)
    }
}
