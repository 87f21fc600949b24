//! How far the points of a ring are from its limit, level by level.

use super::comparison::Comparison;
use super::error::MAX_LEVEL;
use super::local_rules::{
    Labelled, LocalLimit, LocalLimitError, check_level, edge_differences, greatest, pulled_back,
};
use crate::bound::transport;
use crate::exact::{Rational, Real, RealCyclotomic, format};
use crate::formula::Value;
use crate::scheme::LocalRules;

/// A distance of a ring, and what attains it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocalWitness<S = RealCyclotomic> {
    /// A control ring of integers, neighbours of which differ by at most 1.
    pub ring: Vec<i64>,
    /// k.
    pub level: u32,
    /// The point that is so far away.
    pub point: usize,
    /// How far.
    pub distance: S,
}

/// The depth of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LocalDepth {
    /// The least level that meets the tolerance.
    pub level: u32,
    /// The least level from which on all meet it.
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
/// On a face all points tend to the limit at its centre, and the papers compare the
/// points of a level with those of the next one by their names: C_k is what they bound.
/// Around a vertex only the vertex stays where it is; there
/// [`at_point`](LocalDistances::at_point) of the vertex is the distance of mesh and limit
/// surface, and a lower bound of their greatest distance. That of other points is from
/// the limit of the vertex, not from that at their own parameter.
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
    /// e_a − w, for the points a up to the rotation.
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

    /// For every point a, a flow along the [edges](LocalRules::edges) that carries e_aᵀM^k − wᵀ and
    /// costs C_k at most: Σ_e |f_e| ≥ |x^k_a − Σ_b w_b x_b| for each ring of differences of 1 at
    /// most.
    ///
    /// # Errors
    /// As of [`LocalDistances::constant`].
    pub fn flows(&self, level: u32) -> Result<Vec<Vec<S>>, LocalLimitError> {
        least_flows(self.limit.ring(), self.limit.errors(), level)
    }

    /// ‖e_aᵀM^k − wᵀ‖_*, of the point a alone.
    ///
    /// # Errors
    /// As of [`LocalDistances::constant`].
    ///
    /// # Panics
    /// When there is no such point.
    pub fn at_point(&self, point: usize, level: u32) -> Result<LocalWitness<S>, LocalLimitError> {
        self.at_level(vec![(point, self.limit.error(point))], level)
    }

    /// max_a ‖e_aᵀM^{k+1} − e_aᵀM^k‖_*: the least number with |x^{k+1}_a − x^k_a| at most
    /// that times β, for all points a and control rings x.
    ///
    /// # Errors
    /// As of [`LocalDistances::constant`].
    pub fn step(&self, level: u32) -> Result<LocalWitness<S>, LocalLimitError> {
        self.at_level(self.steps(), level)
    }

    /// The same for the points of level k + 1 and what `interpolant`, a ring of as many
    /// points, makes of those of level k, such as the midpoints of edges and the centroids
    /// of faces: max_a ‖(e_aᵀM − e_aᵀL)M^k‖_*.
    ///
    /// # Errors
    /// As of [`LocalDistances::constant`].
    ///
    /// # Panics
    /// When the rings do not have as many points.
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
    /// As of [`LocalDistances::constant`].
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
    /// It holds when it does for k < c and T_c ≤ q^c, as C_{k+c} ≤ T_c C_k. `None` when
    /// neither that nor a level that exceeds it is found for c and k up to `last`.
    ///
    /// # Errors
    /// As of [`LocalDistances::constant`] for k = `last`.
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

    /// The same for the [steps](LocalDistances::step): whether that of level k is at most
    /// A q^k for all k.
    ///
    /// # Errors
    /// As of [`LocalDistances::geometric`].
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
            // Here the levels before this one are known to be within.
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

    /// The least k with C_k·spread ≤ tolerance, and the least one from which on all meet
    /// it. C_k may rise, but C_{k+c} ≤ T_c C_k: after c levels that meet it no later one
    /// does not, and after a single one where no weight is negative.
    ///
    /// # Errors
    /// When the tolerance or the spread is not positive, or no level up to 128 meets the
    /// tolerance; as of [`LocalDistances::constant`].
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

    /// A c such that after c levels within a bound all later ones are.
    pub(crate) fn lasting(&self) -> u32 {
        if self.averages() { 1 } else { self.block().0 }
    }

    /// Whether no weight is negative.
    pub(crate) fn averages(&self) -> bool {
        let zero = S::zero();
        self.limit.ring().weights().values().iter().all(|weight| *weight >= zero)
    }

    /// The first c with T_c < 1, and T_c.
    fn block(&self) -> (u32, &S) {
        let constants = (0..).zip(self.limit.contraction());
        constants.last().expect("T_0 and at least T_1")
    }

    /// e_aᵀM − e_a, for the points a up to the rotation.
    fn steps(&self) -> Vec<Labelled<S, usize>> {
        let rows = self.limit.ring().weights();
        let step =
            |(a, _): &Labelled<S, usize>| (*a, minus(rows.row(*a), &unit(rows.row_count(), *a)));
        self.errors.iter().map(step).collect()
    }

    /// The greatest norm of the functionals f, each as that fᵀM^k of the control ring.
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

/// For each functional f of which the coefficients sum to 0, a flow along the [edges](LocalRules::edges)
/// that carries fᵀM^k at the least cost, ‖fᵀM^k‖_*.
///
/// # Errors
/// As of [`LocalDistances::constant`].
///
/// # Panics
/// When a functional is another one.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::limit::least_flows;
/// use subcert::scheme::parse_local_rules;
///
/// // Two levels later the difference along an edge of a square is at most 5/32 + 3/32 of
/// // those along this one and the opposite one.
/// let square = parse_local_rules("doo-sabin:n=4")?;
/// let difference = [1, -1, 0, 0].map(RealCyclotomic::from).to_vec();
/// let flow = [5, 0, -3, 0].map(|p| Rational::new(p, 32).into());
/// assert_eq!(least_flows(&square, vec![difference], 2)?, [flow]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_flows<S: Real + Ord + Value>(
    ring: &LocalRules<S>,
    functionals: Vec<Vec<S>>,
    level: u32,
) -> Result<Vec<Vec<S>>, LocalLimitError> {
    check_level(ring, functionals.len(), level)?;
    let functionals = functionals.into_iter().map(|f| ((), f)).collect();
    let after = pulled_back(ring, functionals).nth(level as usize);
    let flow = |((), f): &Labelled<S, ()>| {
        transport(f, ring.edges()).expect("coefficients that sum to 0").flow
    };
    Ok(after.expect("there is no last level").iter().map(flow).collect())
}

impl<S: Real + Ord + Value> LocalLimit<S> {
    /// e_a − w for every point a.
    pub(crate) fn errors(&self) -> Vec<Vec<S>> {
        (0..self.weights().len()).map(|a| self.error(a)).collect()
    }

    fn error(&self, point: usize) -> Vec<S> {
        minus(&unit(self.weights().len(), point), self.weights())
    }
}

/// e_a.
pub(crate) fn unit<S: Real>(count: usize, at: usize) -> Vec<S> {
    let entry = |b| S::from_rational(&Rational::from(u32::from(b == at)));
    (0..count).map(entry).collect()
}

/// The difference of two functionals.
pub(crate) fn minus<'a, S: Real + 'a>(
    left: impl IntoIterator<Item = &'a S>,
    right: impl IntoIterator<Item = &'a S>,
) -> Vec<S> {
    left.into_iter().zip(right).map(|(x, y)| x.minus(y)).collect()
}
