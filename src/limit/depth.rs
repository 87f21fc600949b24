//! Subdivision depths, from above and below.

use super::comparison::Comparison;
use super::distance::{Distances, Polygons};
use super::error::{LimitError, MAX_LEVEL, positive};
use super::polygon::ControlPolygon;
use crate::exact::Rational;

/// A subdivision depth: the least level k at which the distance from the limit meets
/// the tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TwoSidedDepth {
    /// No lower level meets the tolerance.
    pub lower: u32,
    /// This level does. It is the depth when both are equal.
    pub upper: u32,
}

impl Distances {
    /// The least k at which every control polygon with max|Δ| ≤ `spread` is within
    /// `tolerance` of its limit: C_k·spread ≤ tolerance.
    ///
    /// The levels are tried one by one: the distance need not fall with the level.
    /// Where C_k·spread is the tolerance itself, or too near to it to tell within the
    /// caps of the search, the two sides can stay apart.
    ///
    /// # Errors
    /// When the tolerance or the spread is not positive, or no level up to 128 is
    /// shown to meet the tolerance within the caps of the search.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{Distances, Limit};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("six-point:w=3/256")?;
    /// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
    /// let depth = distances.depth(&Rational::new(1, 10), &Rational::new(1, 1000))?;
    /// assert_eq!((depth.lower, depth.upper), (4, 4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn depth(
        &self,
        spread: &Rational,
        tolerance: &Rational,
    ) -> Result<TwoSidedDepth, LimitError> {
        positive("the spread", spread)?;
        positive("the tolerance", tolerance)?;
        self.least_level(&[self.any_polygon()], &(tolerance / spread))
    }

    /// The least k at which this control polygon is within `tolerance` of its limit.
    ///
    /// # Errors
    /// As of [`Distances::depth`], and when the polygon is too short.
    pub fn depth_of_polygon(
        &self,
        polygon: &ControlPolygon,
        tolerance: &Rational,
    ) -> Result<TwoSidedDepth, LimitError> {
        self.depth_of_points(std::slice::from_ref(polygon), tolerance)
    }

    /// The least k at which a control polygon of points is within `tolerance` of its
    /// limit in every coordinate: one [`ControlPolygon`] for each. Since a distance need
    /// not fall with the level, it can be greater than the depth of each coordinate.
    ///
    /// # Errors
    /// As of [`Distances::depth_of_polygon`].
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::{ControlPolygon, Distances, Limit};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("chaikin")?;
    /// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
    /// // A square of side 4, x and y.
    /// let square = [[0, 4, 4, 0], [0, 0, 4, 4]].map(|x| x.map(Rational::from));
    /// let square = square.map(|x| ControlPolygon::closed(&x));
    /// let depth = distances.depth_of_points(&square, &Rational::new(1, 4))?;
    /// assert_eq!((depth.lower, depth.upper), (3, 3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn depth_of_points(
        &self,
        coordinates: &[ControlPolygon],
        tolerance: &Rational,
    ) -> Result<TwoSidedDepth, LimitError> {
        positive("the tolerance", tolerance)?;
        let among = coordinates.iter().map(|polygon| self.this_polygon(polygon));
        self.least_level(&among.collect::<Result<Vec<_>, _>>()?, tolerance)
    }

    fn least_level(
        &self,
        among: &[Polygons<'_>],
        threshold: &Rational,
    ) -> Result<TwoSidedDepth, LimitError> {
        let surely = |level| among.iter().all(|own| self.unsearched(own, level) <= *threshold);
        two_sided(|level| self.compare_each(among, level, threshold), surely, || self.caps())
    }

    /// Whether all of them are within the threshold at this level, where that is known.
    fn compare_each(
        &self,
        among: &[Polygons<'_>],
        level: u32,
        threshold: &Rational,
    ) -> Result<Option<bool>, LimitError> {
        let (mut all, share) = (Some(true), self.budget().share_of_depth());
        for polygons in among {
            match self.compare_among(polygons, level, threshold, &share)? {
                Comparison::Within => {}
                Comparison::Exceeds(_) => return Ok(Some(false)),
                Comparison::Undecided(_) => all = None,
            }
        }
        Ok(all)
    }
}

/// The depth, by a search that tells whether a level meets the tolerance, or leaves that open.
///
/// Up to the first level that it leaves open, the levels are tried one by one. A level that
/// `surely` meets it without a search is an upper side, and between both the upper side is
/// brought down by halving: a search that has met its caps once would do so at each level.
pub(super) fn two_sided<E: From<LimitError>>(
    mut meets: impl FnMut(u32) -> Result<Option<bool>, E>,
    surely: impl Fn(u32) -> bool,
    caps: impl FnOnce() -> String,
) -> Result<TwoSidedDepth, E> {
    let mut lower = None;
    for level in 0..=MAX_LEVEL {
        match meets(level)? {
            Some(true) => return Ok(TwoSidedDepth { lower: level, upper: level }),
            Some(false) => {}
            None => {
                lower = Some(level);
                break;
            }
        }
    }
    let Some(lower) = lower else { return Err(LimitError::TooDeep.into()) };
    let (mut below, mut upper) = (lower, (lower..=MAX_LEVEL).find(|&level| surely(level)));
    while let Some(middle) = between(below, upper.unwrap_or(MAX_LEVEL + 1)) {
        if meets(middle)? == Some(true) {
            upper = Some(middle);
        } else {
            below = middle;
        }
    }
    let open = || LimitError::LeftOpen { lower, caps: caps() };
    Ok(TwoSidedDepth { lower, upper: upper.ok_or_else(open)? })
}

/// The level in the middle between two that are no neighbours.
fn between(below: u32, above: u32) -> Option<u32> {
    (above > below + 1).then(|| below + (above - below) / 2)
}
