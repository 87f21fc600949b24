//! The limit of a ring: the common limit of all its points.

use crate::bound::{LocalWork, MAX_LOCAL_WORK, Transport, transport};
use crate::exact::{Rational, Real, RealCyclotomic, format, only_solution};
use crate::formula::Value;
use crate::limit::error::MAX_LEVEL;
use crate::scheme::LocalRules;
use std::iter::successors;

/// The greatest c for which T_c is computed.
const MAX_BLOCK: u32 = 32;

/// Why a ring has no limit, or no depth.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalLimitError {
    /// 1 is not a simple eigenvalue of the matrix of the ring.
    #[error("the ring has no limit: 1 is a multiple eigenvalue of its matrix")]
    NoLimit,
    /// No computed T_c is below 1.
    #[error(
        "the points of the ring are not shown to have one limit: the least contraction constant \
         T_c for c from 1 to {blocks} is {least}, and one below 1 is needed"
    )]
    NotShown {
        /// The greatest c tried.
        blocks: u32,
        /// The least T_c.
        least: String,
    },
    /// A linear system whose solution is beyond [`MAX_LOCAL_WORK`].
    #[error(
        "the limit of the ring takes the solution of {unknowns} equations, which is too much \
         work: at most {MAX_LOCAL_WORK} is done"
    )]
    Unknowns {
        /// The number of equations.
        unknowns: usize,
    },
    /// Powers beyond [`MAX_LOCAL_WORK`].
    #[error(transparent)]
    Work(#[from] LocalWork),
    /// A level beyond [`MAX_LEVEL`].
    #[error("level {0} is too high; at most {MAX_LEVEL} is")]
    Level(u32),
    /// A tolerance or a spread that must be positive.
    #[error("{what} must be positive, and is {value}")]
    NotPositive {
        /// What must be positive.
        what: &'static str,
        /// Its value.
        value: String,
    },
    /// No level up to [`MAX_LEVEL`] is deep enough.
    #[error("no level up to {MAX_LEVEL} meets the tolerance: ask for a greater tolerance")]
    TooDeep,
}

/// The exact limit of a ring x' = Mx, given by [`LocalRules`]. If T_c < 1 for some c, all
/// points tend to the same limit Σ_b w_b x_b. Here w is the only vector with wᵀM = wᵀ and
/// Σ_b w_b = 1.
///
/// Source: `proofs/THEOREMS.md`, 20.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::LocalLimit;
/// use subcert::scheme::parse_local_rules;
///
/// // A vertex of valence 4 is regular: (16, 4, 1)/36.
/// let limit = LocalLimit::new(&parse_local_rules("catmull-clark:N=4")?)?;
/// let weights = [16, 4, 4, 4, 4, 1, 1, 1, 1].map(|p| Rational::new(p, 36).into());
/// assert_eq!(limit.weights(), weights);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LocalLimit<S = RealCyclotomic> {
    ring: LocalRules<S>,
    weights: Vec<S>,
    contraction: Vec<S>,
}

impl<S: Real + Ord + Value> LocalLimit<S> {
    /// The limit of this ring.
    ///
    /// The linear system has one unknown for each orbit of points under the
    /// [rotation](LocalRules::rotation) of the ring. T_c is computed for c = 1, 2, …, 32 until
    /// it is below 1.
    ///
    /// # Errors
    /// When 1 is a multiple eigenvalue of M, so that there is no limit; when no computed
    /// T_c is below 1; when the work for the powers of M or for the linear system is
    /// above [`MAX_LOCAL_WORK`].
    pub fn new(ring: &LocalRules<S>) -> Result<LocalLimit<S>, LocalLimitError> {
        let weights = left_eigenvector(ring)?;
        let contraction = contraction_constants(ring)?;
        Ok(LocalLimit { ring: ring.clone(), weights, contraction })
    }

    /// The ring.
    #[must_use]
    pub fn ring(&self) -> &LocalRules<S> {
        &self.ring
    }

    /// w, the left eigenvector for 1 with Σ_b w_b = 1.
    #[must_use]
    pub fn weights(&self) -> &[S] {
        &self.weights
    }

    /// T_0 = 1, T_1, …, T_c, where T_c is the first one below 1.
    #[must_use]
    pub fn contraction(&self) -> &[S] {
        &self.contraction
    }

    /// Σ_b w_b x_b.
    ///
    /// # Panics
    /// When the number of points is not v.
    #[must_use]
    pub fn of(&self, points: &[S]) -> S {
        assert_eq!(points.len(), self.weights.len(), "a control point for each weight");
        let terms: Vec<S> = self.weights.iter().zip(points).map(|(w, x)| w.times(x)).collect();
        S::total(&terms)
    }
}

/// A functional of rings whose coefficients sum to 0, with the point or edge to which it
/// belongs.
pub(super) type Labelled<S, L> = (L, Vec<S>);

/// The functionals fᵀ, fᵀM, fᵀM², ….
pub(super) fn pulled_back<S: Real, L: Copy>(
    ring: &LocalRules<S>,
    functionals: Vec<Labelled<S, L>>,
) -> impl Iterator<Item = Vec<Labelled<S, L>>> {
    let next = |now: &Vec<Labelled<S, L>>| {
        Some(now.iter().map(|(label, f)| (*label, ring.pull_back(f))).collect())
    };
    successors(Some(functionals), next)
}

