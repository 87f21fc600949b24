//! The extreme points of the absolutely convex hull of rows.

use super::inside::is_inside;
use super::simplex::{Side, Simplex};
use super::step::{length, upward};

/// A row whose gauge is above this is taken for an extreme point.
const ENOUGH: f64 = 1.0 - 1.0 / 262_144.0;

/// Rows that are at most this far apart, up to sign, are continued as one.
pub(super) const NEAR: f64 = 1.0 / 1_099_511_627_776.0;

/// What a selection needs to know besides the rows.
pub(super) struct Selection {
    /// τ.
    pub(super) unit: f64,
    /// A bound of Σ|error| of every row.
    pub(super) error: f64,
    /// The most rows that are kept.
    pub(super) most: usize,
}

/// The places of rows that are at most [`NEAR`] from the first of them, up to sign.
pub(super) type Group = Vec<usize>;

impl Selection {
    /// Groups of all rows but those that are proven to be in the hull of the first rows of the groups and of τ
    /// times the unit rows, with a gauge below 1. `None` when there are too many, or the work does not suffice.
    pub(super) fn keep(&self, rows: &[Vec<f64>], work: &mut u64) -> Option<Vec<Group>> {
        let size = rows.first()?.len();
        let mut groups = grouped(rows, work)?;
        let mut hull = Simplex::new(size, self.unit);
        let mut open = vec![true; groups.len()];
        let mut kept: Vec<usize> = Vec::new();
        for at in 0..groups.len() {
            while open[at] {
                let row = &rows[groups[at][0]];
                let found = match hull.side(row, ENOUGH) {
                    Side::Inside(combination) => {
                        let inside = is_inside(&hull, self.unit, row, &combination, self.error);
                        (!inside).then_some(at)
                    }
                    Side::Unknown => Some(at),
                    // The row that is farthest in this direction is an extreme point.
                    Side::Outside(direction) => {
                        *work = work.checked_sub((groups.len() * size) as u64)?;
                        let along = |i: usize| product(&rows[groups[i][0]], &direction).abs();
                        let open = (0..groups.len()).filter(|&i| open[i]);
                        open.map(|i| (i, along(i))).max_by(|a, b| a.1.total_cmp(&b.1)).map(|a| a.0)
                    }
                };
                *work = work.checked_sub(hull.take_work())?;
                let Some(found) = found else { break };
                open[found] = false;
                if kept.len() == self.most {
                    return None;
                }
                kept.push(found);
                hull.push(rows[groups[found][0]].iter().copied());
            }
        }
        kept.sort_unstable();
        Some(kept.into_iter().map(|at| std::mem::take(&mut groups[at])).collect())
    }
}

/// All rows in groups, the longest first.
fn grouped(rows: &[Vec<f64>], work: &mut u64) -> Option<Vec<Group>> {
    let lengths: Vec<f64> = rows.iter().map(|row| length(row)).collect();
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|&i, &j| lengths[j].total_cmp(&lengths[i]));
    let mut groups: Vec<Group> = Vec::new();
    for i in order {
        // Rows that are near have lengths that are near.
        let reachable = |group: &&mut Group| lengths[group[0]] <= lengths[i] + 2.0 * NEAR;
        let mut looked = 0;
        let near = groups.iter_mut().rev().take_while(reachable).find(|group| {
            looked += 2 * rows[i].len() as u64;
            is_near(&rows[i], &rows[group[0]])
        });
        *work = work.checked_sub(looked)?;
        match near {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    Some(groups)
}

fn product(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// Whether two rows are at most [`NEAR`] apart, up to sign.
fn is_near(x: &[f64], y: &[f64]) -> bool {
    let distance = |sign: f64| x.iter().zip(y).map(|(x, y)| (x - sign * y).abs()).sum::<f64>();
    [1.0, -1.0].into_iter().any(|sign| upward(distance(sign), 2 * x.len()) <= NEAR)
}
