//! How many levels of refinement a mesh or a net needs.

use super::descent::{Budget, Descent, LevelResult, descend};
use super::judge::Judge as _;
use super::surface::{PieceSearch as _, Surface, TooMuch as _, positive};
use crate::exact::Rational;
use crate::float::upper;
use crate::patch::place::{FarPlace, Verdict};
use crate::patch::progress::MeshWork;
use crate::patch::threads::{in_rounds, in_threads};
use std::sync::Arc;

/// The highest level that is asked for.
pub const MAX_DEPTH_LEVEL: u32 = 40;

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

/// The distances of a mesh, a solid or a net from its limit: see [`MeshDistances`](crate::patch::MeshDistances) and
/// [`NetDistances`](crate::patch::NetDistances).
pub struct Distances<S> {
    pub(crate) model: S,
    pub(crate) work: Arc<MeshWork>,
    looks_apart: bool,
}

/// The methods of one surface whose work is generic. Generic ones would be compiled by each crate that calls them, with
/// its own optimisation.
macro_rules! distances_of {
    ($model:ty, $error:ty) => {
        impl Distances<$model> {
            /// The depth for a tolerance.
            ///
            /// # Errors
            /// When the tolerance is not positive, or may need more levels than are looked at.
            pub fn depth(
                &self,
                tolerance: &$crate::exact::Rational,
            ) -> Result<$crate::patch::MeshDepth, $error> {
                self.depth_within(tolerance)
            }

            /// A lower and an upper bound of the distance at a level.
            #[must_use]
            pub fn distance(&self, level: u32) -> [f64; 2] {
                self.measured(level).0
            }

            /// A lower and an upper bound of the distance at a level, for each face or cell of the control mesh: of its
            /// piece of the mesh of that level from its piece of the limit. Both are 0 where there is no limit.
            #[must_use]
            pub fn faces(&self, level: u32) -> Vec<[f64; 2]> {
                self.measured_faces(level)
            }
        }
    };
}
pub(crate) use distances_of;

impl<S> Distances<S> {
    pub(crate) fn of(model: S) -> Self {
        Distances { model, work: Arc::default(), looks_apart: true }
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
}

#[expect(private_bounds, reason = "all surfaces are here")]
impl<S: Surface> Distances<S> {
    pub(crate) fn depth_within(&self, tolerance: &Rational) -> Result<MeshDepth, S::Error> {
        positive::<S::Error>(tolerance)?;
        let Descent { level, beyond, exact_pieces } = self.descended(tolerance)?;
        let (mut distance, worst) = self.measured(level);
        // The level is sufficient, and what was measured may be less sharp than what shows that.
        distance[1] = distance[1].min(upper(tolerance));
        let apart = if self.looks_apart { self.apart(level) } else { 0.0 };
        let (too_few, beyond) = beyond.unzip();
        Ok(MeshDepth { level, too_few, beyond, distance, worst, apart, exact_pieces })
    }

    fn descended(&self, tolerance: &Rational) -> Result<Descent, S::Error> {
        let sure = self.sure_level(tolerance)?;
        Ok(descend(sure, |level, left| self.examine(level, tolerance, left)))
    }

    /// The level of [`depth`](Self::depth).
    pub(crate) fn parametric_level(&self, tolerance: &Rational) -> Result<u32, S::Error> {
        Ok(self.descended(tolerance)?.level)
    }

    /// The least level, from that of the roots on, from which on simple bounds are within the tolerance.
    fn sure_level(&self, tolerance: &Rational) -> Result<u32, S::Error> {
        let limit = self.model.rounded_judge(tolerance).tolerance();
        let most = self.model.most_levels()[0].min(MAX_DEPTH_LEVEL);
        let is_sure = |level: &u32| self.model.bounds(*level).all(|bound| bound <= limit);
        (S::FIRST..=most).find(is_sure).ok_or_else(|| {
            S::Error::too_much(format!(
                "the tolerance may need more than {most} levels, and so many are not looked at; take a \
                 greater one"
            ))
        })
    }

    /// Whether a level is sufficient.
    fn examine(&self, level: u32, tolerance: &Rational, left: &mut Budget) -> LevelResult {
        let model = &self.model;
        let judge = model.rounded_judge(tolerance);
        let waiting = model.above(level, judge.tolerance());
        self.work.begin(level, waiting.len());
        let mut found = LevelResult::default();
        // Something is left for the levels below.
        let least = left.rounded / 2;
        let mut open = Vec::new();
        in_rounds(&waiting, |round| {
            let results = in_threads(round, |&(_, root)| {
                self.work.step();
                if self.work.is_stopped() {
                    return (root, Verdict::Open, 0);
                }
                let mut search = model.search(&judge, level, S::STEPS);
                let verdict = search.examine(model.root(root, level));
                (root, verdict, S::STEPS - search.left())
            });
            for (root, verdict, steps) in results {
                left.rounded = left.rounded.saturating_sub(steps);
                match verdict {
                    Verdict::Within => {}
                    Verdict::Beyond(place) => {
                        found.beyond = Some(model.far_place(root, level, &place));
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

    /// The same for roots that are too near to call in f64.
    fn examine_exactly(
        &self,
        level: u32,
        tolerance: &Rational,
        roots: &[usize],
        left: &mut Budget,
        found: &mut LevelResult,
    ) {
        let given = left.exact / 2;
        let mut steps = given;
        for &root in roots {
            let exhausted = steps == 0 || self.work.is_stopped();
            let examine = || self.model.examine_exactly(root, level, tolerance, &mut steps);
            let Some(verdict) = (!exhausted).then(examine).flatten() else {
                found.open = true;
                break;
            };
            found.exact_pieces += 1;
            match verdict {
                Verdict::Within => {}
                Verdict::Beyond(place) => {
                    found.beyond = Some(place);
                    break;
                }
                Verdict::Open => found.open = true,
            }
        }
        left.exact -= given - steps;
    }
}
