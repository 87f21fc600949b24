//! The search for an extremal norm of a set of matrices, in f64: products of large spectral radius,
//! and rows of which the absolutely convex hull is invariant.
//!
//! Nothing here is proven. What it finds is a proposal, which exact arithmetic verifies.
//!
//! The absolutely convex hull of rows v_1, …, v_m is the set of all Σ c_j v_j with Σ|c_j| ≤ 1. The
//! *gauge* of a row x is the least Σ|c_j| with x = Σ c_j v_j.

mod absolute_hull;
mod closure;
mod spectral;
mod words;

pub use absolute_hull::{AbsoluteHull, Gauge};
pub use closure::{Closure, Image, Origin, SearchCaps, close};
pub use spectral::spectral_radius;
pub use words::{Candidates, candidates};

/// A square matrix, row by row.
pub type Rows = Vec<Vec<f64>>;

/// xM for a row x.
#[must_use]
pub fn row_times(x: &[f64], matrix: &Rows) -> Vec<f64> {
    let mut sum = vec![0.0; matrix.first().map_or(0, Vec::len)];
    for (x, row) in x.iter().zip(matrix) {
        if *x != 0.0 {
            sum.iter_mut().zip(row).for_each(|(sum, entry)| *sum += x * entry);
        }
    }
    sum
}

/// AB.
#[must_use]
pub fn product(a: &Rows, b: &Rows) -> Rows {
    a.iter().map(|row| row_times(row, b)).collect()
}

/// max_i Σ_j |m_{i,j}|.
#[must_use]
pub fn norm(matrix: &Rows) -> f64 {
    matrix.iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}
