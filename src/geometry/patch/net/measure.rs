//! Distances at a level: of the whole net, and of its faces.

use super::super::depth::PIECE_STEPS as FACE_STEPS;
use super::super::far::FarPlace;
use super::super::greatest::greatest;
use super::super::threads::in_threads;
use super::cell::Cell;
use super::depth::{NetDistances, PIECE_STEPS};
use crate::exact::Rational;
use crate::float::nearest;

/// How wide the enclosure of the distance is, relative to it.
const WIDTH: f64 = 1e-3;

/// The same for the distances of single faces.
pub(super) const FACE_WIDTH: f64 = 0.05;

impl NetDistances {
    /// A lower and an upper bound of the distance at a level, for each face of the control net: of its
    /// piece of the net of that level from its piece of the limit. Both are 0 where there is no limit.
    #[must_use]
    pub fn faces(&self, level: u32) -> Vec<[f64; 2]> {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let mut faces = vec![[0.0_f64; 2]; model.net.faces().iter().product()];
        let scale = nearest(&model.scale);
        let roots: Vec<usize> = (0..model.roots()).collect();
        self.work.begin(level, roots.len());
        // A piece that belongs to several faces is divided, so that most parts belong to one.
        let whole = model.directions.iter().all(|direction| direction.exact.start == 0);
        let found = in_threads(&roots, |&root| {
            self.work.step();
            let cell = model.rounded_cell(root);
            let cell = if level == 0 { cell.begun(&model.directions) } else { cell };
            let cells = if whole { vec![cell] } else { cell.parts(&model.directions, [true; 2]) };
            let measure = |cell: Cell<f64>| {
                let mut search = self.search(&judge, level, FACE_STEPS);
                let (mut best, mut place) = (0.0, None);
                let of = model.faces_of(&cell);
                let upper = search.measure(cell, FACE_WIDTH, &mut best, &mut place);
                let lower = place.map(|place| (model.face(&place), best * scale));
                (of, lower, upper.max(best) * scale)
            };
            cells.into_iter().map(measure).collect::<Vec<_>>()
        });
        for (of, lower, upper) in found.into_iter().flatten() {
            for face in of {
                faces[face][1] = faces[face][1].max(upper);
            }
            if let Some((face, lower)) = lower {
                faces[face][0] = faces[face][0].max(lower);
            }
        }
        faces
    }

    /// A lower and an upper bound of the distance at a level.
    #[must_use]
    pub fn distance(&self, level: u32) -> [f64; 2] {
        self.measured(level).0
    }

    /// An enclosure of the distance at a level.
    pub(super) fn measured(&self, level: u32) -> ([f64; 2], Option<FarPlace>) {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let waiting = model.above(level, 0.0);
        self.work.begin(level, waiting.len());
        let found = greatest(&waiting, WIDTH, &self.work, |root, best, place| {
            let mut search = self.search(&judge, level, PIECE_STEPS);
            let upper = search.measure(model.rounded_cell(root), WIDTH, best, place);
            (upper, PIECE_STEPS - search.steps)
        });
        let scale = nearest(&model.scale);
        let place = found.place.map(|place| model.rounded_place(level, &place));
        ([found.lower * scale, found.upper * scale], place)
    }
}
