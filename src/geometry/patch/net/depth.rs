//! How many levels of refinement a net needs.

use super::super::depth::{MAX_DEPTH_LEVEL, MeshDepth};
use super::super::descent::{Descent, Found, Left, descend};
use super::super::judge::Judge;
use super::super::threads::{in_rounds, in_threads};
use super::super::work::MeshWork;
use super::model::Model;
use super::search::{Search, Verdict};
use crate::exact::Rational;
use crate::float::upper;
use crate::mesh::Point;
use crate::net::{Net, NetError, NetScheme};
use std::sync::Arc;

/// How many are looked at in one piece of level 0.
pub(super) const PIECE_STEPS: u64 = 1_000_000;

/// The distances of a net from its limit surface:
///
/// D_k = sup |P^∞ − P^k|, k = 0, 1, …,
///
/// over the part of the surface that the net determines, Euclidean. P^k is bilinear between the points
/// x^k_{i,j} at their natural parameters ((i + s)/n^k, (j + t)/m^k), and P^∞ is the limit at the
/// same parameters. Distances are in the unit of the coordinates.
///
/// Source: `proofs/THEOREMS.md`, 98 and 99.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, NetScheme};
/// use subcert::patch::NetDistances;
///
/// // x²/2 + y²/2 is a sixth of both second differences below its bicubic spline.
/// let square = |k: i64| Rational::new(k * k, 2);
/// let point = |k: i64| [(k % 5).into(), (k / 5).into(), square(k % 5) + square(k / 5)];
/// let net = Net::new((0..25).map(point).collect(), 5, Closed::default())?;
/// let distances = NetDistances::new(net, &NetScheme::parse("bicubic")?)?;
/// let depth = distances.depth(&Rational::new(1, 3))?;
/// assert_eq!((depth.level, depth.too_few), (0, None));
/// let depth = distances.depth(&Rational::new(1, 100))?;
/// assert_eq!((depth.level, depth.too_few), (3, Some(2)));
/// # Ok::<(), subcert::net::NetError>(())
/// ```
pub struct NetDistances {
    pub(super) model: Model,
    pub(super) work: Arc<MeshWork>,
    looks_apart: bool,
}

impl NetDistances {
    /// The pieces of a net.
    ///
    /// # Errors
    /// When the net has too few points for a piece, or a curve is not shown to converge or is beyond the
    /// caps.
    pub fn new(net: Net, scheme: &NetScheme) -> Result<NetDistances, NetError> {
        let model = Model::new(net, scheme)?;
        Ok(NetDistances { model, work: Arc::default(), looks_apart: true })
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

    /// The depth for a tolerance. Faces and vertices are those of the net, row by row.
    ///
    /// # Errors
    /// When the tolerance is not positive, or may need more levels than are looked at.
    pub fn depth(&self, tolerance: &Rational) -> Result<MeshDepth, NetError> {
        positive(tolerance)?;
        let Descent { level, beyond, exact_pieces } = self.descended(tolerance)?;
        let (mut distance, worst) = self.measured(level);
        // What the level was found to be sufficient for may be less than what was measured.
        distance[1] = distance[1].min(upper(tolerance));
        let apart = if self.looks_apart { self.apart(level) } else { 0.0 };
        let (too_few, beyond) = beyond.unzip();
        Ok(MeshDepth { level, too_few, beyond, distance, worst, apart, exact_pieces })
    }

    fn descended(&self, tolerance: &Rational) -> Result<Descent, NetError> {
        let sure = self.sure_level(tolerance)?;
        Ok(descend(sure, |level, left| self.examine(level, tolerance, left)))
    }

    /// The level of the depth alone.
    pub(super) fn level(&self, tolerance: &Rational) -> Result<u32, NetError> {
        Ok(self.descended(tolerance)?.level)
    }

    /// The least level from which on simple bounds are within the tolerance.
    fn sure_level(&self, tolerance: &Rational) -> Result<u32, NetError> {
        let judge = self.model.rounded_judge(tolerance);
        let limit = Judge::<Point<f64>>::tolerance(&judge);
        let [most, _] = self.model.most_levels(MAX_DEPTH_LEVEL);
        (0..=most).find(|level| self.model.surely(*level, limit)).ok_or_else(|| {
            NetError::TooMuch(format!(
                "the tolerance may need more than {most} levels, and so many are not looked at; take a \
                 greater one"
            ))
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
            let results = in_threads(round, |&(_, root)| {
                self.work.step();
                if self.work.is_stopped() {
                    return (root, Verdict::Open, 0);
                }
                let mut search = self.search(&judge, level, PIECE_STEPS);
                let verdict = search.examine(model.rounded_cell(root));
                (root, verdict, PIECE_STEPS - search.steps)
            });
            for (root, verdict, steps) in results {
                left.rounded = left.rounded.saturating_sub(steps);
                match verdict {
                    Verdict::Within => {}
                    Verdict::Beyond(place) => {
                        found.beyond = Some(model.rounded_place(level, &place));
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
        roots: &[usize],
        left: &mut Left,
        found: &mut Found,
    ) {
        let model = &self.model;
        let judge = model.exact_judge(tolerance);
        let steps = left.exact / 2;
        let mut search = self.search(&judge, level, steps);
        for &root in roots {
            if search.steps == 0 || self.work.is_stopped() {
                found.open = true;
                break;
            }
            found.exact_pieces += 1;
            match search.examine(model.exact_cell(root)) {
                Verdict::Within => {}
                Verdict::Beyond(place) => {
                    found.beyond = Some(model.exact_place(level, &place));
                    break;
                }
                Verdict::Open => found.open = true,
            }
        }
        left.exact -= steps - search.steps;
    }

    pub(super) fn search<'a, J>(&'a self, judge: &'a J, level: u32, steps: u64) -> Search<'a, J> {
        let [_, deepest] = self.model.most_levels(MAX_DEPTH_LEVEL);
        let deepest = deepest.min(level + EXTRA_LEVELS);
        Search { directions: &self.model.directions, judge, level, deepest, steps }
    }
}

/// How many levels after that of the net pieces are divided.
const EXTRA_LEVELS: u32 = 30;

/// Refuses a tolerance that is not positive.
pub(super) fn positive(tolerance: &Rational) -> Result<(), NetError> {
    if tolerance.sign() > 0 {
        return Ok(());
    }
    Err(NetError::TooMuch(format!("the tolerance must be positive, and is {tolerance}")))
}
