//! The distances of the points of a ring from its limit, level by level.

use super::flows::{least_flows, minus, unit};
use super::limit::{
    Labelled, LocalLimit, LocalLimitError, check_level, edge_differences, greatest, pulled_back,
};
use crate::exact::{Rational, Real, RealCyclotomic, format};
use crate::formula::Value;
use crate::limit::distances::comparison::Comparison;
use crate::limit::error::MAX_LEVEL;
use crate::scheme::LocalRules;

/// A distance of a ring, with a point and a control ring that attain it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocalWitness<S = RealCyclotomic> {
    /// A control ring of integers that differ by at most 1 along edges.
    pub ring: Vec<i64>,
    /// k.
    pub level: u32,
    /// The point a.
    pub point: usize,
    /// The distance of the point.
    pub distance: S,
}

/// The depth of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LocalDepth {
    /// The least level that meets the tolerance.
    pub level: u32,
    /// The least level from which on all levels meet the tolerance.
    pub settled: u32,
}

/// The exact distances of the points of a ring from its limit, per unit of β, the
/// largest |x_a − x_b| over the edges (a, b) of the control ring:
///
/// C_k = max_a ‖e_aᵀM^k − wᵀ‖_*,
///
/// the least number with |x^k_a − Σ_b w_b x_b| ≤ C_k β for all points a and control
/// rings x, attained by a ring of integers.
///
/// The points of a face all tend to the limit at its centre. The papers compare a point
/// of one level with the point of the same name at the next level; C_k is the quantity
/// that they bound. Around a vertex, only the vertex itself keeps its parameter. There
/// [`at_point`](LocalDistances::at_point) of the vertex is the distance between mesh and
/// limit surface at the vertex, and a lower bound of their greatest distance. For the
/// other points, C_k measures the distance from the limit of the vertex, not from the
/// limit at their own parameter.
///
/// Source: `proofs/THEOREMS.md`, 21–23.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::{LocalDistances, LocalLimit};
/// use subcert::scheme::parse_local_rules;
///
/// let distances = LocalDistances::new(LocalLimit::new(&parse_local_rules("doo-sabin:n=4")?)?);
/// // A square face is biquadratic: its corners halve their distance from the centroid.
/// let worst = distances.constant(2)?;
/// assert_eq!(worst.distance, Rational::new(1, 4).into());
/// assert_eq!((worst.point, worst.ring), (0, vec![2, 1, 0, 1]));
/// let depth = distances.depth(&Rational::new(1, 10), &Rational::new(1, 1000))?;
/// assert_eq!((depth.level, depth.settled), (7, 7));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LocalDistances<S = RealCyclotomic> {
    limit: LocalLimit<S>,
    /// e_a − w, for representatives a of the points under the rotation.
    errors: Vec<Labelled<S, usize>>,
}

impl<S: Real + Ord + Value> LocalDistances<S> {
    /// The distances from this limit.
    #[must_use]
    pub fn new(limit: LocalLimit<S>) -> LocalDistances<S> {
        let points = limit.ring().representatives().points;
        let errors = points.into_iter().map(|a| (a, limit.error(a))).collect();
        LocalDistances { limit, errors }
    }

    /// The limit.
    #[must_use]
    pub fn limit(&self) -> &LocalLimit<S> {
        &self.limit
    }

    /// C_k.
    ///
    /// # Errors
    /// When k is above 128, or M^k is more work than
    /// [`MAX_LOCAL_WORK`](crate::bound::MAX_LOCAL_WORK).
    pub fn constant(&self, level: u32) -> Result<LocalWitness<S>, LocalLimitError> {
        self.at_level(self.errors.clone(), level)
    }

    /// For every point a, a flow f along the [edges](LocalRules::edges) that carries e_aᵀM^k − wᵀ
    /// at a cost of at most C_k. The cost Σ_e |f_e| bounds |x^k_a − Σ_b w_b x_b| for every ring
    /// with differences of at most 1 along edges.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`].
    pub fn flows(&self, level: u32) -> Result<Vec<Vec<S>>, LocalLimitError> {
        least_flows(self.limit.ring(), self.limit.errors(), level)
    }

