//! Subdivision depths, bounded from above and below.

use super::comparison::Comparison;
use super::distance::Distances;
use super::polygon::{ControlPolygon, Polygons};
use crate::exact::Rational;
use crate::limit::error::{LimitError, MAX_LEVEL, positive};

/// A subdivision depth: the least level k such that the distance from the limit meets the
/// tolerance at level k and at every later one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TwoSidedDepth {
    /// A lower bound of the depth: it is 0, or level `lower` − 1 does not meet the
    /// tolerance.
    pub lower: u32,
    /// An upper bound of the depth: this level and all later ones meet the tolerance. If
    /// `lower` = `upper`, this is the depth.
    pub upper: u32,
}

impl Distances {
    /// The least k from which on every control polygon with max|Δ| ≤ `spread` is within
    /// `tolerance` of its limit: C_m·spread ≤ tolerance for all m ≥ k.
    ///
    /// The distance need not decrease with the level. But if T_c ≤ 1, then C_{m+c} ≤ C_m: if c
    /// levels in a row meet the tolerance, all later ones do. If C_k·spread is so close to the
    /// tolerance that the search does not decide within its caps, the two bounds of the depth may
    /// differ.
    ///
    /// Source: `proofs/THEOREMS.md`, 9.
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

    /// The least k from which on this control polygon is within `tolerance` of its limit.
    ///
    /// # Errors
    /// As [`Distances::depth`], and when the polygon is too short.
    pub fn depth_of_polygon(
        &self,
        polygon: &ControlPolygon,
        tolerance: &Rational,
    ) -> Result<TwoSidedDepth, LimitError> {
        self.depth_of_points(std::slice::from_ref(polygon), tolerance)
    }

    /// The least k from which on a control polygon of points is within `tolerance` of its
    /// limit in every coordinate. Each coordinate is a [`ControlPolygon`]. This is the
    /// greatest of the depths of the coordinates; the bounds are computed for all
    /// coordinates together.
    ///
    /// # Errors
    /// As [`Distances::depth_of_polygon`].
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
        // A bound for all polygons at a level also holds for refined polygons, so for later
        // levels. A bound for a single polygon need not.
        let all = among.iter().all(|own| own.only.is_none());
        let lasting = if all { self.lasting() } else { None };
        let meets = |level| self.compare_each(among, level, threshold);
        two_sided(meets, surely, lasting, || self.caps())
    }

    /// The least c with T_c ≤ 1. If c levels in a row are within a bound, all later ones
    /// are.
    #[must_use]
    pub fn lasting(&self) -> Option<u32> {
        let constants = self.limit().contraction();
        let c = constants.iter().skip(1).position(|constant| *constant <= Rational::one())?;
        u32::try_from(c + 1).ok()
    }

    /// Whether all polygons are within the threshold at this level; `None` if this is not
    /// decided.
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

/// The depth, from a search `meets` that says whether a level meets the tolerance, or leaves
/// this open (`None`).
///
/// If a level `surely` meets the tolerance by a bound without search, all later levels do. If
/// `lasting` is some c, and c levels in a row meet the tolerance, all later levels do. Levels
/// are tried upwards until the search leaves one open. After that they are tried downwards, from
/// the first level that surely meets the tolerance.
pub(crate) fn two_sided<E: From<LimitError>>(
    mut meets: impl FnMut(u32) -> Result<Option<bool>, E>,
    surely: impl Fn(u32) -> bool,
    lasting: Option<u32>,
    caps: impl FnOnce() -> String,
) -> Result<TwoSidedDepth, E> {
    let sure = (0..=MAX_LEVEL).find(|&level| surely(level));
    let (mut lower, mut start) = (0, None);
    for level in 0..=MAX_LEVEL {
        if sure == Some(level) {
            return Ok(TwoSidedDepth { lower, upper: start.unwrap_or(level) });
        }
        match meets(level)? {
            Some(true) => {
                let start = *start.get_or_insert(level);
                if lasting.is_some_and(|levels| level + 1 - start >= levels) {
                    return Ok(TwoSidedDepth { lower, upper: start });
                }
            }
            Some(false) => (lower, start) = (level + 1, None),
            None => {
                let open = LimitError::LeftOpen { lower, caps: caps() };
                let mut upper = sure.ok_or(open)?;
                while upper > level + 1 {
                    match meets(upper - 1)? {
                        Some(true) => upper -= 1,
                        Some(false) => return Ok(TwoSidedDepth { lower: upper, upper }),
                        None => break,
                    }
                }
                return Ok(TwoSidedDepth { lower, upper });
            }
        }
    }
    Err(LimitError::TooDeep.into())
}