/// The first functional with the greatest norm ‖·‖_*, as its label and its norm.
pub(super) fn greatest<S: Real + Ord, L: Copy>(
    ring: &LocalRules<S>,
    functionals: &[Labelled<S, L>],
) -> (L, Transport<S>) {
    let norm = |(label, f): &Labelled<S, L>| {
        (*label, transport(f, ring.edges()).expect("the mesh of a ring is connected"))
    };
    let norms = functionals.iter().map(norm);
    let greater = |best: (L, Transport<S>), next: (L, Transport<S>)| {
        if next.1.value > best.1.value { next } else { best }
    };
    norms.reduce(greater).expect("a ring has points and edges")
}

/// e_a − e_b for representatives (a, b) of the edges under the rotation.
pub(super) fn edge_differences<S: Real + PartialEq>(
    ring: &LocalRules<S>,
) -> Vec<Labelled<S, (usize, usize)>> {
    let one = S::from_rational(&Rational::one());
    let edge = |(a, b): (usize, usize)| {
        let mut f = vec![S::zero(); ring.point_count()];
        (f[a], f[b]) = (one.clone(), S::zero().minus(&one));
        ((a, b), f)
    };
    ring.representatives().edges.into_iter().map(edge).collect()
}

fn contraction_constants<S: Real + Ord + Value>(
    ring: &LocalRules<S>,
) -> Result<Vec<S>, LocalLimitError> {
    let one = S::from_rational(&Rational::one());
    let edges = edge_differences(ring);
    let mut constants = vec![one.clone()];
    let count = edges.len();
    let mut powers = pulled_back(ring, edges).skip(1);
    for c in 1..=MAX_BLOCK {
        // c products for each edge, which `check` counts as c + 1 levels.
        LocalWork::check(ring, count, c + 1)?;
        let differences = powers.next().expect("there is no last power");
        constants.push(greatest(ring, &differences).1.value);
        if constants[c as usize] < one {
            return Ok(constants);
        }
    }
    let least = constants.into_iter().skip(1).min().unwrap_or(one);
    let least = least.as_rational().map_or_else(|| "above 1".to_owned(), |q| format::short(&q, 6));
    Err(LocalLimitError::NotShown { blocks: MAX_BLOCK, least })
}

/// The w with wᵀM = wᵀ and Σ w_b = 1, if there is exactly one. It is invariant under the
/// rotation, so one unknown for each orbit is enough. One equation follows from the
/// others, since the rows of M sum to 1; it is replaced by Σ w_b = 1.
fn left_eigenvector<S: Real + Ord + Value>(
    ring: &LocalRules<S>,
) -> Result<Vec<S>, LocalLimitError> {
    let representatives = ring.representatives().points;
    let classes = classes(ring, &representatives);
    let unknowns = representatives.len();
    let weights = ring.weights();
    let entries = weights.values().iter();
    let field = entries.clone().map(|m| u64::from(m.conductor()).pow(2)).max().unwrap_or(1);
    let size = entries.map(|m| m.product_size(m)).max().unwrap_or(1).max(field);
    let work = (unknowns as u64).saturating_pow(4).saturating_mul(size);
    if work > MAX_LOCAL_WORK {
        return Err(LocalLimitError::Unknowns { unknowns });
    }
    let one = S::from_rational(&Rational::one());
    let mut rows = vec![vec![S::zero(); unknowns + 1]; unknowns];
    for &class in &classes {
        rows[0][class] = rows[0][class].plus(&one);
    }
    rows[0][unknowns] = one.clone();
    for (d, &b) in representatives.iter().enumerate().skip(1) {
        for (a, &class) in classes.iter().enumerate() {
            rows[d][class] = rows[d][class].plus(weights.entry(a, b));
        }
        rows[d][d] = rows[d][d].minus(&one);
    }
    let solution = only_solution(rows).ok_or(LocalLimitError::NoLimit)?;
    Ok(classes.into_iter().map(|class| solution[class].clone()).collect())
}

/// For each point, the index of its representative.
fn classes<S>(ring: &LocalRules<S>, representatives: &[usize]) -> Vec<usize> {
    let image = ring.rotation().unwrap_or_else(|| (0..ring.point_count()).collect());
    let mut classes = vec![0; ring.point_count()];
    for (class, &first) in representatives.iter().enumerate() {
        classes[first] = class;
        let mut point = image[first];
        while point != first {
            classes[point] = class;
            point = image[point];
        }
    }
    classes
}

/// An error for a level beyond [`MAX_LEVEL`], and for powers that are too much work.
pub(super) fn check_level<S: Value + Real>(
    ring: &LocalRules<S>,
    rows: usize,
    level: u32,
) -> Result<(), LocalLimitError> {
    if level > MAX_LEVEL {
        return Err(LocalLimitError::Level(level));
    }
    Ok(LocalWork::check(ring, rows, level + 1)?)
}
