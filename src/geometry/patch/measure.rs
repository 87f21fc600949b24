//! Distances at a level: of the whole mesh, of its faces, and the Hausdorff distance.

use super::apart::WholeMesh;
use super::depth::{MeshDistances, PIECE_STEPS};
use super::far::FarPlace;
use super::greatest::greatest;
use super::judge::Judge;
use super::kind::Kind;
use super::number::Vector as _;
use super::search::Search;
use super::shape::UP;
use super::threads::in_threads;
use crate::exact::Rational;
use crate::float::nearest;
use std::collections::BTreeSet;

/// How wide the enclosure of the distance is, relative to it.
const WIDTH: f64 = 1e-3;

/// The same for solids, of which irregular edges have many pieces.
const SOLID_WIDTH: f64 = 0.02;

/// The same for the distances of single faces.
const FACE_WIDTH: f64 = 0.05;

/// How many limit points are tried for the Hausdorff distance.
const TRIED: usize = 64;

impl MeshDistances {
    /// A lower and an upper bound of the distance at a level, for each face or cell of the control mesh: of its
    /// piece of the mesh of that level from its piece of the limit. Both are 0 where there is no limit.
    #[must_use]
    pub fn faces(&self, level: u32) -> Vec<[f64; 2]> {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let mut faces = vec![[0.0_f64; 2]; model.source.face_count()];
        let scale = nearest(&model.scale);
        self.work.begin(level, model.roots.all.len());
        let bounds = in_threads(&model.roots.all, |root| {
            self.work.step();
            let mut search = Search::new(&model.shapes, model.kind, &judge, level, PIECE_STEPS);
            let (mut best, mut place) = (0.0, None);
            let cell = model.rounded_cell(root, level);
            let upper = search.measure(cell, FACE_WIDTH, &mut best, &mut place);
            [best * scale, upper.max(best) * scale]
        });
        for (root, [lower, upper]) in model.roots.all.iter().zip(bounds) {
            let face = &mut faces[root.face];
            *face = [face[0].max(lower), face[1].max(upper)];
        }
        faces
    }

    /// For each face of the control mesh an upper bound of the distance at this level and at all later
    /// ones, without a search: G_{k−1} N of its pieces of level 1 (`proofs/THEOREMS.md`, 92 and 94).
    /// [`depth`](Self::depth) begins with these bounds. They are attained on regular faces of
    /// paraboloids, and some ten times too great around irregular vertices.
    ///
    /// # Panics
    /// At level 0: the bounds begin with level 1.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::mesh::{MeshScheme, PolygonMesh};
    /// use subcert::patch::MeshDistances;
    ///
    /// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
    /// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
    /// let distances =
    ///     MeshDistances::new(PolygonMesh::new(points.to_vec(), faces)?, MeshScheme::Loop)?;
    /// assert!(distances.guaranteed(4)[0] < distances.guaranteed(3)[0]);
    /// # Ok::<(), subcert::mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn guaranteed(&self, level: u32) -> Vec<f64> {
        assert!(level > 0, "the bounds of a mesh begin with level 1");
        let model = &self.model;
        let mut faces = vec![0.0_f64; model.source.face_count()];
        let scale = nearest(&model.scale);
        for (root, bound) in model.roots.all.iter().zip(model.bounds(level)) {
            faces[root.face] = faces[root.face].max(bound * scale * UP);
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
        let width = if model.kind == Kind::Solid { SOLID_WIDTH } else { WIDTH };
        let waiting = model.above(level, 0.0);
        self.work.begin(level, waiting.len());
        let found = greatest(&waiting, width, &self.work, |root, best, place| {
            let mut search = Search::new(&model.shapes, model.kind, &judge, level, PIECE_STEPS);
            let mut own = None;
            let upper = search.measure(model.rounded_cell(root, level), width, best, &mut own);
            *place = own.map(|place| (root, place));
            (upper, PIECE_STEPS - search.steps)
        });
        let scale = nearest(&model.scale);
        let place = found.place.map(|(root, place)| FarPlace::rounded(model, root, level, &place));
        ([found.lower * scale, found.upper * scale], place)
    }

    /// A lower bound of the one-sided Hausdorff distance at a level: the greatest distance, from the
    /// whole mesh, of the limit points that are farthest from it at their parameters, each in its piece.
    pub(super) fn apart(&self, level: u32) -> f64 {
        let model = &self.model;
        let judge = model.rounded_judge(&Rational::one());
        let whole = WholeMesh::new(model, &judge, level);
        let mut best = 0.0_f64;
        let waiting = model.above(level, 0.0);
        // More of those with great bounds than of the others.
        let chosen: BTreeSet<usize> =
            (0..TRIED).map(|i| waiting.len() * i * i / (TRIED * TRIED)).collect();
        for (_, root) in chosen.into_iter().filter_map(|i| waiting.get(i)) {
            let mut search = Search::new(&model.shapes, model.kind, &judge, level, PIECE_STEPS);
            let (mut far, mut place) = (best, None);
            search.measure(model.rounded_cell(root, level), FACE_WIDTH, &mut far, &mut place);
            if let Some(place) = place {
                let known = judge.above(&place.limit.minus(&place.polygon), place.level);
                best = best.max(whole.distance(&place.limit, known));
            }
        }
        best * nearest(&model.scale)
    }
}
