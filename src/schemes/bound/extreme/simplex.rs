//! Gauges of absolutely convex hulls in f64, by the simplex method. Nothing here is proven.

use crate::machine::{inverse, replace};

/// A reduced cost above 1 by less than this is taken for 1.
const TOLERANCE: f64 = 1e-11;

/// The most exchanges for one row.
const MAX_EXCHANGES: usize = 500;

/// The inverse is computed anew after so many updates, which each add a rounding error.
const MAX_UPDATES: usize = 30;

/// Where a row lies.
#[derive(Debug)]
pub(super) enum Side {
    /// It is the combination of these rows with these coefficients, Σ|c_j| at most `enough`.
    Inside(Vec<(usize, f64)>),
    /// For this y its product with the row is above `enough` times the products |v·y| of all rows v.
    Outside(Vec<f64>),
    /// The search met its cap.
    Unknown,
}

/// Rows v_1, v_2, … of length d, of which the first d are τ times the unit rows, and a basis of d of them
/// from which the next search starts.
#[derive(Debug)]
pub(super) struct Simplex {
    size: usize,
    unit: f64,
    count: usize,
    /// The entries of all rows at one place, one list for each place.
    columns: Vec<Vec<f64>>,
    basis: Vec<usize>,
    /// The inverse of the matrix of the basis rows, row by row.
    inverse: Vec<f64>,
    updates: usize,
    /// The products of numbers that were computed.
    work: u64,
}

impl Simplex {
    pub(super) fn new(size: usize, unit: f64) -> Simplex {
        let columns = vec![Vec::new(); size];
        let (basis, inverse) = (Vec::new(), Vec::new());
        let (updates, work) = (0, 0);
        let mut simplex = Simplex { size, unit, count: 0, columns, basis, inverse, updates, work };
        for i in 0..size {
            simplex.push((0..size).map(|j| if i == j { unit } else { 0.0 }));
        }
        simplex.reset();
        simplex
    }

    /// Adds a row.
    pub(super) fn push(&mut self, row: impl IntoIterator<Item = f64>) {
        for (column, x) in self.columns.iter_mut().zip(row) {
            column.push(x);
        }
        self.count += 1;
    }

    /// The entries of row j.
    pub(super) fn row(&self, j: usize) -> impl Iterator<Item = f64> {
        self.columns.iter().map(move |column| column[j])
    }

    /// The work since the last call.
    pub(super) fn take_work(&mut self) -> u64 {
        std::mem::take(&mut self.work)
    }

    /// Whether Σ|c_j| ≤ `enough` for some combination x = Σ c_j v_j.
    ///
    /// Any basis and the signs of the coefficients of x are a feasible vertex of the linear program
    /// min Σ|c_j|, so that no first phase is needed, and the basis of the last call is a good start.
    pub(super) fn side(&mut self, x: &[f64], enough: f64) -> Side {
        for _ in 0..MAX_EXCHANGES {
            self.work += (self.size * (self.count + 3 * self.size)) as u64;
            let coefficients = self.in_basis(x);
            let value: f64 = coefficients.iter().map(|c| c.abs()).sum();
            if value <= enough {
                return Side::Inside(self.basis.iter().copied().zip(coefficients).collect());
            }
            let dual = self.dual(&coefficients);
            let (entering, cost) = self.dearest(&dual);
            if value > enough * cost.abs().max(1.0) {
                return Side::Outside(dual);
            }
            let exchanged = cost.abs() > 1.0 + TOLERANCE
                && self.exchange(&coefficients, entering, cost.signum());
            if !exchanged {
                break;
            }
        }
        self.reset();
        Side::Unknown
    }

    /// The coefficients of x in the basis.
    fn in_basis(&self, x: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.size];
        for (x, row) in x.iter().zip(self.inverse.chunks_exact(self.size)) {
            if *x != 0.0 {
                sum.iter_mut().zip(row).for_each(|(sum, entry)| *sum += x * entry);
            }
        }
        sum
    }

    /// The y with v_b·y = sign c_b for the rows of the basis.
    fn dual(&self, coefficients: &[f64]) -> Vec<f64> {
        let rows = self.inverse.chunks_exact(self.size);
        let signed = |(x, c): (&f64, &f64)| if *c < 0.0 { -x } else { *x };
        rows.map(|row| row.iter().zip(coefficients).map(signed).sum()).collect()
    }

    /// The row with the greatest |v·y|, and v·y.
    fn dearest(&self, dual: &[f64]) -> (usize, f64) {
        let mut costs = vec![0.0; self.count];
        for (column, y) in self.columns.iter().zip(dual) {
            costs.iter_mut().zip(column).for_each(|(cost, x)| *cost += x * y);
        }
        let mut best = (0, 0.0_f64);
        for (j, cost) in costs.into_iter().enumerate() {
            if cost.abs() > best.1.abs() {
                best = (j, cost);
            }
        }
        best
    }

    /// Puts ±v_j into the basis for the row whose coefficient is the first to become 0.
    fn exchange(&mut self, coefficients: &[f64], entering: usize, sign: f64) -> bool {
        let row: Vec<f64> = self.row(entering).collect();
        let direction = self.in_basis(&row);
        let mut leaving: Option<(f64, usize)> = None;
        for (k, (c, d)) in coefficients.iter().zip(&direction).enumerate() {
            let falls = sign * d * c.signum();
            let ratio = c.abs() / falls;
            if falls > 1e-10 && leaving.is_none_or(|(least, _)| ratio < least) {
                leaving = Some((ratio, k));
            }
        }
        let Some((_, leaving)) = leaving else { return false };
        self.basis[leaving] = entering;
        if self.updates < MAX_UPDATES {
            replace(self.inverse.chunks_exact_mut(self.size), &direction, leaving);
            self.updates += 1;
            return true;
        }
        self.invert()
    }

    /// The basis of the unit rows.
    fn reset(&mut self) {
        let size = self.size;
        self.basis = (0..size).collect();
        let inverse = 1.0 / self.unit;
        self.inverse =
            (0..size * size).map(|i| if i % (size + 1) == 0 { inverse } else { 0.0 }).collect();
        self.updates = 0;
    }

    /// Computes the inverse anew; `false` where f64 cannot.
    fn invert(&mut self) -> bool {
        self.work += (2 * self.size.pow(3)) as u64;
        let rows = self.basis.iter().map(|&j| self.row(j).collect()).collect();
        let Some(inverse) = inverse(rows, 1e-14 * self.unit) else { return false };
        (self.inverse, self.updates) = (inverse.concat(), 0);
        true
    }
}