    /// ‖e_aᵀM^k − wᵀ‖_* for a single point a.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`].
    ///
    /// # Panics
    /// When there is no such point.
    pub fn at_point(&self, point: usize, level: u32) -> Result<LocalWitness<S>, LocalLimitError> {
        self.at_level(vec![(point, self.limit.error(point))], level)
    }

    /// max_a ‖e_aᵀM^{k+1} − e_aᵀM^k‖_*: the least number C with |x^{k+1}_a − x^k_a| ≤ Cβ
    /// for all points a and control rings x.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`].
    pub fn step(&self, level: u32) -> Result<LocalWitness<S>, LocalLimitError> {
        self.at_level(self.steps(), level)
    }

    /// max_a ‖(e_aᵀM − e_aᵀL)M^k‖_*, where L is the matrix of `interpolant`: compares the
    /// points of level k + 1 with the points that `interpolant` computes from level k,
    /// such as midpoints of edges and centroids of faces.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`].
    ///
    /// # Panics
    /// When `interpolant` and the ring have different numbers of points.
    pub fn step_from(
        &self,
        interpolant: &LocalRules<S>,
        level: u32,
    ) -> Result<LocalWitness<S>, LocalLimitError> {
        let rows = self.limit.ring().weights();
        let points = rows.row_count();
        assert_eq!(points, interpolant.point_count(), "an interpolant of as many points");
        let moved = |a: usize| (a, minus(rows.row(a), interpolant.weights().row(a)));
        self.at_level((0..points).map(moved).collect(), level)
    }

    /// Compares C_k with a threshold.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`].
    pub fn compare(
        &self,
        level: u32,
        threshold: &S,
    ) -> Result<Comparison<LocalWitness<S>>, LocalLimitError> {
        let worst = self.constant(level)?;
        Ok(if worst.distance <= *threshold {
            Comparison::Within
        } else {
            Comparison::Exceeds(worst)
        })
    }

