//! One level in f64: images of rows, and how far rounding moves them.

use crate::bound::walk::{Edge, Transitions};
use crate::exact::Integer;

/// Twice the relative error of one operation, which leaves room for the errors of the bounds themselves.
const ROUNDING: f64 = f64::EPSILON;

/// Above every absolute error that underflow makes in a row.
pub(super) const TINY: f64 = 1e-280;

/// The greatest coefficient: 2^53. Integers up to it are f64 exactly.
const LARGEST: i64 = 1 << 53;

/// The matrices of one level, for rules with integer coefficients: row x becomes xM_d, d = 0, …, n − 1.
#[derive(Clone, Debug)]
pub(super) struct Steps {
    /// The number of entries of a row.
    pub(super) size: usize,
    /// For each d: from, to, coefficient.
    edges: Vec<Vec<(usize, usize, f64)>>,
    /// The most terms of an entry.
    terms: usize,
    /// The greatest absolute row sum of the matrices.
    norm: f64,
}

/// A number of operations; there are far fewer than 2^32.
pub(super) fn count(operations: usize) -> f64 {
    u32::try_from(operations).map_or(f64::INFINITY, f64::from)
}

#[expect(clippy::cast_precision_loss, reason = "an integer up to 2^53 in absolute value is a f64")]
fn exact_float(x: i64) -> f64 {
    x as f64
}

/// An upper bound of a sum of non-negative numbers that was computed with `terms` operations.
pub(super) fn upward(sum: f64, terms: usize) -> f64 {
    sum * (1.0 + ROUNDING * (count(terms) + 2.0)) + TINY
}

/// Σ|x| as computed.
pub(super) fn length(row: &[f64]) -> f64 {
    row.iter().map(|x| x.abs()).sum()
}

/// Lower and upper bounds of Σ|x|.
pub(super) fn lengths(row: &[f64]) -> [f64; 2] {
    let sum = length(row);
    let error = sum * ROUNDING * (count(row.len()) + 2.0) + TINY;
    [sum - error, sum + error]
}

impl Steps {
    /// `None` if a coefficient is above 2^53.
    pub(super) fn new(matrices: &Transitions<Integer>) -> Option<Steps> {
        let exact = |edge: &Edge<Integer>| {
            let x = edge.coefficient.within(LARGEST)?;
            Some((edge.from, edge.to, exact_float(x)))
        };
        let of_digit = |edges: &Vec<_>| edges.iter().map(exact).collect::<Option<Vec<_>>>();
        let edges: Vec<Vec<(usize, usize, f64)>> =
            matrices.edges.iter().map(of_digit).collect::<Option<_>>()?;
        let size = matrices.length;
        let mut terms = 0;
        let mut norm = 0.0_f64;
        for edges in &edges {
            for place in 0..size {
                terms = terms.max(edges.iter().filter(|edge| edge.1 == place).count());
                let from = edges.iter().filter(|edge| edge.0 == place);
                norm = norm.max(upward(from.map(|edge| edge.2.abs()).sum(), size));
            }
        }
        Some(Steps { size, edges, terms, norm })
    }

    pub(super) fn arity(&self) -> usize {
        self.edges.len()
    }

    /// The products for the images of one row by all matrices.
    pub(super) fn work(&self) -> u64 {
        self.edges.iter().map(Vec::len).sum::<usize>() as u64
    }

    /// xM_d, rounded.
    pub(super) fn image(&self, row: &[f64], digit: usize) -> Vec<f64> {
        let mut image = vec![0.0; self.size];
        for &(from, to, x) in &self.edges[digit] {
            image[to] += row[from] * x;
        }
        image
    }

    /// A bound of Σ|error| of an image of a row with Σ|x| at most `length`.
    ///
    /// The error of a sum of k products is at most γ_k times the sum of their absolute values, with γ_k =
    /// ku/(1 − ku) and u = 2^−53. Over all entries these are at most Σ|x| times the largest row sum.
    pub(super) fn error(&self, length: f64) -> f64 {
        upward(ROUNDING * (count(self.terms) + 1.0) * self.norm * length, 4)
    }
}
