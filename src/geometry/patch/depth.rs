//! How many levels of refinement a mesh needs.

use super::descent::{Descent, Found, Left, descend};
use super::far::FarPlace;
use super::judge::{Exactly, Judge};
use super::model::Model;
use super::roots::Root;
use super::search::{Search, Verdict};
use super::threads::{in_rounds, in_threads};
use super::work::MeshWork;
use crate::exact::Rational;
use crate::float::upper;
use crate::mesh::{MeshError, MeshScheme, Point, PolygonMesh};
use crate::solid::{HexMesh, SolidError};
use std::sync::Arc;

/// The highest level that is asked for.
pub const MAX_DEPTH_LEVEL: u32 = 40;

/// How many are looked at in one piece of level 1.
pub(super) const PIECE_STEPS: u64 = 100_000;

/// How many levels a mesh needs.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshDepth {
    /// The least level that was found to be sufficient, with all later ones.
    pub level: u32,
    /// The greatest level that is certainly not sufficient; `None` where even level 0 may be.
    pub too_few: Option<u32>,
    /// Where the limit is beyond the tolerance at that level.
    pub beyond: Option<FarPlace>,
    /// A lower and an upper bound of the distance at `level`.
    pub distance: [f64; 2],
    /// Where the lower bound is attained; `None` where it is 0.
    pub worst: Option<FarPlace>,
    /// A lower bound of the one-sided Hausdorff distance at `level`: some point of the limit is so far from
    /// every point of the mesh. 0 of a solid.
    pub apart: f64,
    /// How many pieces were too near to call in f64, and were looked at exactly.
    pub exact_pieces: usize,
}

/// The distances of a mesh from its limit surface:
///
/// D_k = sup |P^∞ − P^k|, k = 0, 1, …,
///
/// over the whole surface, Euclidean. P^k is the mesh of level k, bilinear on each quadrilateral
/// (Catmull–Clark; a face of level 0 with n vertices is n bilinear quarters), flat on each triangle
/// (Loop), bilinear on each quarter of a face at an inner vertex (Doo–Sabin). P^∞ is the limit at
/// the same parameters. Distances are in the unit of the coordinates.
///
/// Source: `proofs/THEOREMS.md`, 91 to 97.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::{MeshScheme, PolygonMesh};
/// use subcert::patch::MeshDistances;
///
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points.to_vec(), faces)?;
/// let distances = MeshDistances::new(mesh, MeshScheme::Loop)?;
/// // The vertex (1, 1, 1) tends to a fifth of itself, 4√3/5 away.
/// let depth = distances.depth(&Rational::new(3, 2))?;
/// assert_eq!((depth.level, depth.too_few), (0, None));
/// assert!(depth.distance[0] <= 1.3857 && 1.3856 <= depth.distance[1]);
/// let depth = distances.depth(&Rational::new(1, 100))?;
/// assert_eq!(depth.too_few, Some(depth.level - 1));
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
pub struct MeshDistances {
    pub(super) model: Model,
    pub(super) work: Arc<MeshWork>,
    looks_apart: bool,
}

impl MeshDistances {
    /// The pieces of a mesh.
    ///
    /// # Errors
    /// When the scheme has no rules for a face or a vertex, the mesh of level 1 has too many points, or
    /// there is no limit surface.
    pub fn new(mesh: PolygonMesh<Rational>, scheme: MeshScheme) -> Result<Self, MeshError> {
        let model = Model::new(mesh, scheme)?;
        if model.roots.all.is_empty() {
            let reason = if scheme == MeshScheme::DooSabin {
                "no vertex is inside the mesh, and Doo–Sabin surfaces end at the faces around inner vertices; take \
                 catmull-clark"
            } else {
                "all faces are holes, or at a boundary with the rules `none`; take other rules at the boundary, `edge` or \
                 `corner`, or fewer holes"
            };
            return Err(MeshError::TooMuch { reason: format!("the surface is empty: {reason}") });
        }
        Ok(MeshDistances::of(model))
    }

