//! The gauge of the absolutely convex hull of rows, by the simplex method.

use super::row_times;
use crate::machine::{inverse, replace};
use crate::stop::check;

/// Rows v_1, …, v_m that span the space, and a basis of d of them from which the next search starts.
#[derive(Clone, Debug)]
pub struct AbsoluteHull {
    rows: Vec<Vec<f64>>,
    basis: Vec<usize>,
    /// The inverse of the matrix of the basis rows.
    inverse: Vec<Vec<f64>>,
    /// How often the inverse has been updated since it was computed.
    updates: usize,
    /// How many exchanges of rows there have been.
    exchanges: u64,
}

/// What the gauge of a row is, and by which rows.
#[derive(Clone, Debug)]
pub struct Gauge {
    /// Σ|c_j|.
    pub value: f64,
    /// The rows of which it is a combination, with their coefficients.
    pub combination: Vec<(usize, f64)>,
}

/// A reduced cost above 1 by less than this is taken for 1.
const TOLERANCE: f64 = 1e-11;

/// The most exchanges for one gauge; then the combination at hand is returned, which is a valid one.
const MAX_EXCHANGES: usize = 2_000;

/// After so many exchanges the row is moved a little: where several coefficients are 0, exchanges may go round in a
/// circle. It is moved by [`MOVED`] times its largest entry. The basis that is best for the moved row is so for the
/// row itself, as a coefficient of 0 may have any sign.
const MANY_EXCHANGES: usize = 60;
const MOVED: f64 = 1e-9;

/// A combination may miss its row by so much, as a part of the row's largest entry, before it is computed anew.
const ACCURATE: f64 = 1e-13;

/// The inverse is computed anew after so many updates, which each add a rounding error.
const MAX_UPDATES: usize = 20;

/// A smaller pivot is taken for 0.
const LEAST_PIVOT: f64 = 1e-13;

