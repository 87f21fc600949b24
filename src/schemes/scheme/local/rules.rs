//! Rings: valence-dependent rules around an extraordinary vertex or face.

use crate::cap::Cap;
use crate::exact::{Matrix, Rational, RealCyclotomic, Scalar};
use std::collections::{BTreeSet, HashSet};
use std::fmt::Display;
use std::hash::Hash;

/// The greatest number of points of a ring.
pub const MAX_LOCAL_POINTS: usize = 600;

/// The points of one kind, such as the N edge points around a vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Orbit {
    /// The name of the points.
    pub name: String,
    /// The number of points.
    pub count: usize,
}

/// The v points around an extraordinary vertex or face, and the v points in the same
/// arrangement that one refinement step gives:
///
/// `x'_a = Σ_b m_{a,b} x_b`, `Σ_b m_{a,b} = 1`, a, b = 0, …, v−1.
///
/// The points are numbered orbit by orbit. The edges form a connected mesh. They
/// determine the differences x_a − x_b in the constants of
/// [`LocalConstants`](crate::bound::LocalConstants).
///
/// Source of the setting: Doo and Sabin 1978; Catmull and Clark 1978.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalRules<S = RealCyclotomic> {
    orbits: Vec<Orbit>,
    weights: Matrix<S>,
    edges: Vec<(usize, usize)>,
}

/// Why a table of numbers is not a ring.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LocalError {
    /// Fewer than 2 or more than [`MAX_LOCAL_POINTS`] points.
    #[error("a ring of {0} points; there must be from 2 to {MAX_LOCAL_POINTS}")]
    Points(usize),
    /// The weights are not a v×v matrix for v points.
    #[error("the weights of a ring of {points} points must be {points} rows of {points}")]
    Shape {
        /// v.
        points: usize,
    },
    /// A new point that is not an affine combination.
    #[error(
        "the weights of the new point {point} sum to {sum}, not to 1: their excess is {excess}; \
         the weights of every new point must sum to 1"
    )]
    NotAffine {
        /// The name of the point.
        point: String,
        /// The sum.
        sum: String,
        /// The sum minus 1.
        excess: String,
    },
    /// An edge with an end that is not a point.
    #[error("an edge ends at point {point}; the points are numbered from 0 to {last}")]
    NoPoint {
        /// The end.
        point: usize,
        /// v − 1.
        last: usize,
    },
    /// An edge from a point to itself.
    #[error("an edge joins the point {0} to itself; take a greater valence, or leave it out")]
    Loop(String),
    /// A mesh that is not connected.
    #[error(
        "no edges lead from {first} to {point}; the mesh of a ring must be connected: add the \
         edges between its pieces"
    )]
    Disconnected {
        /// The first point.
        first: String,
        /// A point that is not connected to the first one.
        point: String,
    },
}

impl LocalError {
    /// The cap that the ring is beyond, if this is what is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            LocalError::Points(points) if *points > MAX_LOCAL_POINTS => {
                Some(Cap::new("the number of points of a ring", MAX_LOCAL_POINTS as u64))
            }
            _ => None,
        }
    }
}

impl<S: Scalar + Eq + Hash + Display> LocalRules<S> {
    /// The ring with these orbits, one row of weights for each new point, and these
    /// edges. Of several edges between the same two points the first is kept.
    ///
    /// # Errors
    /// When there are too few or too many points, the weights are not v rows of v that
    /// each sum to 1, or the edges do not form a connected mesh.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::scheme::{Orbit, LocalRules};
    ///
    /// // Each new corner of a triangle is 1/2 old corner, 1/4 of each of the others.
    /// let (half, quarter) = (Rational::new(1, 2), Rational::new(1, 4));
    /// let row = |a: usize| (0..3).map(|b| if a == b { &half } else { &quarter }.clone()).collect();
    /// let corner = Orbit { name: "corner".to_owned(), count: 3 };
    /// let ring = LocalRules::new(vec![corner], (0..3).map(row).collect(), vec![(0, 1), (1, 2), (2, 0)])?;
    /// assert_eq!(ring.refine(&[4, 0, 0].map(Rational::from)), [2, 1, 1].map(Rational::from));
    /// assert_eq!(ring.name(2), "corner[2]");
    /// # Ok::<(), subcert::scheme::LocalError>(())
    /// ```
    pub fn new(
        orbits: Vec<Orbit>,
        weights: Vec<Vec<S>>,
        edges: Vec<(usize, usize)>,
    ) -> Result<LocalRules<S>, LocalError> {
        let points = check_count(&orbits)?;
        if weights.len() != points || weights.iter().any(|row| row.len() != points) {
            return Err(LocalError::Shape { points });
        }
        LocalRules::with_weights(orbits, Matrix::from_rows(weights), edges)
    }

    /// [`LocalRules::new`] with the weights as a matrix.
    ///
    /// # Errors
    /// As [`LocalRules::new`].
    pub fn with_weights(
        orbits: Vec<Orbit>,
        weights: Matrix<S>,
        edges: Vec<(usize, usize)>,
    ) -> Result<LocalRules<S>, LocalError> {
        let points = check_count(&orbits)?;
        if weights.row_count() != points || weights.names().iter().any(|row| row.len() != points) {
            return Err(LocalError::Shape { points });
        }
        let ring = LocalRules { orbits, weights, edges: without_repetition(edges) };
        ring.check_sums()?;
        ring.check_edges()?;
        Ok(ring)
    }

