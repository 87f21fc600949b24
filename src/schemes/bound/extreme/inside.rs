//! The proof that a row is inside a hull.

use super::simplex::Simplex;
use super::step::{count, length, upward};

/// How far below 1 the cost of a row must be, so that it is dropped.
const MARGIN: f64 = 1.0 / 1_073_741_824.0;

/// Whether Σ|c_j| + ‖r‖/τ is certainly below 1, for x = Σ c_j v_j + r, where the row x and the rows v_j beyond
/// the unit rows are known up to errors with Σ|error| ≤ `error`.
///
/// `proofs/THEOREMS.md`, 113.
pub(super) fn is_inside(
    hull: &Simplex,
    unit: f64,
    x: &[f64],
    combination: &[(usize, f64)],
    error: f64,
) -> bool {
    let mut rest = x.to_vec();
    // The sum of the absolute values of all numbers that were added.
    let mut added = length(x);
    for (j, c) in combination.iter().filter(|(_, c)| *c != 0.0) {
        for (rest, v) in rest.iter_mut().zip(hull.row(*j)) {
            let product = c * v;
            *rest -= product;
            added += product.abs();
        }
    }
    let terms = 2 * combination.len() + x.len();
    let rounding = upward(f64::EPSILON * (count(terms) + 2.0) * upward(added, terms * x.len()), 4);
    let coefficients = upward(combination.iter().map(|(_, c)| c.abs()).sum(), combination.len());
    let remainder = upward(length(&rest), x.len()) + rounding + (1.0 + coefficients) * error;
    let cost = coefficients + upward(remainder, 4) / unit;
    upward(cost, 4) < 1.0 - MARGIN
}
