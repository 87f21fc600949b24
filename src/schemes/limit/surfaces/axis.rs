//! The data of one curve scheme that the distance of a tensor product surface needs.

use crate::bound::{Budget, Order, Share, power_norm};
use crate::exact::Rational;
use crate::limit::distances::distance::Distances;
use crate::limit::distances::search::Goal;
use crate::limit::error::LimitError;
use crate::limit::value::Limit;

/// The greatest number of cells that the computation of one distance of a curve splits.
pub(super) const CELLS: u32 = 1 << 14;

/// The greatest number of intervals into which [0, 1] is divided.
const INTERVALS: u32 = 1 << 10;

/// The intervals are those of a level at most this number of levels beyond k.
const DEEPER: u32 = 6;

/// The greatest number of points n^m of a level m for which the norm of P^m is computed.
const POINTS: u32 = 1 << 12;

/// C_m is computed to the width 1/REST for the bound of P^∞ by P^m.
const REST: u32 = 10_000;

/// The cost of a product of fractions, in steps.
const FRACTION: u64 = 40;

/// Bounds on intervals are rounded up to multiples of 1/4096, and bounds of errors to
/// multiples of p/4096, where p is the greatest power of 2 that is at most the bound of
/// C_k. So the numbers are short, and few are different.
const STEPS: u32 = 1 << 12;

/// Norms of functionals at a parameter, or bounds of these norms on an interval.
#[derive(Clone, Debug)]
pub(super) struct Norms {
    /// The norm of P^∞ − P^k as a functional of the differences.
    pub(super) error: Rational,
    /// The norm of P^∞ as a functional of the points: Σ|coefficients|.
    pub(crate) limit: Rational,
    /// The norm of P^k as a functional of the points.
    pub(super) polygon: Rational,
}

/// An upper bound of C_k of a curve scheme, and a parameter at which C_k is nearly
/// attained.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    pub(super) level: u32,
    pub(super) upper: Rational,
    pub(crate) parameter: Rational,
}

/// One direction of a tensor product.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    distances: Distances,
    /// Whether no coefficient of the mask is negative, so that P^∞ and P^k have the
    /// norm 1.
    averages: bool,
    /// A bound of the norm of P^∞(t) as a functional of the points, for all t.
    norm: Rational,
}

/// The norms at the points of a level M.
pub(super) struct Samples {
    /// The parameters t, with the norms at t, where P^M replaces P^∞.
    pub(super) at: Vec<(Rational, Norms)>,
    /// A bound of the distance between P^∞ and P^M, per unit of max|Δ|.
    rest: Rational,
}

impl Axis {
    /// The axis for these distances, in their parametrisation.
    pub(super) fn new(distances: Distances, budget: &Budget) -> Result<Axis, LimitError> {
        let distances = distances.with_cells(CELLS).with_budget(budget.clone());
        let limit = distances.limit().clone();
        let rules = limit.mask().rules();
        let averages = rules.rows().iter().flatten().all(|entry| entry.sign() >= 0);
        let arity = u32::try_from(rules.arity()).expect("the arity is capped");
        let mut axis = Axis { distances, averages, norm: Rational::one() };
        if !averages {
            // |P^∞| ≤ |P^m| + |P^∞ − P^m|, and |Δ| ≤ 2 if the absolute values of the points are at
            // most 1.
            let level = POINTS.ilog(arity);
            let off = axis.constant(level, &Rational::new(1, REST), &budget.share())?.upper;
            let points = power_norm(rules, level, Order::Adjoint);
            axis.norm = points.expect("2^12 classes can be walked").value + &off + &off;
        }
        Ok(axis)
    }

    pub(crate) fn distances(&self) -> &Distances {
        &self.distances
    }

    pub(crate) fn limit(&self) -> &Limit {
        self.distances.limit()
    }

    /// Whether both have the same mask in the same parametrisation.
    pub(super) fn is_like(&self, other: &Axis) -> bool {
        self.limit().mask() == other.limit().mask()
            && self.distances.shift() == other.distances.shift()
    }

    /// Λ_c; there must be few residue classes.
    pub(super) fn growth(&self, c: u32) -> Rational {
        if self.averages {
            return Rational::one();
        }
        let norm = power_norm(self.limit().mask().rules(), c, Order::Adjoint);
        norm.expect("few classes can be walked").value
    }

    /// C_k to this width, or as precisely as the caps allow.
    pub(super) fn constant(
        &self,
        level: u32,
        width: &Rational,
        share: &Share<'_>,
    ) -> Result<Constant, LimitError> {
        let any = self.distances.any_polygon();
        let (mut search, mut best) = self.distances.search(&any, level, share)?;
        let upper = search.bound(&mut best);
        let upper = search.narrowed(upper, width, &mut best);
        Ok(Constant { level, upper, parameter: best.parameter })
    }

    /// Whether a search shows that C_k is at most this. It ends with the first greater value.
    pub(super) fn is_within(
        &self,
        level: u32,
        most: &Rational,
        share: &Share<'_>,
    ) -> Result<bool, LimitError> {
        let any = self.distances.any_polygon();
        let (mut search, mut best) = self.distances.search(&any, level, share)?;
        Ok(search.run(&Goal::Threshold(most.clone()), &mut best) <= *most)
    }

