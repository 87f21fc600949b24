//! The greatest distance of nets from their limit surfaces, bounded from above and below.

use super::axis::{Axis, Constant, Norms};
use super::surface::{Spreads, SurfaceDistances, SurfaceError, SurfaceWitness};
use crate::bound::Share;
use crate::exact::{Enclosure, Rational};
use crate::limit::distances::comparison::Comparison;
use crate::limit::distances::depth::{TwoSidedDepth, two_sided};
use crate::limit::error::positive;

/// The number of parameters along each index whose pairs are candidates.
const MAX_CANDIDATES: usize = 16;

/// The greatest number of pairs of parameters at which the exact norm is computed.
const MAX_TRANSPORTS: usize = 32;

/// The halvings of the interval from 0 to a threshold in which the constant of a curve is sought that
/// the threshold allows.
const HALVINGS: u32 = 12;

/// The cost in steps of a pair of intervals, and the greatest cost of an exact norm.
const PAIR: u64 = 40;
const TRANSPORT: u64 = 1 << 20;

/// The greatest c, and the greatest number n^c of residue classes, for which `lasting`
/// bounds the growth of the spreads over c levels.
const MAX_LASTING: u32 = 6;
const POINTS: u64 = 1 << 10;

/// The widths to which C¹_k and C²_k are computed, one after the other: the threshold
/// divided by these numbers.
const WIDTHS: [u32; 3] = [16, 1 << 10, 1 << 20];

/// The known bounds of both curve schemes at a level, and the best net.
struct BestBounds {
    curves: [Constant; 2],
    /// The net of the extremal polygons.
    best: SurfaceWitness,
}

impl BestBounds {
    /// Combines two results: for each curve scheme the smaller upper bound, and the net
    /// with the greater distance.
    fn or(mut self, other: Option<BestBounds>) -> BestBounds {
        let Some(other) = other else { return self };
        for (own, curve) in self.curves.iter_mut().zip(other.curves) {
            if curve.upper < own.upper {
                *own = curve;
            }
        }
        if other.best.distance > self.best.distance {
            self.best = other.best;
        }
        self
    }
}

impl SurfaceDistances {
    /// An enclosure of C_k, and a net whose distance is its lower end. β_1 C¹_k and β_2
    /// C²_k are each computed to half of `width`. If a coefficient is negative, the
    /// enclosure can be wider than `width`.
    ///
    /// # Errors
    /// When k is above 128, or the width is not positive.
    pub fn constant(
        &self,
        level: u32,
        width: &Rational,
        spreads: &Spreads,
    ) -> Result<(Enclosure, SurfaceWitness), SurfaceError> {
        positive("the width", width)?;
        let share = self.budget.share();
        let known = self.known(level, &(width / Rational::from(2)), spreads, &share)?;
        let (upper, best) = self.narrowed(known, spreads, None, &share)?;
        Ok((Enclosure::new(best.distance.clone(), upper), best))
    }

    /// Compares C_k with a threshold.
    ///
    /// # Errors
    /// When k is above 128.
    pub fn compare(
        &self,
        level: u32,
        threshold: &Rational,
        spreads: &Spreads,
    ) -> Result<Comparison<SurfaceWitness>, SurfaceError> {
        self.compare_within(level, threshold, spreads, &self.budget.share())
    }

    fn compare_within(
        &self,
        level: u32,
        threshold: &Rational,
        spreads: &Spreads,
        share: &Share<'_>,
    ) -> Result<Comparison<SurfaceWitness>, SurfaceError> {
        if self.are_within(level, threshold, spreads, share)? {
            return Ok(Comparison::Within);
        }
        let mut widths = WIDTHS.iter().map(|part| threshold.abs() / Rational::from(*part));
        let mut coarse: Option<BestBounds> = None;
        let known = loop {
            let width = widths.next().unwrap_or_else(Rational::zero).max(Rational::new(1, 1 << 30));
            let known = self.known(level, &width, spreads, share)?.or(coarse);
            if known.best.distance > *threshold {
                return Ok(Comparison::Exceeds(known.best));
            }
            if self.bound(&known.curves, spreads) <= *threshold {
                return Ok(Comparison::Within);
            }
            if widths.len() == 0 || !share.goes_on() {
                break known;
            }
            coarse = Some(known);
        };
        let (upper, best) = self.narrowed(known, spreads, Some(threshold), share)?;
        Ok(if best.distance > *threshold {
            Comparison::Exceeds(best)
        } else if upper <= *threshold {
            Comparison::Within
        } else {
            Comparison::Undecided(Box::new(Enclosure::new(best.distance, upper)))
        })
    }