impl AbsoluteHull {
    /// The hull of rows; `None` when they do not span the space, as far as f64 can tell.
    #[must_use]
    pub fn new(rows: Vec<Vec<f64>>) -> Option<AbsoluteHull> {
        let size = rows.first()?.len();
        let basis = independent(&rows, size)?;
        let inverse = inverse(basis.iter().map(|&j| rows[j].clone()).collect(), LEAST_PIVOT)?;
        Some(AbsoluteHull { rows, basis, inverse, updates: 0, exchanges: 0 })
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// How many exchanges of rows all gauges together have taken.
    #[must_use]
    pub fn exchanges(&self) -> u64 {
        self.exchanges
    }

    /// Adds a row.
    pub fn push(&mut self, row: Vec<f64>) {
        self.rows.push(row);
    }

    /// The gauge of a row x, or, once it is seen to be at most `enough`, that of some combination.
    ///
    /// Any basis and the signs of the coefficients of x are a feasible vertex of the linear program
    /// min Σ|c_j|, so that no first phase is needed, and the basis of the last call is a good start.
    pub fn gauge(&mut self, x: &[f64], enough: f64) -> Gauge {
        for exchanges in 0.. {
            check();
            let coefficients = row_times(x, &self.inverse);
            let value: f64 = coefficients.iter().map(|c| c.abs()).sum();
            let done = value <= enough || exchanges >= MAX_EXCHANGES;
            let many = exchanges >= MANY_EXCHANGES;
            let moved = (many && !done).then(|| row_times(&moved(x), &self.inverse));
            let steering = moved.as_ref().unwrap_or(&coefficients);
            let entering = if done { None } else { self.entering(steering) };
            let exchanged = entering.is_some_and(|entering| self.exchange(steering, entering));
            if !exchanged {
                // Nearly dependent rows make the errors of updates large.
                let rest = self.rest(x, &coefficients);
                let error = largest(&rest);
                let doubtful = value > enough || error > ACCURATE * largest(x);
                if doubtful && self.updates > 0 && self.renew() {
                    continue;
                }
                return self.refined(&coefficients, &rest);
            }
        }
        unreachable!("the loop ends soon after the most exchanges")
    }

    /// x less its combination of the basis.
    fn rest(&self, x: &[f64], coefficients: &[f64]) -> Vec<f64> {
        let mut rest = x.to_vec();
        for (c, j) in coefficients.iter().zip(&self.basis) {
            rest.iter_mut().zip(&self.rows[*j]).for_each(|(rest, v)| *rest -= c * v);
        }
        rest
    }

    /// The combination, with that of the rest added.
    fn refined(&self, coefficients: &[f64], rest: &[f64]) -> Gauge {
        let more = row_times(rest, &self.inverse);
        let sums = coefficients.iter().zip(more).map(|(c, more)| c + more);
        let combination: Vec<(usize, f64)> = self.basis.iter().copied().zip(sums).collect();
        let value = combination.iter().map(|(_, c)| c.abs()).sum();
        Gauge { value, combination }
    }

    /// Computes the inverse anew; `false` where f64 cannot.
    fn renew(&mut self) -> bool {
        let rows = self.basis.iter().map(|&j| self.rows[j].clone()).collect();
        let Some(inverse) = inverse(rows, LEAST_PIVOT) else { return false };
        (self.inverse, self.updates) = (inverse, 0);
        true
    }

    /// The row with the greatest |v·y|, where y has v_b·y = sign c_b at the basis.
    fn entering(&self, coefficients: &[f64]) -> Option<(usize, f64)> {
        let signs: Vec<f64> =
            coefficients.iter().map(|c| if *c < 0.0 { -1.0 } else { 1.0 }).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let dual: Vec<f64> = self.inverse.iter().map(|row| dot(row, &signs)).collect();
        let costs = self.rows.iter().map(|row| dot(row, &dual)).enumerate();
        let best = costs.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        (best.1.abs() > 1.0 + TOLERANCE).then_some((best.0, best.1.signum()))
    }

    /// Puts ±v_j into the basis for the row whose coefficient is the first to become 0.
    fn exchange(&mut self, coefficients: &[f64], (entering, sign): (usize, f64)) -> bool {
        let direction = row_times(&self.rows[entering], &self.inverse);
        let ratio = |k: usize| {
            let falls = sign * direction[k] * coefficients[k].signum();
            (falls > 1e-10).then(|| (coefficients[k].abs() / falls, k))
        };
        let leaving = (0..self.basis.len()).filter_map(ratio).min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, leaving)) = leaving else { return false };
        self.exchanges += 1;
        let before = std::mem::replace(&mut self.basis[leaving], entering);
        if self.updates < MAX_UPDATES {
            replace(self.inverse.iter_mut().map(Vec::as_mut_slice), &direction, leaving);
            self.updates += 1;
            return true;
        }
        if self.renew() {
            return true;
        }
        self.basis[leaving] = before;
        false
    }
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

/// The row with different small numbers added to its entries: fractional parts of multiples of the golden ratio.
fn moved(x: &[f64]) -> Vec<f64> {
    let largest = largest(x);
    let step = (5.0_f64.sqrt() - 1.0) / 2.0;
    let parts = std::iter::successors(Some(step), |part| Some((part + step).fract()));
    x.iter().zip(parts).map(|(x, part)| x + MOVED * largest * (0.5 + part)).collect()
}

/// The places of d independent rows, the longest remainder first.
fn independent(rows: &[Vec<f64>], size: usize) -> Option<Vec<usize>> {
    let mut rest = rows.to_vec();
    let mut chosen = Vec::new();
    for _ in 0..size {
        let square = |row: &Vec<f64>| row.iter().map(|x| x * x).sum::<f64>();
        let lengths = rest.iter().map(square).enumerate();
        let (longest, length) = lengths.max_by(|a, b| a.1.total_cmp(&b.1))?;
        if length < 1e-20 {
            return None;
        }
        chosen.push(longest);
        let axis = rest[longest].clone();
        for row in &mut rest {
            let along = row.iter().zip(&axis).map(|(a, b)| a * b).sum::<f64>() / length;
            row.iter_mut().zip(&axis).for_each(|(x, a)| *x -= along * a);
        }
    }
    Some(chosen)
}