    /// Whether C_k ≤ A q^k at all levels k ≥ 0, for a factor A and a ratio q ≥ 0.
    ///
    /// This holds if C_k ≤ A q^k for all k < c, and T_c ≤ q^c, since C_{k+c} ≤ T_c C_k.
    /// `None` if neither such a c nor a k with C_k > A q^k is found up to `last`.
    ///
    /// # Errors
    /// As [`LocalDistances::constant`] for k = `last`.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{Comparison, LocalDistances, LocalLimit};
    /// use subcert::scheme::parse_local_rules;
    ///
    /// let distances = LocalDistances::new(LocalLimit::new(&parse_local_rules("doo-sabin:n=3")?)?);
    /// // The corners of a triangle halve their distance from the centroid.
    /// let [half, third] = [(1, 2), (1, 3)].map(|(p, q)| Rational::new(p, q).into());
    /// let one = Rational::one().into();
    /// assert_eq!(distances.geometric(&one, &half, 8)?, Some(Comparison::Within));
    /// let Some(Comparison::Exceeds(witness)) = distances.geometric(&one, &third, 8)? else {
    ///     return Err("2/3·2^-k is not at most 3^-k".into());
    /// };
    /// assert_eq!((witness.level, witness.distance), (2, Rational::new(1, 6).into()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn geometric(
        &self,
        factor: &S,
        ratio: &S,
        last: u32,
    ) -> Result<Option<Comparison<LocalWitness<S>>>, LocalLimitError> {
        self.all_levels(self.errors.clone(), factor, ratio, last)
    }

    /// Whether the [step](LocalDistances::step) of level k is at most A q^k for all k ≥
    /// 0, as in [`geometric`](LocalDistances::geometric).
    ///
    /// # Errors
    /// As [`LocalDistances::geometric`].
    pub fn geometric_step(
        &self,
        factor: &S,
        ratio: &S,
        last: u32,
    ) -> Result<Option<Comparison<LocalWitness<S>>>, LocalLimitError> {
        self.all_levels(self.steps(), factor, ratio, last)
    }

    fn all_levels(
        &self,
        functionals: Vec<Labelled<S, usize>>,
        factor: &S,
        ratio: &S,
        last: u32,
    ) -> Result<Option<Comparison<LocalWitness<S>>>, LocalLimitError> {
        let ring = self.limit.ring();
        let edges = edge_differences(ring);
        check_level(ring, functionals.len() + edges.len(), last)?;
        let mut power = S::from_rational(&Rational::one());
        let levels = pulled_back(ring, functionals).zip(pulled_back(ring, edges));
        for (level, (functionals, edges)) in (0..=last).zip(levels) {
            // All levels before this one are within the bound.
            if level > 0 && greatest(ring, &edges).1.value <= power {
                return Ok(Some(Comparison::Within));
            }
            let worst = witness(ring, &functionals, level);
            if worst.distance > factor.times(&power) {
                return Ok(Some(Comparison::Exceeds(worst)));
            }
            power = power.times(ratio);
        }
        Ok(None)
    }

    /// The least k with C_k·spread ≤ tolerance, and the least k from which on all levels
    /// satisfy this. C_k may increase, but C_{k+c} ≤ T_c C_k. So for T_c < 1, if c levels
    /// in a row meet the tolerance, all later ones do. If no weight is negative, one
    /// level is enough.
    ///
    /// # Errors
    /// When the tolerance or the spread is not positive, or no level up to 128 is found
    /// from which on all meet the tolerance; and as [`LocalDistances::constant`].
    pub fn depth(
        &self,
        spread: &Rational,
        tolerance: &Rational,
    ) -> Result<LocalDepth, LocalLimitError> {
        for (what, value) in [("the tolerance", tolerance), ("the spread", spread)] {
            if value.sign() <= 0 {
                let value = format::short(value, 6);
                return Err(LocalLimitError::NotPositive { what, value });
            }
        }
        let ring = self.limit.ring();
        let threshold = S::from_rational(&(tolerance / spread));
        let run = self.lasting();
        let (mut first, mut start) = (None, None);
        for (level, errors) in (0..=MAX_LEVEL).zip(pulled_back(ring, self.errors.clone())) {
            check_level(ring, self.errors.len(), level)?;
            if greatest(ring, &errors).1.value > threshold {
                start = None;
                continue;
            }
            let (first, start) = (*first.get_or_insert(level), *start.get_or_insert(level));
            if level + 1 - start >= run {
                return Ok(LocalDepth { level: first, settled: start });
            }
        }
        Err(LocalLimitError::TooDeep)
    }

    /// A c such that, if c levels in a row are within a bound, all later ones are.
    #[must_use]
    pub fn lasting(&self) -> u32 {
        if self.averages() { 1 } else { self.block().0 }
    }

    /// Whether no weight is negative.
    #[must_use]
    pub fn averages(&self) -> bool {
        let zero = S::zero();
        self.limit.ring().weights().values().iter().all(|weight| *weight >= zero)
    }

    /// The first c with T_c < 1, and T_c.
    fn block(&self) -> (u32, &S) {
        let constants = (0..).zip(self.limit.contraction());
        constants.last().expect("T_0 and at least T_1")
    }

    /// e_aᵀM − e_aᵀ, for representatives a of the points under the rotation.
    fn steps(&self) -> Vec<Labelled<S, usize>> {
        let rows = self.limit.ring().weights();
        let step =
            |(a, _): &Labelled<S, usize>| (*a, minus(rows.row(*a), &unit(rows.row_count(), *a)));
        self.errors.iter().map(step).collect()
    }

    /// The greatest ‖fᵀM^k‖_* over the functionals f, with a witness.
    fn at_level(
        &self,
        functionals: Vec<Labelled<S, usize>>,
        level: u32,
    ) -> Result<LocalWitness<S>, LocalLimitError> {
        let ring = self.limit.ring();
        check_level(ring, functionals.len(), level)?;
        let mut levels = pulled_back(ring, functionals).skip(level as usize);
        Ok(witness(ring, &levels.next().expect("there is no last level"), level))
    }
}

fn witness<S: Real + Ord>(
    ring: &LocalRules<S>,
    functionals: &[Labelled<S, usize>],
    level: u32,
) -> LocalWitness<S> {
    let (point, found) = greatest(ring, functionals);
    LocalWitness { ring: found.heights, level, point, distance: found.value }
}