    /// A bound of C_k without a search.
    pub(crate) fn unsearched(&self, level: u32) -> Constant {
        let upper = self.distances.unsearched(&self.distances.any_polygon(), level);
        Constant { level, upper, parameter: Rational::zero() }
    }

    /// Bounds of the norms for all t.
    pub(super) fn bounds(&self, constant: &Constant) -> Norms {
        let polygon = &self.norm + Rational::from(2) * &constant.upper;
        let polygon = if self.averages { Rational::one() } else { polygon };
        Norms { error: constant.upper.clone(), limit: self.norm.clone(), polygon }
    }

    /// The cost of [`samples`](Self::samples), in steps.
    pub(super) fn cost(&self, constant: &Constant) -> u64 {
        let rules = self.limit().mask().rules();
        let Some(depth) = self.depth(constant) else { return 0 };
        let points = rules.arity().pow(depth) as u64;
        let window = self.distances.window() * rules.width();
        points * window as u64 * u64::from(depth + constant.level) * FRACTION
    }

    /// The level M of the samples; `None` if there are none.
    fn depth(&self, constant: &Constant) -> Option<u32> {
        let arity = u32::try_from(self.limit().mask().arity()).expect("the arity is capped");
        let depth = INTERVALS.ilog(arity).min(constant.level + DEEPER);
        (!self.averages && constant.level <= depth).then_some(depth)
    }

    /// The norms at (i + n^{M−k}s)/n^M, i = 0, …, n^M. There are none if k is above the
    /// greatest M, or if no coefficient of the mask is negative, since then they would not
    /// improve the bounds.
    ///
    /// These parameters include those of the points of P^k. P^M replaces P^∞, with its
    /// points at the same parameters: its shift is σ = n^{M−k}s minus an integer. This
    /// changes P^M by at most |σ − s| T_M.
    pub(super) fn samples(
        &self,
        constant: &Constant,
        share: &Share<'_>,
    ) -> Result<Samples, LimitError> {
        let limit = self.limit();
        let arity = u32::try_from(limit.mask().arity()).expect("the arity is capped");
        let Some(depth) = self.depth(constant) else {
            return Ok(Samples { at: Vec::new(), rest: Rational::zero() });
        };
        let width = &constant.upper / Rational::from(STEPS);
        let rest = self.constant(depth, &width.max(Rational::new(1, 1 << 30)), share)?.upper;
        let shift = self.distances.shift();
        let finer = Rational::from(arity).pow((depth - constant.level).cast_signed());
        let moved = (&finer - Rational::one()) * shift;
        let nearest = Rational::from((&moved + Rational::new(1, 2)).floor());
        let aligned = shift + &moved - &nearest;
        // T_M has been computed, as n^M ≤ 2^10.
        let differences = &limit.contraction()[depth as usize];
        let rest = rest + (&aligned - shift).abs() * differences;
        let minus = Rational::from(-1);
        let sample = |i: u32| {
            let t = (Rational::from(i) + &aligned) / Rational::from(arity.pow(depth));
            let fine = limit.polygon_from(depth, &t, &aligned)?;
            let polygon = limit.polygon_from(constant.level, &t, shift)?;
            let error = fine.plus(&minus, &polygon).on_differences();
            let error = error.expect("both are affine combinations").norm();
            Ok((t, Norms { error, limit: fine.norm(), polygon: polygon.norm() }))
        };
        let at = (0..=arity.pow(depth)).map(sample).collect::<Result<_, LimitError>>()?;
        Ok(Samples { at, rest })
    }

    /// Bounds of the norms on intervals that cover [0, 1]. Bounds that are dominated by
    /// those on another interval are left out. Between samples P^M and P^k are linear, so
    /// their norms are convex; P^∞ is within `rest` of P^M.
    pub(super) fn intervals(&self, constant: &Constant, samples: &Samples) -> Vec<Norms> {
        let all = self.bounds(constant);
        if samples.at.is_empty() {
            return vec![all];
        }
        let power = |bits: i32| Rational::from(2).pow(-bits);
        let bits = (0..64).find(|bits| power(*bits) <= all.error).unwrap_or(64);
        let step = Rational::new(1, STEPS);
        let small = power(bits) * &step;
        let over = |ends: &[(Rational, Norms)]| {
            let greater =
                |part: fn(&Norms) -> &Rational| part(&ends[0].1).max(part(&ends[1].1)).clone();
            let error = greater(|end| &end.error) + &samples.rest;
            let limit = greater(|end| &end.limit) + &samples.rest + &samples.rest;
            Norms {
                error: rounded_up(error.min(all.error.clone()), &small),
                limit: rounded_up(limit.min(all.limit.clone()), &step),
                polygon: rounded_up(greater(|end| &end.polygon), &step),
            }
        };
        maximal(samples.at.windows(2).map(over))
    }
}

fn rounded_up(value: Rational, unit: &Rational) -> Rational {
    Rational::from((value / unit).ceil()) * unit
}

/// The norms that are not dominated by others: no other entry is at least as great in all
/// three.
fn maximal(all: impl Iterator<Item = Norms>) -> Vec<Norms> {
    let under = |one: &Norms, other: &Norms| {
        one.error <= other.error && one.limit <= other.limit && one.polygon <= other.polygon
    };
    let mut kept: Vec<Norms> = Vec::new();
    for norms in all {
        if !kept.iter().any(|other| under(&norms, other)) {
            kept.retain(|other| !under(other, &norms));
            kept.push(norms);
        }
    }
    kept
}
