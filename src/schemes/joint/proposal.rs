//! Hulls that prove an upper bound a little above the rate of a product.

use super::convert::{floats, on_grid, scaled};
use super::entry::Entry;
use super::hull::Hull;
use super::matrix_set::MatrixSet;
use crate::exact::Rational;
use crate::float::extremal::{AbsoluteHull, Rows, SearchCaps, close, row_times};
use crate::float::{exact, nearest};

/// A hull with a bound of about `rate`·(1 + `excess`), verified; `None` where the search meets its cap.
///
/// It is closed under the matrices of `near` over `rate`·(1 + `excess`/2). The other half of the excess is room for
/// rounding, for the gauges of the images, and for what the set differs from `near` by.
pub(super) fn hull<F: Entry>(
    set: &MatrixSet<F>,
    near: &MatrixSet<F>,
    seeds: &[Vec<f64>],
    unit: &Rational,
    (rate, excess): (f64, f64),
    (rows, work): (usize, u64),
) -> Option<Hull> {
    let size = set.size();
    // Rows are rounded by far less than the excess.
    let bits = 14 + (0..31).find(|&bits| f64::from(1_u32 << bits) * excess >= 1.0)?;
    let target = rate * (1.0 + excess);
    let tau = nearest(unit);
    let unit_row = |i: usize| (0..size).map(|j| if i == j { tau } else { 0.0 }).collect();
    let all: Vec<Vec<f64>> = (0..size).map(unit_row).chain(seeds.iter().cloned()).collect();
    let enlarge = |m: Rows| scaled(m, (1.0 + excess / 2.0) / target);
    let enlarged: Vec<Rows> = floats(near).into_iter().map(enlarge).collect();
    let closure = close(&enlarged, all, &[], SearchCaps { rows, slack: 0.0, work })?;
    let round = |row: &Vec<f64>| row.iter().map(|x| on_grid(*x, bits)).collect::<Option<Vec<_>>>();
    let rows = closure.rows[size..].iter().map(round).collect::<Option<Vec<Vec<Rational>>>>()?;
    let near = rows.iter().map(|row| row.iter().map(nearest).collect::<Vec<f64>>());
    let all: Vec<Vec<f64>> = (0..size).map(unit_row).chain(near).collect();
    let matrices = floats(set);
    let mut absolute = AbsoluteHull::new(all.clone())?;
    let mut image = |row: &Vec<f64>, matrix: &Rows| -> Option<Vec<(usize, Rational)>> {
        let gauge = absolute.gauge(&row_times(row, matrix), target * (1.0 - excess / 4.0));
        // The combination costs more than the bound, and nothing is to be gained by the other images.
        if gauge.value > target * (1.0 + 1e-12) {
            return None;
        }
        let terms = gauge.combination.into_iter();
        let terms = terms.map(|(j, c)| Some((j, on_grid(c, bits + 6)?)));
        let terms = terms.collect::<Option<Vec<(usize, Rational)>>>()?;
        Some(terms.into_iter().filter(|(_, c)| !c.is_zero()).collect())
    };
    let images = all.iter().map(|row| matrices.iter().map(|matrix| image(row, matrix)).collect());
    let images = images.collect::<Option<Vec<Vec<Vec<(usize, Rational)>>>>>()?;
    let hull = Hull { bound: exact(target)?, unit: unit.clone(), rows, images };
    hull.proves(set).then_some(hull)
}

/// The most work of the search for products: their number, times the cube of the size.
const MAX_PRODUCTS: usize = 60_000_000;

/// How many products of each length are continued, within the work.
pub(super) fn beam<F: Entry>(set: &MatrixSet<F>, most: usize) -> usize {
    let each = set.matrices().len() * set.size().pow(3);
    (MAX_PRODUCTS / each / 14).clamp(4, most)
}