    /// Rows that are permutations of each other have the same sum, so only the first of
    /// them is summed.
    fn check_sums(&self) -> Result<(), LocalError> {
        let (one, mut seen) = (S::from_rational(&Rational::one()), HashSet::new());
        for (point, names) in self.weights.names().iter().enumerate() {
            let mut counts = vec![0_u32; self.weights.values().len()];
            for &name in names {
                counts[name as usize] += 1;
            }
            if !seen.insert(counts.clone()) {
                continue;
            }
            let terms = self.weights.values().iter().zip(counts).filter(|(_, count)| *count > 0);
            let terms = terms.map(|(value, count)| value.times(&S::from_rational(&count.into())));
            let sum = S::total(&terms.collect::<Vec<S>>());
            if sum != one {
                let (point, excess) = (self.name(point), sum.minus(&one).to_string());
                return Err(LocalError::NotAffine { point, sum: sum.to_string(), excess });
            }
        }
        Ok(())
    }
}

/// The number of points, an error if it is out of range.
fn check_count(orbits: &[Orbit]) -> Result<usize, LocalError> {
    let points = orbits.iter().fold(0_usize, |sum, orbit| sum.saturating_add(orbit.count));
    if !(2..=MAX_LOCAL_POINTS).contains(&points) {
        return Err(LocalError::Points(points));
    }
    Ok(points)
}

impl<S> LocalRules<S> {
    /// The orbits, in the order in which the points are numbered.
    #[must_use]
    pub fn orbits(&self) -> &[Orbit] {
        &self.orbits
    }

    /// The number v of points.
    #[must_use]
    pub fn point_count(&self) -> usize {
        self.weights.row_count()
    }

    /// The matrix m, with one row for each new point.
    #[must_use]
    pub fn weights(&self) -> &Matrix<S> {
        &self.weights
    }

    /// The number of nonzero weights, which is the number of products in one refinement.
    #[must_use]
    pub fn product_count(&self) -> usize {
        self.weights.names().iter().flatten().filter(|name| **name != 0).count()
    }

    /// The edges, as pairs of points, each once.
    #[must_use]
    pub fn edges(&self) -> &[(usize, usize)] {
        &self.edges
    }

    /// The name of a point: its orbit and index, as `edge[3]`, or only the orbit, as
    /// `vertex`, if it has a single point.
    ///
    /// # Panics
    /// When there is no such point.
    #[must_use]
    pub fn name(&self, point: usize) -> String {
        point_name(&self.orbits, point)
    }

    /// The ring with `map` applied to every weight. `map` may round, and must send 0
    /// to 0. The sums of the weights are not checked again.
    #[must_use]
    pub fn map<T>(&self, map: impl FnMut(&S) -> T) -> LocalRules<T> {
        let (orbits, edges) = (self.orbits.clone(), self.edges.clone());
        LocalRules { orbits, weights: self.weights.map(map), edges }
    }

    fn check_edges(&self) -> Result<(), LocalError> {
        let count = self.point_count();
        let mut neighbours = vec![Vec::new(); count];
        for &(a, b) in &self.edges {
            if a.max(b) >= count {
                return Err(LocalError::NoPoint { point: a.max(b), last: count - 1 });
            }
            if a == b {
                return Err(LocalError::Loop(self.name(a)));
            }
            neighbours[a].push(b);
            neighbours[b].push(a);
        }
        let mut reached = vec![false; count];
        reached[0] = true;
        let mut waiting = vec![0];
        while let Some(point) = waiting.pop() {
            for &next in &neighbours[point] {
                if !std::mem::replace(&mut reached[next], true) {
                    waiting.push(next);
                }
            }
        }
        match reached.iter().position(|reached| !reached) {
            Some(point) => {
                Err(LocalError::Disconnected { first: self.name(0), point: self.name(point) })
            }
            None => Ok(()),
        }
    }
}

impl<S: Scalar> LocalRules<S> {
    /// M x: the new points `x'_a = Σ_b m_{a,b} x_b`.
    ///
    /// # Panics
    /// When there are not v points.
    #[must_use]
    pub fn refine(&self, points: &[S]) -> Vec<S> {
        assert_eq!(points.len(), self.point_count(), "a ring has as many control points as rows");
        self.weights.product(points)
    }

    /// wᵀM, with `(wᵀM)_b = Σ_a w_a m_{a,b}`: the functional w of the new points, written
    /// as a functional of the old points.
    ///
    /// # Panics
    /// When w does not have v coefficients.
    #[must_use]
    pub fn pull_back(&self, functional: &[S]) -> Vec<S> {
        assert_eq!(functional.len(), self.point_count(), "a coefficient for each point");
        self.weights.left_product(functional)
    }
}

/// The [`LocalRules::name`] of a point of these orbits.
pub(crate) fn point_name(orbits: &[Orbit], point: usize) -> String {
    let mut index = point;
    for Orbit { name, count } in orbits {
        if index < *count {
            return if *count == 1 { name.clone() } else { format!("{name}[{index}]") };
        }
        index -= count;
    }
    panic!("no orbit has the point {point}")
}

fn without_repetition(edges: Vec<(usize, usize)>) -> Vec<(usize, usize)> {
    let mut seen = BTreeSet::new();
    edges.into_iter().filter(|&(a, b)| seen.insert((a.min(b), a.max(b)))).collect()
}
