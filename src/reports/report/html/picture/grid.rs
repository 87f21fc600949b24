//! Refined nets of numbers for pictures, in f64: the point (i, j) of level k at (i/n^k, j/m^k), and beyond
//! the piece the value of the nearest point of it.

use super::curve::Window;
use crate::float::nearest;
use crate::report::html::picture::plane::line::{Line, float, index};
use crate::scheme::{Mask, Rules};

/// From this factor on in both directions, the points of a later level are as good as limit points, at their
/// natural parameters.
const FINER: f64 = 64.0;

/// The most points that are computed of a level.
const MAX_POINTS: usize = 400_000;

/// The most lines that a picture asks for.
const MAX_LINES: usize = 1_000;

/// The points of a level.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    pub(super) k: u32,
    pub(super) first: [i64; 2],
    pub(super) rows: Vec<Vec<f64>>,
    /// n^k and m^k.
    pub(super) scale: [f64; 2],
    /// The point (i, j) is at ((i + s)/n^k, (j + t)/m^k) with these s and t.
    shift: [f64; 2],
}

impl Grid {
    /// The control net.
    pub(super) fn control(first: [i64; 2], rows: &[Vec<i64>], shift: [f64; 2]) -> Grid {
        let rows = rows.iter().map(|row| row.iter().map(|x| float(*x)).collect()).collect();
        Grid { k: 0, first, rows, scale: [1.0; 2], shift }
    }

    /// x_{i,j}.
    pub(super) fn point(&self, [i, j]: [i64; 2]) -> f64 {
        let place = |i: i64, first: i64, count: usize| {
            let last = count.saturating_sub(1);
            usize::try_from(i.saturating_sub(first)).unwrap_or(0).min(last)
        };
        let row = &self.rows[place(i, self.first[0], self.rows.len())];
        row[place(j, self.first[1], row.len())]
    }

    /// Where x_{i,j} is.
    pub(super) fn parameters(&self, [i, j]: [i64; 2]) -> [f64; 2] {
        [(float(i) + self.shift[0]) / self.scale[0], (float(j) + self.shift[1]) / self.scale[1]]
    }

    /// The parameters of the points along an axis that are strictly between two.
    pub(super) fn parameters_between(&self, axis: usize, (from, to): (f64, f64)) -> Vec<f64> {
        let place = |t: f64| t * self.scale[axis] - self.shift[axis];
        let (first, last) = (index(place(from).floor()) + 1, index(place(to).ceil()) - 1);
        let at = |i: i64| (float(i) + self.shift[axis]) / self.scale[axis];
        (first..=last).take(MAX_LINES).map(at).collect()
    }

    /// The value of the bilinear interpolant.
    pub(super) fn at(&self, place: [f64; 2]) -> f64 {
        let along = |axis: usize| {
            let place = place[axis] * self.scale[axis] - self.shift[axis];
            (index(place.floor()), place - place.floor())
        };
        let ((i, u), (j, v)) = (along(0), along(1));
        let row = |i: i64| (1.0 - v) * self.point([i, j]) + v * self.point([i, j + 1]);
        (1.0 - u) * row(i) + u * row(i + 1)
    }

    /// The next level, without the points on which nothing in the windows depends.
    fn refined(&self, rules: [&Rules<f64>; 2], windows: [Window; 2]) -> Option<Grid> {
        let mut first = [0; 2];
        let mut rows = self.rows.clone();
        let mut scale = self.scale;
        // First along the rows, then along the columns of what that gives.
        for axis in [1, 0] {
            let rules = rules[axis];
            scale[axis] *= float(i64::try_from(rules.arity()).ok()?);
            let around = 2 * margin(rules);
            let (from, to) = windows[axis].ends();
            let from = index((from * scale[axis]).floor()) - around;
            let to = index((to * scale[axis]).ceil()) + around;
            let line = |points: Vec<f64>| {
                let line = Line { first: self.first[axis], points }.refined(rules)?;
                Some(line.part(from, to))
            };
            let lines = rows.into_iter().map(line).collect::<Option<Vec<Line>>>()?;
            first[axis] = lines.first()?.first;
            rows = transposed(&lines);
        }
        Some(Grid { k: self.k + 1, first, rows, scale, shift: self.shift })
    }
}

/// How far a point of the next level is from those that it depends on, and a little more.
fn margin(rules: &Rules<f64>) -> i64 {
    i64::try_from(rules.width()).unwrap_or(0) + rules.offset().abs() + 2
}

fn transposed(lines: &[Line]) -> Vec<Vec<f64>> {
    let count = lines.first().map_or(0, |line| line.points.len());
    (0..count).map(|place| lines.iter().map(|line| line.points[place]).collect()).collect()
}

/// The levels from 0 to one that stands for the limit of level `k` in two windows, which has its points at
/// their natural parameters; `None` where that takes too many points.
pub(super) fn levels(
    [first, second]: [&Mask; 2],
    control: Grid,
    k: u32,
    windows: [Window; 2],
    natural: [f64; 2],
) -> Option<Vec<Grid>> {
    let rules = [first, second].map(|mask| mask.rules().map(nearest));
    let mut levels = vec![control];
    loop {
        let last = levels.last()?;
        if last.rows.len() * last.rows.first().map_or(0, Vec::len) > MAX_POINTS {
            return None;
        }
        let own = levels.get(usize::try_from(k).ok()?);
        let fine = |own: &Grid| (0..2).all(|axis| last.scale[axis] >= FINER * own.scale[axis]);
        if own.is_some_and(fine) {
            break;
        }
        levels.push(last.refined([&rules[0], &rules[1]], windows)?);
    }
    levels.last_mut()?.shift = natural;
    Some(levels)
}
