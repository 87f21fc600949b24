//! Regular pieces of solids: tricubic B-splines, of 4 × 4 × 4 points inside, and one layer less at the
//! boundary (`proofs/THEOREMS.md`, 101).

use crate::patch::number::{Number, Row};
use crate::patch::shapes::bezier::Bezier;
use crate::patch::shapes::regular::{Bends, number};
use std::collections::BTreeMap;

/// A point of a grid. The corners of the piece are at 0 and 1.
type Place = [i32; 3];

/// The points of a regular piece by their places.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    at: BTreeMap<Place, u32>,
    /// The least and the greatest coordinates.
    ranges: [[i32; 2]; 3],
}

/// The Bézier coefficients of a cubic piece, over the points −1, …, 2, times 6.
pub(super) const MASKS: [[i64; 4]; 4] = [[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]];

impl Grid {
    /// The places of the points, from the cells around a piece, which comes first; `None` where it is not
    /// regular.
    pub(super) fn of(points: usize, cells: &[[usize; 8]]) -> Option<Grid> {
        let mut places: Vec<Option<Place>> = vec![None; points];
        let step = |corner: usize| [0, 1, 2].map(|i| i32::from(corner >> i & 1 == 1));
        for (index, corners) in cells.iter().enumerate() {
            let known = corners.iter().enumerate();
            let mut found = known.filter_map(|(corner, &point)| {
                let ([x, y, z], [a, b, c]) = (places[point]?, step(corner));
                Some([x - a, y - b, z - c])
            });
            let first = if index == 0 { Some([0; 3]) } else { None };
            let origin = first.or_else(|| found.next())?;
            for (corner, &point) in corners.iter().enumerate() {
                let step = step(corner);
                let place = [0, 1, 2].map(|i| origin[i] + step[i]);
                if *places[point].get_or_insert(place) != place {
                    return None;
                }
            }
        }
        let mut at = BTreeMap::new();
        for (point, place) in places.into_iter().enumerate() {
            let point = u32::try_from(point).ok()?;
            if at.insert(place?, point).is_some() {
                return None;
            }
        }
        let range = |i: usize| {
            let coordinates = at.keys().map(|place| place[i]);
            Some([coordinates.clone().min()?, coordinates.max()?])
        };
        let ranges = [range(0)?, range(1)?, range(2)?];
        // A layer may be missing in one direction, at one side: the boundary.
        let missing = ranges.iter().map(|[low, high]| 3 - (high - low)).sum::<i32>();
        let box_of = |[low, high]: [i32; 2]| usize::try_from(high - low).unwrap_or(0);
        let sizes = ranges.map(box_of);
        let whole = at.len() == sizes.iter().map(|size| size + 1).product::<usize>()
            && cells.len() == sizes.iter().product::<usize>();
        let near = ranges.iter().all(|[low, high]| *low >= -1 && *high <= 2);
        (whole && near && (0..=1).contains(&missing)).then_some(Grid { at, ranges })
    }

    /// The Bézier coefficients in one direction, over the places there, times 6.
    fn masks(&self, axis: usize) -> [Vec<(i32, i64)>; 4] {
        let [low, high] = self.ranges[axis];
        let mask = |i: usize| {
            // The boundary is refined by itself, so that the limit begins in it.
            match i {
                0 if low == 0 => vec![(0, 6)],
                3 if high == 1 => vec![(1, 6)],
                _ => (-1..3).zip(MASKS[i]).filter(|(_, weight)| *weight != 0).collect(),
            }
        };
        [mask(0), mask(1), mask(2), mask(3)]
    }

    /// The Bézier coefficients, each with the weights of the corners in the trilinear interpolant there.
    pub(super) fn bezier<W: Number>(&self) -> Bezier<W> {
        let masks = [0, 1, 2].map(|axis| self.masks(axis));
        let mut all = Vec::with_capacity(64);
        for index in 0..64_usize {
            let digits = [index % 4, index / 4 % 4, index / 16];
            let mut row: BTreeMap<u32, W> = BTreeMap::new();
            for &(x, a) in &masks[0][digits[0]] {
                for &(y, b) in &masks[1][digits[1]] {
                    for &(z, c) in &masks[2][digits[2]] {
                        row.insert(self.at[&[x, y, z]], number(a * b * c, 216));
                    }
                }
            }
            let share = |corner: u32| -> i64 {
                let share = |i: usize| {
                    let digit = i64::try_from(digits[i]).unwrap_or(0);
                    if corner >> i & 1 == 1 { digit } else { 3 - digit }
                };
                (0..3).map(share).product()
            };
            let plain = (0..8).map(|corner| (corner, share(corner)));
            let plain = plain.filter(|(_, share)| *share != 0);
            let plain = plain.map(|(corner, share)| (corner, number(share, 27)));
            all.push((row.into_iter().collect(), plain.collect()));
        }
        all
    }

    /// The second differences.
    pub(super) fn bends<W: Number>(&self) -> Bends<W> {
        let direction = |axis: usize| -> Vec<Row<W>> {
            let bend = |(place, &point): (&Place, &u32)| {
                let beside = |step: i32| {
                    let mut place = *place;
                    place[axis] += step;
                    self.at.get(&place).copied()
                };
                let one = || number(1, 1);
                Some(vec![(beside(-1)?, one()), (point, number(-2, 1)), (beside(1)?, one())])
            };
            self.at.iter().filter_map(bend).collect()
        };
        Bends { directions: (0..3).map(direction).collect(), across: Vec::new() }
    }
}
