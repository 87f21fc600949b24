//! The extreme points of the absolutely convex hull of rows.

use super::inside::is_inside;
use super::simplex::{Side, Simplex};

/// A row whose gauge is above this is taken for an extreme point.
const ENOUGH: f64 = 1.0 - 1.0 / 4_194_304.0;

/// What a selection needs to know besides the rows.
pub(super) struct Selection {
    /// τ.
    pub(super) unit: f64,
    /// A bound of Σ|error| of every row.
    pub(super) error: f64,
    /// The most rows that are kept.
    pub(super) most: usize,
}

impl Selection {
    /// The places of the rows that are kept: all but those that are proven to be in the hull of the kept rows
    /// and of τ times the unit rows, with a gauge below 1. `None` when there are too many, or the work does
    /// not suffice.
    ///
    /// `same` says whether two rows at these places are equal or opposite; it is asked for rows that are so up
    /// to rounding. Of equal rows the first is kept.
    pub(super) fn keep(
        &self,
        rows: &[Vec<f64>],
        work: &mut u64,
        mut same: impl FnMut(usize, usize) -> bool,
    ) -> Option<Vec<usize>> {
        let size = rows.first()?.len();
        let mut hull = Simplex::new(size, self.unit);
        let mut open = vec![true; rows.len()];
        let mut kept: Vec<usize> = Vec::new();
        for at in 0..rows.len() {
            while open[at] {
                let found = match hull.side(&rows[at], ENOUGH) {
                    Side::Inside(combination) => {
                        if is_inside(&hull, self.unit, &rows[at], &combination, self.error) {
                            open[at] = false;
                            None
                        } else {
                            Some(at)
                        }
                    }
                    Side::Unknown => Some(at),
                    // The row that is farthest in this direction is an extreme point.
                    Side::Outside(direction) => {
                        *work = work.checked_sub((rows.len() * size) as u64)?;
                        Some(farthest(rows, &open, &direction))
                    }
                };
                *work = work.checked_sub(hull.take_work())?;
                let Some(found) = found else { break };
                open[found] = false;
                let near = |&&other: &&usize| is_near(&rows[found], &rows[other], self.error);
                if kept.iter().filter(near).any(|&other| same(found, other)) {
                    continue;
                }
                if kept.len() == self.most {
                    return None;
                }
                kept.push(found);
                hull.push(rows[found].iter().copied());
            }
        }
        kept.sort_unstable();
        Some(kept)
    }
}

/// The place of the open row with the greatest |x·y|.
fn farthest(rows: &[Vec<f64>], open: &[bool], direction: &[f64]) -> usize {
    let along = |row: &[f64]| row.iter().zip(direction).map(|(x, y)| x * y).sum::<f64>().abs();
    let rows = rows.iter().enumerate().filter(|(i, _)| open[*i]);
    let rows = rows.map(|(i, row)| (i, along(row)));
    rows.max_by(|a, b| a.1.total_cmp(&b.1)).expect("the row itself is open").0
}

/// Whether two rows may be equal or opposite.
fn is_near(x: &[f64], y: &[f64], error: f64) -> bool {
    let distance = |sign: f64| x.iter().zip(y).map(|(x, y)| (x - sign * y).abs()).sum::<f64>();
    let enough = 4.0 * error + 1e-13;
    distance(1.0) <= enough || distance(-1.0) <= enough
}
