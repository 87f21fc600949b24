//! The greatest distance of a net from its surface, from above and below.

use super::comparison::Comparison;
use super::depth::TwoSidedDepth;
use super::error::{LimitError, MAX_LEVEL, positive};
use super::surface::{Spreads, SurfaceDistances, SurfaceError, SurfaceWitness};
use super::surface_axis::{Constant, Norms};
use crate::exact::{Enclosure, Rational};

/// How many parameters along each index are looked at together.
const MAX_CANDIDATES: usize = 16;

/// At how many pairs of parameters the exact norm is computed.
const MAX_TRANSPORTS: usize = 32;

/// The widths of C¹_k and C²_k that are tried, as parts of the threshold.
const WIDTHS: [u32; 3] = [16, 1 << 10, 1 << 20];

/// What is known of both curve schemes at a level.
struct Known {
    curves: [Constant; 2],
    /// The net of the extremal polygons.
    best: SurfaceWitness,
}

impl SurfaceDistances {
    /// C_k in an interval, and a net whose distance is its lower end. C¹_k and C²_k are
    /// found to this width, half for each spread; the interval can be wider where a
    /// coefficient is negative.
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
        let known = self.known(level, &(width / Rational::from(2)), spreads)?;
        let (upper, best) = self.narrowed(known, spreads, None)?;
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
        let mut widths = WIDTHS.iter().map(|part| threshold.abs() / Rational::from(*part));
        let known = loop {
            let width = widths.next().unwrap_or_else(Rational::zero).max(Rational::new(1, 1 << 30));
            let known = self.known(level, &width, spreads)?;
            if known.best.distance > *threshold {
                return Ok(Comparison::Exceeds(known.best));
            }
            let [s, t] = [0, 1].map(|axis| self.axes[axis].bounds(&known.curves[axis]));
            if product_bound(&s, &t, spreads) <= *threshold {
                return Ok(Comparison::Within);
            }
            if widths.len() == 0 {
                break known;
            }
        };
        let (upper, best) = self.narrowed(known, spreads, Some(threshold))?;
        Ok(if best.distance > *threshold {
            Comparison::Exceeds(best)
        } else if upper <= *threshold {
            Comparison::Within
        } else {
            Comparison::Undecided(Box::new(Enclosure::new(best.distance, upper)))
        })
    }

    /// The least k at which every net of these spreads is within `tolerance` of its limit.
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
        let mut undecided = None;
        for level in 0..=MAX_LEVEL {
            match self.compare(level, tolerance, spreads)? {
                Comparison::Within => {
                    return Ok(TwoSidedDepth { lower: undecided.unwrap_or(level), upper: level });
                }
                Comparison::Undecided(_) => undecided = undecided.or(Some(level)),
                Comparison::Exceeds(_) => {}
            }
        }
        Err(LimitError::TooDeep.into())
    }

    /// C¹_k and C²_k, each times its spread to this width.
    fn known(
        &self,
        level: u32,
        width: &Rational,
        spreads: &Spreads,
    ) -> Result<Known, SurfaceError> {
        let curve = |axis: usize| self.axes[axis].constant(level, &(width / spreads.along(axis)));
        let curves = [curve(0)?, curve(1)?];
        let parameters = curves.each_ref().map(|curve| curve.parameter.clone());
        let best = self.separable(level, parameters, spreads)?;
        Ok(Known { curves, best })
    }

    /// A bound of C_k by intervals of parameters, and the best net found at pairs of
    /// parameters where its bound is greatest; with the first above `enough` it ends.
    fn narrowed(
        &self,
        known: Known,
        spreads: &Spreads,
        enough: Option<&Rational>,
    ) -> Result<(Rational, SurfaceWitness), SurfaceError> {
        let Known { curves, mut best } = known;
        let samples = |axis: usize| self.axes[axis].samples(&curves[axis]);
        let samples = [samples(0)?, samples(1)?];
        let intervals = |axis: usize| self.axes[axis].intervals(&curves[axis], &samples[axis]);
        let [first, second] = [intervals(0), intervals(1)];
        let bounds = pairs(&first, &second).map(|(s, t)| product_bound(s, t, spreads));
        let upper = bounds.max().unwrap_or_else(|| best.distance.clone());
        let [first, second] = samples.map(|samples| promising(samples.at));
        let mut promising: Vec<_> = pairs(&first, &second)
            .map(|(s, t)| (product_bound(&s.1, &t.1, spreads), [s.0.clone(), t.0.clone()]))
            .collect();
        promising.sort_by(|one, other| other.0.cmp(&one.0));
        for (_, parameters) in promising.into_iter().take(MAX_TRANSPORTS) {
            if best.distance >= upper || enough.is_some_and(|enough| best.distance > *enough) {
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

/// The lesser of the bounds by P^∞⊗P^∞ − P^k⊗P^k = (P^∞ − P^k)⊗P^∞ + P^k⊗(P^∞ − P^k) and by
/// the same with the directions exchanged.
///
/// Source: `proofs/THEOREMS.md`, 32.
fn product_bound(s: &Norms, t: &Norms, spreads: &Spreads) -> Rational {
    let (x, y) = (&s.error * spreads.along(0), &t.error * spreads.along(1));
    (&x * &t.limit + &s.polygon * &y).min(&y * &s.limit + &t.polygon * &x)
}

/// The parameters of one direction where the norms are greatest.
fn promising(mut samples: Vec<(Rational, Norms)>) -> Vec<(Rational, Norms)> {
    let weight = |norms: &Norms| &norms.error * (&norms.limit + &norms.polygon);
    samples.sort_by_cached_key(|(_, norms)| -weight(norms));
    samples.truncate(MAX_CANDIDATES);
    samples
}
