//! Transport by way of rounded numbers: they find the heights, and an exact flow along a
//! forest proves that the heights are optimal.

use super::network::{Network, Transport, shortest};
use crate::exact::{Rational, Real};
use std::cmp::Reverse;

/// As [`transport_at_costs`](super::transport_at_costs), for numbers w whose exact
/// arithmetic is slow. `None` if the rounded problem gives wrong heights.
///
/// In general the heights P of the rounded problem are also optimal for the exact one. A
/// flow proves this if it carries w, uses only edges with |P_a − P_b| = c_e, and runs
/// downwards (complementary slackness). The flow is computed along a spanning forest of
/// these edges, where it is unique. The forest prefers edges with much flow in the
/// rounded problem.
///
/// Source: `proofs/THEOREMS.md`, 24.
pub(super) fn by_rounding<S: Real + Ord>(
    w: &[S],
    edges: &[(usize, usize)],
    costs: &[u32],
) -> Option<Transport<S>> {
    let mut rounded = S::rounded(w)?;
    let rest: i64 = rounded.iter().sum();
    *rounded.first_mut()? -= rest;
    let rounded: Vec<Rational> = rounded.into_iter().map(Rational::from).collect();
    let guess = shortest(&rounded, edges, costs)?;
    let forest = Forest::of(&guess, edges, costs, w.len());
    let flow = forest.flow(w, &guess.heights)?;
    Some(Network::carrying(flow, w.len(), edges, costs).found(costs))
}

/// A forest in a graph.
struct Forest<'a> {
    edges: &'a [(usize, usize)],
    /// The edges of the forest at each point.
    at: Vec<Vec<usize>>,
}

impl Forest<'_> {
    /// A spanning forest of the edges along which the heights differ by the cost. Edges
    /// with more flow are preferred.
    fn of<'a>(
        guess: &Transport<Rational>,
        edges: &'a [(usize, usize)],
        costs: &'a [u32],
        points: usize,
    ) -> Forest<'a> {
        let tight = |&e: &usize| {
            let (a, b) = edges[e];
            guess.heights[a].abs_diff(guess.heights[b]) == u64::from(costs[e])
        };
        let mut order: Vec<usize> = (0..edges.len()).filter(tight).collect();
        order.sort_by_cached_key(|&e| Reverse(guess.flow[e].abs()));
        let mut forest = Forest { edges, at: vec![Vec::new(); points] };
        let mut tree: Vec<usize> = (0..points).collect();
        for e in order {
            let (a, b) = edges[e];
            let (old, new) = (tree[a], tree[b]);
            if old != new {
                for root in tree.iter_mut().filter(|root| **root == old) {
                    *root = new;
                }
                forest.at[a].push(e);
                forest.at[b].push(e);
            }
        }
        forest
    }

    /// The flow along the forest that carries w; `None` if there is none, or if it runs
    /// upwards on an edge.
    fn flow<S: Real + Ord>(&self, w: &[S], heights: &[i64]) -> Option<Vec<S>> {
        let zero = S::zero();
        let (mut flow, mut carried) = (vec![zero.clone(); self.edges.len()], w.to_vec());
        // From the leaves to the roots of the trees.
        for (point, above) in self.rooted().into_iter().rev() {
            let out = std::mem::replace(&mut carried[point], zero.clone());
            let sign = out.cmp(&zero) as i64;
            let Some(e) = above else {
                if sign != 0 {
                    return None;
                }
                continue;
            };
            let (a, b) = self.edges[e];
            let next = a + b - point;
            if sign * (heights[point] - heights[next]) < 0 {
                return None;
            }
            carried[next].accumulate(&out);
            flow[e] = if point == a { out } else { zero.minus(&out) };
        }
        Some(flow)
    }

    /// All points, each after its parent, with the edge to the parent; `None` for a root.
    fn rooted(&self) -> Vec<(usize, Option<usize>)> {
        let mut seen = vec![false; self.at.len()];
        let mut order = Vec::with_capacity(self.at.len());
        for root in 0..self.at.len() {
            if std::mem::replace(&mut seen[root], true) {
                continue;
            }
            let mut next = order.len();
            order.push((root, None));
            while let Some(&(point, _)) = order.get(next) {
                next += 1;
                for &e in &self.at[point] {
                    let (a, b) = self.edges[e];
                    if !std::mem::replace(&mut seen[a + b - point], true) {
                        order.push((a + b - point, Some(e)));
                    }
                }
            }
        }
        order
    }
}
