//! Distances at a level: of the whole mesh, of its faces, and the Hausdorff distance.

use super::depth::Distances;
use super::judge::Judge as _;
use super::maximum::maximum;
use super::surface::{PieceSearch as _, Surface};
use super::whole_mesh::WholeMesh;
use crate::exact::Rational;
use crate::float::nearest;
use crate::patch::number::Vector as _;
use crate::patch::place::FarPlace;
use crate::patch::threads::in_threads;
use std::collections::BTreeSet;

/// How wide the enclosures of the distances of single faces are, relative to them.
const FACE_WIDTH: f64 = 0.05;

/// How many pieces are looked at in one root for its faces, or for one limit point.
const STEPS: u64 = 100_000;

/// How many limit points are tried for the Hausdorff distance.
const TRIED: usize = 64;

#[expect(private_bounds, reason = "all surfaces are here")]
impl<S: Surface> Distances<S> {
    pub(crate) fn measured_faces(&self, level: u32) -> Vec<[f64; 2]> {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let mut faces = vec![[0.0_f64; 2]; model.face_count()];
        let scale = nearest(model.frame().1);
        let roots: Vec<usize> = (0..model.root_count()).collect();
        self.work.begin(level, roots.len());
        let found = in_threads(&roots, |&root| {
            self.work.step();
            let measure = |(of, cell): (Vec<usize>, S::Cell)| {
                let (mut best, mut place) = (0.0, None);
                let mut search = model.search(&judge, level, STEPS);
                let upper = search.measure(cell, FACE_WIDTH, &mut best, &mut place);
                let face = place.map(|place| model.far_place(root, 0, &place).face);
                (of, face, [best * scale, upper.max(best) * scale])
            };
            model.on_faces(root, level).into_iter().map(measure).collect::<Vec<_>>()
        });
        for (of, face, [lower, upper]) in found.into_iter().flatten() {
            for face in of {
                faces[face][1] = faces[face][1].max(upper);
            }
            if let Some(face) = face {
                faces[face][0] = faces[face][0].max(lower);
            }
        }
        faces
    }

    /// An enclosure of the distance at a level.
    pub(crate) fn measured(&self, level: u32) -> ([f64; 2], Option<FarPlace>) {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let (width, waiting) = (model.width(), model.above(level, 0.0));
        self.work.begin(level, waiting.len());
        let found = maximum(&waiting, width, &self.work, |root, best, place| {
            let mut search = model.search(&judge, level, S::STEPS);
            let mut own = None;
            let upper = search.measure(model.root(root, level), width, best, &mut own);
            *place = own.map(|place| (root, place));
            (upper, S::STEPS - search.left())
        });
        let scale = nearest(model.frame().1);
        let place = found.place.map(|(root, place)| model.far_place(root, level, &place));
        ([found.lower * scale, found.upper * scale], place)
    }

    /// A lower bound of the one-sided Hausdorff distance at a level: the greatest distance, from the
    /// whole mesh, of the limit points that are farthest from it at their parameters, each in its root.
    pub(super) fn apart(&self, level: u32) -> f64 {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let waiting = model.above(level, 0.0);
        if waiting.is_empty() {
            return 0.0;
        }
        let whole = WholeMesh::new(model, &judge, level);
        let mut best = 0.0_f64;
        // More of those with great bounds than of the others.
        let chosen: BTreeSet<usize> =
            (0..TRIED).map(|i| waiting.len() * i * i / (TRIED * TRIED)).collect();
        for (_, root) in chosen.into_iter().filter_map(|i| waiting.get(i)) {
            let mut search = model.search(&judge, level, STEPS);
            let (mut far, mut place) = (best, None);
            search.measure(model.root(*root, level), FACE_WIDTH, &mut far, &mut place);
            if let Some(place) = place {
                let known = judge.above(&place.limit.minus(&place.polygon), place.level);
                best = best.max(whole.distance(&place.limit, known));
            }
        }
        best * nearest(model.frame().1)
    }
}
