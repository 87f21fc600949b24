//! Comparison of the distance of polygons from their limits with a threshold.

use super::distance::Distances;
use super::polygon::{ControlPolygon, Polygons};
use super::search::Goal;
use crate::bound::Share;
use crate::exact::{Enclosure, Rational};
use crate::limit::error::LimitError;
use crate::limit::functional::ExtremalPolygon;

/// How a distance compares with a threshold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison<W> {
    /// It is at most the threshold, for all polygons in question.
    Within,
    /// It is greater, as the witness shows.
    Exceeds(W),
    /// Undecided within the caps on cells and levels: the distance is in this interval,
    /// which contains the threshold.
    Undecided(Box<Enclosure>),
}

impl<W> Comparison<W> {
    /// The same result with the witness mapped by `witness`.
    pub fn map<V>(self, witness: impl FnOnce(W) -> V) -> Comparison<V> {
        match self {
            Comparison::Within => Comparison::Within,
            Comparison::Exceeds(found) => Comparison::Exceeds(witness(found)),
            Comparison::Undecided(enclosure) => Comparison::Undecided(enclosure),
        }
    }
}

/// A control polygon with max|Δ| = 1, and a parameter at which it is far from its limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// The polygon, of integers whose neighbours differ by 1.
    pub polygon: ExtremalPolygon,
    /// k.
    pub level: u32,
    /// t.
    pub parameter: Rational,
    /// |P^∞(t) − P^k(t)|.
    pub distance: Rational,
}

impl Distances {
    /// Compares C_k, the supremum of ‖P^∞ − P^k‖_∞ over all control polygons with
    /// max|Δ| ≤ 1, with a threshold.
    ///
    /// # Errors
    /// When k is above 128.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{Comparison, Distances, Limit};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("b-spline:degree=3")?;
    /// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
    /// let (third, quarter) = (Rational::new(1, 3), Rational::new(1, 4));
    /// assert_eq!(distances.compare(0, &third)?, Comparison::Within);
    /// let Comparison::Exceeds(witness) = distances.compare(0, &quarter)? else {
    ///     return Err("0, -1, 0 is 1/3 from its limit".into());
    /// };
    /// assert_eq!(witness.polygon.points, [0, -1, 0]);
    /// assert_eq!(witness.distance, third);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compare(
        &self,
        level: u32,
        threshold: &Rational,
    ) -> Result<Comparison<Witness>, LimitError> {
        Ok(
            match self.compare_among(
                &self.any_polygon(),
                level,
                threshold,
                &self.budget().share(),
            )? {
                Comparison::Within => Comparison::Within,
                Comparison::Undecided(enclosure) => Comparison::Undecided(enclosure),
                Comparison::Exceeds((parameter, distance)) => {
                    let polygon = self.error(level, &parameter)?.extremal_polygon();
                    Comparison::Exceeds(Witness { polygon, level, parameter, distance })
                }
            },
        )
    }

    /// Compares ‖P^∞ − P^k‖_∞ of one control polygon with a threshold. The witness is a
    /// pair of t and |P^∞(t) − P^k(t)|.
    ///
    /// # Errors
    /// As [`Distances::compare`], and when the polygon is too short.
    pub fn compare_polygon(
        &self,
        polygon: &ControlPolygon,
        level: u32,
        threshold: &Rational,
    ) -> Result<Comparison<(Rational, Rational)>, LimitError> {
        self.compare_among(&self.this_polygon(polygon)?, level, threshold, &self.budget().share())
    }

    pub(super) fn compare_among(
        &self,
        among: &Polygons,
        level: u32,
        threshold: &Rational,
        share: &Share<'_>,
    ) -> Result<Comparison<(Rational, Rational)>, LimitError> {
        let (mut search, mut best) = self.search(among, level, share)?;
        if best.value > *threshold {
            return Ok(Comparison::Exceeds((best.parameter, best.value)));
        }
        let bound = if self.looks_at_roots(among, share) {
            search.run(&Goal::Threshold(threshold.clone()), &mut best)
        } else {
            self.unsearched(among, level)
        };
        Ok(if best.value > *threshold {
            Comparison::Exceeds((best.parameter, best.value))
        } else if bound <= *threshold {
            Comparison::Within
        } else {
            Comparison::Undecided(Box::new(Enclosure::new(best.value, bound)))
        })
    }
}