    /// The pieces of a solid, which Bajaj's scheme refines. P^k is trilinear on each hexahedron.
    ///
    /// Source: `proofs/THEOREMS.md`, 100 to 102.
    ///
    /// # Errors
    /// When the mesh of level 1 has too many points, or its cells meet in too many different ways.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::patch::MeshDistances;
    /// use subcert::solid::HexMesh;
    ///
    /// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
    /// let cube = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
    /// // The corner (0, 0, 0) tends to (2, 2, 2)/9, 2√3/9 = 0.3849… away.
    /// let depth = MeshDistances::of_solid(cube)?.depth(&Rational::new(2, 5))?;
    /// assert_eq!(depth.level, 0);
    /// assert!(depth.distance[0] <= 0.3850 && 0.3849 <= depth.distance[1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_solid(mesh: HexMesh<Rational>) -> Result<Self, SolidError> {
        // A point of the limit of a solid is mostly inside the mesh: 0 says no less than is looked for.
        Ok(MeshDistances::of(Model::of_solid(mesh)?).without_apart())
    }

    fn of(model: Model) -> Self {
        MeshDistances { model, work: Arc::default(), looks_apart: true }
    }

    /// How far the search has come.
    #[must_use]
    pub fn work(&self) -> Arc<MeshWork> {
        Arc::clone(&self.work)
    }

    /// The same search, which can be watched and stopped through `work`.
    #[must_use]
    pub fn with_work(self, work: Arc<MeshWork>) -> Self {
        Self { work, ..self }
    }

    /// The same search without [`MeshDepth::apart`], which takes most of its time: that is 0.
    #[must_use]
    pub fn without_apart(self) -> Self {
        Self { looks_apart: false, ..self }
    }

    /// The depth for a tolerance.
    ///
    /// # Errors
    /// When the tolerance is not positive, or needs more than [`MAX_DEPTH_LEVEL`] levels.
    ///
    /// # Panics
    /// Never.
    pub fn depth(&self, tolerance: &Rational) -> Result<MeshDepth, MeshError> {
        not_positive(tolerance)?;
        let sure = self.sure_level(tolerance)?;
        let descent = descend(sure, |level, left| self.examine(level, tolerance, left));
        let Descent { level, beyond, exact_pieces } = descent;
        let (mut distance, worst) = self.measured(level);
        // The level is sufficient.
        distance[1] = distance[1].min(upper(tolerance));
        let apart = if self.looks_apart { self.apart(level) } else { 0.0 };
        let (too_few, beyond) = beyond.unzip();
        Ok(MeshDepth { level, too_few, beyond, distance, worst, apart, exact_pieces })
    }

    /// The level of [`depth`](Self::depth).
    pub(super) fn parametric_level(&self, tolerance: &Rational) -> Result<u32, MeshError> {
        let sure = self.sure_level(tolerance)?;
        Ok(descend(sure, |level, left| self.examine(level, tolerance, left)).level)
    }

    /// The least level, from 1 on, from which on simple bounds are within the tolerance.
    fn sure_level(&self, tolerance: &Rational) -> Result<u32, MeshError> {
        let judge = self.model.rounded_judge(tolerance);
        let limit = Judge::<Point<f64>>::tolerance(&judge);
        let sure = (1..=MAX_DEPTH_LEVEL)
            .find(|level| self.model.bounds(*level).all(|bound| bound <= limit));
        sure.ok_or_else(|| {
            let reason = format!(
                "the tolerance may need more than {MAX_DEPTH_LEVEL} levels, and so many are not looked \
                 at; take a greater one"
            );
            MeshError::TooMuch { reason }
        })
    }

    /// Whether a level is sufficient.
    fn examine(&self, level: u32, tolerance: &Rational, left: &mut Left) -> Found {
        let model = &self.model;
        let judge = model.rounded_judge(tolerance);
        let limit = Judge::<Point<f64>>::tolerance(&judge);
        let waiting = model.above(level, limit);
        self.work.begin(level, waiting.len());
        let mut found = Found::default();
        // Something is left for the levels below.
        let least = left.rounded / 2;
        let mut open = Vec::new();
        in_rounds(&waiting, |round| {
            let results = in_threads(round, |(_, root)| {
                self.work.step();
                if self.work.is_stopped() {
                    return (*root, Verdict::Open, 0);
                }
                let mut search = Search::new(&model.shapes, model.kind, &judge, level, PIECE_STEPS);
                let verdict = search.examine(model.rounded_cell(root, level));
                (*root, verdict, PIECE_STEPS - search.steps)
            });
            for (root, verdict, steps) in results {
                left.rounded = left.rounded.saturating_sub(steps);
                match verdict {
                    Verdict::Within => {}
                    Verdict::Beyond(place) => {
                        found.beyond = Some(FarPlace::rounded(model, root, level, &place));
                        return false;
                    }
                    Verdict::Open => open.push(root),
                }
            }
            left.rounded > least && !self.work.is_stopped()
        });
        if found.beyond.is_none() {
            found.open = left.rounded <= least || self.work.is_stopped();
            self.examine_exactly(level, tolerance, &open, left, &mut found);
        }
        found
    }

    /// The same for pieces that are too near to call in f64.
    fn examine_exactly(
        &self,
        level: u32,
        tolerance: &Rational,
        roots: &[&Root],
        left: &mut Left,
        found: &mut Found,
    ) {
        let model = &self.model;
        let judge = Exactly::new(tolerance);
        let steps = left.exact / 2;
        let mut search = Search::new(&model.shapes, model.kind, &judge, level, steps);
        for root in roots {
            let cell = if search.steps == 0 || self.work.is_stopped() {
                None
            } else {
                model.exact_cell(root, level)
            };
            let Some(cell) = cell else {
                found.open = true;
                break;
            };
            found.exact_pieces += 1;
            match search.examine(cell) {
                Verdict::Within => {}
                Verdict::Beyond(place) => {
                    found.beyond = Some(FarPlace::exact(model, root, level, &place));
                    break;
                }
                Verdict::Open => found.open = true,
            }
        }
        left.exact -= steps - search.steps;
    }
}

/// Refuses a tolerance that is not positive.
pub(super) fn not_positive(tolerance: &Rational) -> Result<(), MeshError> {
    if tolerance.sign() > 0 {
        return Ok(());
    }
    let reason = format!("the tolerance must be positive, and is {tolerance}");
    Err(MeshError::TooMuch { reason })
}
