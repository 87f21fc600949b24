//! Rows of the powers of a ring's matrix, in any arithmetic.

use crate::exact::{Rational, Real, Scalar};
use crate::formula::Value;
use crate::scheme::{LocalRules, Representatives};
use std::collections::{BTreeMap, BTreeSet};

/// The cap on the work r·p·(c−1)·s for the powers of a ring: r rows are multiplied c − 1
/// times by a matrix with p nonzero weights, and a product costs up to s as counted by
/// [`row_product_size`](Value::row_product_size).
pub const MAX_LOCAL_WORK: u64 = 1 << 32;

/// The powers of a ring are beyond [`MAX_LOCAL_WORK`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{levels} levels of this ring of {points} points are too much work, {work} where at most \
     {MAX_LOCAL_WORK} is done: take a smaller number of levels or a smaller valence"
)]
pub struct LocalWork {
    /// The number v of points.
    pub points: usize,
    /// The number c of levels.
    pub levels: u32,
    /// r·p·(c−1)·s.
    pub work: u64,
}

impl LocalWork {
    /// Checks the work of multiplying `rows` rows by the matrix of `ring`, for c = 1, …,
    /// `levels`.
    ///
    /// # Errors
    /// When the work is above [`MAX_LOCAL_WORK`].
    pub fn check<S: Value>(
        ring: &LocalRules<S>,
        rows: usize,
        levels: u32,
    ) -> Result<(), LocalWork> {
        let weights = ring.weights().values().iter();
        let size = weights.map(|weight| weight.row_product_size(levels)).max();
        let work = ((rows * ring.product_count()) as u64)
            .saturating_mul(u64::from(levels.saturating_sub(1)))
            .saturating_mul(size.unwrap_or(1));
        if work <= MAX_LOCAL_WORK {
            return Ok(());
        }
        Err(LocalWork { points: ring.point_count(), levels, work })
    }
}

/// The rows e_aᵀM^c of the chosen points and of the ends of the chosen edges.
#[derive(Clone, Debug)]
pub(crate) struct PowerRows<S> {
    rows: BTreeMap<usize, Vec<S>>,
}

/// The points whose rows are needed.
pub(super) fn rows_of(chosen: &Representatives) -> BTreeSet<usize> {
    let ends = chosen.edges.iter().flat_map(|&(a, b)| [a, b]);
    ends.chain(chosen.points.iter().copied()).collect()
}

/// The [`PowerRows`] for c = 1, …, `levels`, each computed from the preceding one.
pub(crate) fn power_rows<'a, S: Scalar>(
    ring: &'a LocalRules<S>,
    chosen: &Representatives,
    levels: u32,
) -> impl Iterator<Item = PowerRows<S>> + use<'a, S> {
    let first = rows_of(chosen).into_iter().map(|a| (a, ring.weights().row(a).cloned().collect()));
    let first = PowerRows { rows: first.collect() };
    let next = |rows: &PowerRows<S>| {
        let rows = rows.rows.iter().map(|(a, row)| (*a, ring.pull_back(row)));
        Some(PowerRows { rows: rows.collect() })
    };
    std::iter::successors(Some(first), next).take(levels as usize)
}

impl<S: Scalar> PowerRows<S> {
    /// As [`power_rows`], but only the rows of the chosen points are multiplied. The rows
    /// of the other ends of edges follow by the rotation of the ring, which is a symmetry
    /// of every power of M.
    pub(super) fn turned(
        ring: &LocalRules<S>,
        chosen: &Representatives,
        levels: u32,
    ) -> impl Iterator<Item = PowerRows<S>> {
        let (needed, image) = (rows_of(chosen), ring.rotation());
        let chosen = chosen.points.clone();
        let points = Representatives { points: chosen.clone(), edges: Vec::new() };
        power_rows(ring, &points, levels).map(move |PowerRows { mut rows }| {
            let Some(image) = &image else { return PowerRows { rows } };
            for &first in &chosen {
                let (mut point, mut places) = (image[first], image.clone());
                while point != first && rows.len() < needed.len() {
                    if needed.contains(&point) {
                        let mut turned: Vec<&S> = rows[&first].iter().collect();
                        for (x, &place) in rows[&first].iter().zip(&places) {
                            turned[place] = x;
                        }
                        rows.insert(point, turned.into_iter().cloned().collect());
                    }
                    point = image[point];
                    for place in &mut places {
                        *place = image[*place];
                    }
                }
            }
            PowerRows { rows }
        })
    }

    /// e_aᵀM^c − e_bᵀM^c of each chosen edge (a, b).
    pub(crate) fn differences(&self, chosen: &Representatives) -> Vec<Vec<S>> {
        let difference = |(a, b): &(usize, usize)| {
            self.rows[a].iter().zip(&self.rows[b]).map(|(x, y)| x.minus(y)).collect()
        };
        chosen.edges.iter().map(difference).collect()
    }
}

impl<S: Real> PowerRows<S> {
    /// Λ_c: the greatest Σ_b |(M^c)_{a,b}| over the chosen points a.
    pub(crate) fn norm(&self, chosen: &Representatives) -> S {
        S::maximum(chosen.points.iter().map(|a| S::sum_of_magnitudes(&self.rows[a])))
    }
}

/// e_aᵀ(M − I) of each chosen point.
pub(crate) fn displaced_rows<S: Scalar>(
    ring: &LocalRules<S>,
    chosen: &Representatives,
) -> Vec<Vec<S>> {
    let one = S::from_rational(&Rational::one());
    let displaced = |&a: &usize| {
        let mut row: Vec<S> = ring.weights().row(a).cloned().collect();
        row[a] = row[a].minus(&one);
        row
    };
    chosen.points.iter().map(displaced).collect()
}
