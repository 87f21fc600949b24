//! Bounds of the single entries of the rows m levels below a node.

use super::scaled::{PLACES, Scaled};
use super::tree::Tree;
use crate::exact::{Integer, Rational};

/// The nodes of so many levels at a time are looked at: the most with at most this number of nodes.
const NODES: usize = 4096;

/// The most words of the rows of these nodes: of wide masks and long numbers there are fewer nodes.
const WORDS: usize = 1 << 22;

/// No bound is above this number, times 2^−PLACES; where one would be, there are none.
const LARGEST: i64 = 1 << 38;

/// β_p ≥ |λ_p| for all rows λ of E^m, m = 0, 1, …, where the rows of E sum to 1.
///
/// A row of E^m is μW, where W are the rows of a node of level k ≤ m and μ is a row of E^{m−k}. Since Σμ_q = 1, its
/// entry at p is W_{a,p} + Σ_q μ_q(W_{q,p} − W_{a,p}), for any a.
///
/// Source: `proofs/THEOREMS.md`, 116.
#[derive(Clone, Debug)]
pub(super) struct Entries {
    size: usize,
    /// k.
    step: usize,
    /// For each node of level k and each p: |W_{a,p}|, and |W_{q,p} − W_{a,p}| for each q, times 2^PLACES,
    /// rounded up.
    nodes: Vec<(i64, Vec<i64>)>,
    /// 2^PLACES times the bounds, for m = 0, 1, ….
    known: Vec<Vec<i64>>,
}

/// 2^PLACES·x, rounded up; `None` above [`LARGEST`].
fn raised(x: &Rational) -> Option<i64> {
    let scaled = (x * Rational::from(Integer::one().shifted_left(PLACES))).ceil();
    scaled.to_i64().filter(|x| *x <= LARGEST)
}

impl Entries {
    /// `None` if the coefficients do not fit, or there are too many nodes even of one level.
    pub(super) fn new(operator: &Scaled) -> Option<Entries> {
        let tree = Tree::<Integer>::new(operator)?;
        let size = tree.size;
        let bits = usize::try_from(operator.denominator.bits()).ok()?;
        // The denominators of level k, at most NODES.ilog2(), have k times as many bits.
        let words = 1 + bits.saturating_mul(NODES.ilog2() as usize) / 64;
        let nodes = NODES.min(WORDS / size.saturating_mul(size).saturating_mul(words).max(1));
        let step = nodes.checked_ilog(operator.arity).filter(|&step| step > 0)?;
        let mut level = vec![tree.root()];
        let mut known = vec![largest_of_own(&level, &tree, &Integer::one())?];
        for depth in 1..=step {
            let part = |(rows, digit): (&Vec<Integer>, usize)| {
                let mut part = tree.root();
                tree.part(digit, rows, &mut part);
                part
            };
            let all = level.iter().flat_map(|rows| (0..operator.arity).map(move |d| (rows, d)));
            level = all.map(part).collect();
            known.push(largest_of_own(&level, &tree, &operator.denominator.pow(depth))?);
        }
        // Beyond level k − 1 the bounds follow from those of k levels before.
        known.pop();
        let scale = operator.denominator.pow(step);
        let raise = |x: &Integer| raised(&Rational::new(x.abs(), scale.clone()));
        let node = |rows: &Vec<Integer>, p: usize| {
            let entry = |q: usize| &rows[q * size + p];
            let own = entry(tree.own);
            let steps = (0..size).map(|q| raise(&(entry(q) - own))).collect::<Option<_>>()?;
            Some((raise(own)?, steps))
        };
        let nodes = level.iter().flat_map(|rows| (0..size).map(move |p| (rows, p)));
        let nodes: Vec<(i64, Vec<i64>)> =
            nodes.map(|(rows, p)| node(rows, p)).collect::<Option<_>>()?;
        Some(Entries { size, step: step as usize, nodes, known })
    }

    /// 2^PLACES times the bounds for m, where `total`(i) ≥ ‖E^i‖ for i ≤ m; `None` where they are too large.
    pub(super) fn of(&mut self, m: usize, total: impl Fn(usize) -> Rational) -> Option<&[i64]> {
        while self.known.len() <= m {
            let next = self.next(&total)?;
            self.known.push(next);
        }
        Some(&self.known[m])
    }

    /// The bounds for the next m.
    fn next(&self, total: impl Fn(usize) -> Rational) -> Option<Vec<i64>> {
        let next = self.known.len();
        let before = &self.known[next - self.step];
        let tau = raised(&total(next - self.step))?;
        // Σμ_q = 1 and Σ|μ_q| ≤ τ: no entry is above (τ + 1)/2.
        let most = i128::from(raised(&total(next))?.midpoint(1 << PLACES) + 1);
        let mut bounds = vec![0; self.size];
        for (i, (own, steps)) in self.nodes.iter().enumerate() {
            let terms = steps.iter().zip(before);
            let sum: i128 = terms.map(|(x, y)| i128::from(*x) * i128::from(*y)).sum();
            let widest = steps.iter().max().copied().unwrap_or(0);
            let sum = sum.min(i128::from(widest) * i128::from(tau));
            let bound = (i128::from(*own) + (sum >> PLACES) + 1).min(most);
            let largest = &mut bounds[i % self.size];
            *largest = i64::try_from(bound).ok()?.max(*largest);
        }
        Some(bounds)
    }
}

/// 2^PLACES times the largest entries at each place of the rows of these nodes over `scale`, rounded up.
fn largest_of_own(
    level: &[Vec<Integer>],
    tree: &Tree<Integer>,
    scale: &Integer,
) -> Option<Vec<i64>> {
    let own = tree.own * tree.size;
    let at = |p: usize| {
        let largest = level.iter().map(|rows| rows[own + p].abs()).max();
        raised(&Rational::new(largest.unwrap_or_else(Integer::zero), scale.clone()))
    };
    (0..tree.size).map(at).collect()
}