    /// Whether both constants are so small that the bound of C_k is at most the threshold. This needs
    /// fewer cells than the constants themselves.
    fn are_within(
        &self,
        level: u32,
        threshold: &Rational,
        spreads: &Spreads,
        share: &Share<'_>,
    ) -> Result<bool, SurfaceError> {
        let constant = |upper: Rational| Constant { level, upper, parameter: Rational::zero() };
        let shows = |most: &Rational| {
            let curves = [most, most].map(|most| constant(most.clone()));
            self.bound(&curves, spreads) <= *threshold
        };
        // The bound rises with the constants.
        let (mut low, mut high) = (Rational::zero(), threshold.clone());
        if threshold.sign() <= 0 || !shows(&low) {
            return Ok(false);
        }
        for _ in 0..HALVINGS {
            let middle = (&low + &high) / Rational::from(2);
            if shows(&middle) { low = middle } else { high = middle }
        }
        let [first, second] = self.axes.each_ref();
        Ok(first.is_within(level, &low, share)?
            && (first.is_like(second) || second.is_within(level, &low, share)?))
    }

    /// The least k from which on every net of these spreads is within `tolerance` of its limit.
    ///
    /// # Errors
    /// When the tolerance is not positive, or no level up to 128 is shown to meet it.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{Limit, Spreads, SurfaceDistances};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = Limit::new(parse_scheme("chaikin")?.masks()[0])?;
    /// let distances = SurfaceDistances::new(&chaikin, &chaikin)?;
    /// // C_k = 2^−k.
    /// let depth = distances.depth(&Spreads::one(), &Rational::new(1, 1000))?;
    /// assert_eq!((depth.lower, depth.upper), (10, 10));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn depth(
        &self,
        spreads: &Spreads,
        tolerance: &Rational,
    ) -> Result<TwoSidedDepth, SurfaceError> {
        positive("the tolerance", tolerance)?;
        let meets = |level| {
            // For most levels this shows without a search that they do not meet the
            // tolerance.
            let mut far = Rational::zero();
            for (axis, along) in self.axes.iter().zip(0..) {
                let shift = axis.distances().shift();
                let distance = axis.limit().far_polygon_from(level, shift)?.distance;
                far += &(distance * spreads.along(along));
            }
            if far > *tolerance {
                return Ok(Some(false));
            }
            let share = self.budget.share_of_depth();
            Ok(match self.compare_within(level, tolerance, spreads, &share)? {
                Comparison::Within => Some(true),
                Comparison::Exceeds(_) => Some(false),
                Comparison::Undecided(_) => None,
            })
        };
        let surely = |level| self.at_most(level, spreads) <= *tolerance;
        two_sided(meets, surely, self.lasting(), || self.caps())
    }

    /// A c such that, if c levels in a row meet a tolerance, all later ones do; `None` if no
    /// small c is found. Over c levels the spreads grow at most by the factors T¹_cΛ²_c and
    /// T²_cΛ¹_c, which must be at most 1.
    #[must_use]
    pub fn lasting(&self) -> Option<u32> {
        let [first, second] = self.axes.each_ref();
        let one = Rational::one();
        let few = |c: u32| {
            let classes = |axis: &Axis| (axis.limit().mask().arity() as u64).checked_pow(c);
            [first, second].iter().all(|axis| classes(axis).is_some_and(|n| n <= POINTS))
        };
        let falls = |c: &u32| {
            let along = |axis: &Axis, other: &Axis| {
                axis.limit()
                    .contraction()
                    .get(*c as usize)
                    .is_some_and(|t| t * other.growth(*c) <= one)
            };
            along(first, second) && along(second, first)
        };
        (1..=MAX_LASTING).take_while(|c| few(*c)).find(falls)
    }

    /// A bound of C_k without a search. It does not increase with the level.
    #[must_use]
    pub fn at_most(&self, level: u32, spreads: &Spreads) -> Rational {
        self.bound(&self.axes.each_ref().map(|axis| axis.unsearched(level)), spreads)
    }

    /// A bound of C_k from bounds of both curve schemes.
    fn bound(&self, curves: &[Constant; 2], spreads: &Spreads) -> Rational {
        let [s, t] = [0, 1].map(|axis| self.axes[axis].bounds(&curves[axis]));
        product_bound(&s, &t, spreads)
    }

    /// Bounds of C¹_k and C²_k, where each constant times its spread is computed to this
    /// width, and the net of the extremal polygons.
    fn known(
        &self,
        level: u32,
        width: &Rational,
        spreads: &Spreads,
        share: &Share<'_>,
    ) -> Result<BestBounds, SurfaceError> {
        let widths = [0, 1].map(|axis| width / spreads.along(axis));
        let curve = |axis: usize| self.axes[axis].constant(level, &widths[axis], share);
        let first = curve(0)?;
        let alike = widths[0] == widths[1] && self.axes[0].is_like(&self.axes[1]);
        let second = if alike { first.clone() } else { curve(1)? };
        let curves = [first, second];
        let parameters = curves.each_ref().map(|curve| curve.parameter.clone());
        let best = self.separable(level, parameters, spreads)?;
        Ok(BestBounds { curves, best })
    }

    /// A bound of C_k from intervals of parameters, and the best net found at the pairs
    /// of parameters with the greatest bounds. The search ends with the first net whose
    /// distance is above `enough`.
    fn narrowed(
        &self,
        known: BestBounds,
        spreads: &Spreads,
        enough: Option<&Rational>,
        share: &Share<'_>,
    ) -> Result<(Rational, SurfaceWitness), SurfaceError> {
        let BestBounds { curves, mut best } = known;
        if !self.axes.iter().zip(&curves).all(|(axis, curve)| share.take(axis.cost(curve))) {
            return Ok((self.bound(&curves, spreads), best));
        }
        let samples = |axis: usize| self.axes[axis].samples(&curves[axis], share);
        let samples = [samples(0)?, samples(1)?];
        let intervals = |axis: usize| self.axes[axis].intervals(&curves[axis], &samples[axis]);
        let [first, second] = [intervals(0), intervals(1)];
        if !share.take((first.len() * second.len()) as u64 * PAIR) {
            return Ok((self.bound(&curves, spreads), best));
        }
        let bounds = pairs(&first, &second).map(|(s, t)| product_bound(s, t, spreads));
        let upper = bounds.max().unwrap_or_else(|| best.distance.clone());
        let [first, second] = samples.map(|samples| promising(samples.at));
        let mut promising: Vec<_> = pairs(&first, &second)
            .map(|(s, t)| (product_bound(&s.1, &t.1, spreads), [s.0.clone(), t.0.clone()]))
            .collect();
        promising.sort_by(|one, other| other.0.cmp(&one.0));
        for (_, parameters) in promising.into_iter().take(MAX_TRANSPORTS) {
            let done = best.distance >= upper || enough.is_some_and(|most| best.distance > *most);
            if done || !share.take(TRANSPORT) {
                break;
            }
            match self.at(best.level, &parameters, spreads) {
                Ok(found) if found.distance > best.distance => best = found,
                Ok(_) | Err(SurfaceError::Net(_)) => {}
                Err(error) => return Err(error),
            }
        }
        Ok((upper, best))
    }
}

fn pairs<'a, T>(first: &'a [T], second: &'a [T]) -> impl Iterator<Item = (&'a T, &'a T)> {
    first.iter().flat_map(|s| second.iter().map(move |t| (s, t)))
}

/// The lesser of two bounds: by P^∞⊗P^∞ − P^k⊗P^k = (P^∞ − P^k)⊗P^∞ + P^k⊗(P^∞ − P^k), and
/// by this identity with the directions exchanged.
///
/// Source: `proofs/THEOREMS.md`, 32.
fn product_bound(s: &Norms, t: &Norms, spreads: &Spreads) -> Rational {
    let (x, y) = (&s.error * spreads.along(0), &t.error * spreads.along(1));
    (&x * &t.limit + &s.polygon * &y).min(&y * &s.limit + &t.polygon * &x)
}

/// The parameters of one direction with the greatest norms.
fn promising(mut samples: Vec<(Rational, Norms)>) -> Vec<(Rational, Norms)> {
    let weight = |norms: &Norms| &norms.error * (&norms.limit + &norms.polygon);
    samples.sort_by_cached_key(|(_, norms)| -weight(norms));
    samples.truncate(MAX_CANDIDATES);
    samples
}
