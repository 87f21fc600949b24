//! The Fourier blocks of a ring.

use super::circulant::Circulant;
use super::error::SpectrumError;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::scheme::LocalRules;

/// The points p, p + step, …: n points that the rotation permutes, or a single point.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    /// The points in the order of the rotation.
    pub(super) points: Vec<usize>,
}

/// A ring with a rotation of order n. Cycle a has the points (a, i), i = 0, …, n−1, or one.
///
/// The vectors with x_{(a,i)} = ω^{ik} y_a, ω = e^{2πi/n}, where y_a = 0 for a single point unless k = 0,
/// are mapped to vectors of this form by the refinement: y' = M̂_k y with the block
///
/// M̂_k\[a\]\[b\] = Σ_d m_{(a,0),(b,d)} ω^{dk}.
///
/// Every vector is a sum of such vectors, so that the eigenvalues of the ring are those of the blocks
/// k = 0, …, n−1.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    pub(super) order: usize,
    pub(super) cycles: Vec<Cycle>,
    /// For the cycles of n points, in order: the blocks of all k as circulant matrices.
    full: Vec<usize>,
    turning: Vec<Vec<Circulant>>,
    /// Block 0, of all cycles.
    pub(super) still: Vec<Vec<RealCyclotomic>>,
}

impl Blocks {
    pub(super) fn new(ring: &LocalRules) -> Result<Blocks, SpectrumError> {
        let counts = ring.orbits().iter().map(|orbit| orbit.count);
        let order = counts.filter(|&count| count > 1).fold(0, num_integer::gcd);
        if order < 3 {
            return Err(SpectrumError::NoRotation);
        }
        if ring.rotation().is_none() {
            return Err(SpectrumError::NotSymmetric);
        }
        let cycles = cycles(ring, order);
        let full: Vec<usize> =
            (0..cycles.len()).filter(|&cycle| cycles[cycle].points.len() == order).collect();
        let weight = |a: &Cycle, point: usize| ring.weights().entry(a.points[0], point).clone();
        let circulant = |&a: &usize, &b: &usize| {
            let (a, b) = (&cycles[a], &cycles[b]);
            Circulant::new(order, b.points.iter().map(|&point| weight(a, point)).enumerate())
        };
        let turning = full.iter().map(|a| full.iter().map(|b| circulant(a, b)).collect()).collect();
        let sum = |a: &Cycle, b: &Cycle| {
            let terms: Vec<RealCyclotomic> =
                b.points.iter().map(|&point| weight(a, point)).collect();
            RealCyclotomic::total(&terms)
        };
        let still = cycles.iter().map(|a| cycles.iter().map(|b| sum(a, b)).collect()).collect();
        Ok(Blocks { order, cycles, full, turning, still })
    }

    /// The cycles of n points.
    pub(super) fn full(&self) -> &[usize] {
        &self.full
    }

    /// The blocks of all k, with a row and a column for each cycle of n points.
    pub(super) fn turning(&self) -> &[Vec<Circulant>] {
        &self.turning
    }

    /// The least sets of cycles of n points that depend on each other, each with numbers into
    /// [`full`](Self::full).
    pub(super) fn turning_components(&self) -> Vec<Vec<usize>> {
        components(self.full.len(), |a, b| !self.turning[a][b].is_zero())
    }

    /// The least sets of cycles that depend on each other.
    pub(super) fn still_components(&self) -> Vec<Vec<usize>> {
        components(self.cycles.len(), |a, b| self.still[a][b].sign() != 0)
    }

    /// The cycles of n points that those of `from` depend on, at once or through others, and `from`
    /// itself.
    pub(super) fn turning_sources(&self, from: &[usize]) -> Vec<usize> {
        reached(self.full.len(), from, |a, b| !self.turning[a][b].is_zero())
    }
}

/// In an orbit of tn points, the rotation takes point i to point i + t.
fn cycles(ring: &LocalRules, order: usize) -> Vec<Cycle> {
    let (mut cycles, mut first) = (Vec::new(), 0);
    for orbit in ring.orbits() {
        let count = orbit.count;
        let step = if count == 1 { 1 } else { count / order };
        for start in 0..step {
            let points = (start..count).step_by(step).map(|i| first + i).collect();
            cycles.push(Cycle { points });
        }
        first += count;
    }
    cycles
}

/// The numbers below `count` that are reached from some of them, in ascending order.
fn reached(count: usize, from: &[usize], edge: impl Fn(usize, usize) -> bool) -> Vec<usize> {
    let mut found = vec![false; count];
    let mut waiting = from.to_vec();
    while let Some(next) = waiting.pop() {
        if !std::mem::replace(&mut found[next], true) {
            waiting.extend((0..count).filter(|&other| edge(next, other)));
        }
    }
    (0..count).filter(|&i| found[i]).collect()
}

/// The strongly connected components of a graph of few vertices.
fn components(count: usize, edge: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let reach: Vec<Vec<usize>> = (0..count).map(|i| reached(count, &[i], &edge)).collect();
    let both = |i: usize, j: usize| reach[i].contains(&j) && reach[j].contains(&i);
    let first = |i: &usize| (0..*i).all(|j| !both(*i, j));
    (0..count).filter(first).map(|i| (0..count).filter(|&j| both(i, j)).collect()).collect()
}

/// The part of a matrix with these rows and columns.
pub(super) fn part<T: Clone>(matrix: &[Vec<T>], places: &[usize]) -> Vec<Vec<T>> {
    let row = |&a: &usize| places.iter().map(|&b| matrix[a][b].clone()).collect();
    places.iter().map(row).collect()
}

/// cos(2πj/n) for j = 0, …, n−1.
pub(super) fn cosines(n: usize) -> Vec<RealCyclotomic> {
    let cosine = |j| RealCyclotomic::cosine(&Rational::new(j, n));
    (0..n).map(|j| cosine(j).expect("at most as many points as a ring may have")).collect()
}
