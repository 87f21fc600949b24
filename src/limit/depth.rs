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
    /// cap on cells, the two sides can stay apart.
    ///
    /// # Errors
    /// When the tolerance or the spread is not positive, or no level up to 128 is
    /// shown to meet the tolerance.
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
        let mut undecided = None;
        for level in 0..=MAX_LEVEL {
            match self.compare_each(among, level, threshold)? {
                Some(true) => {
                    return Ok(TwoSidedDepth { lower: undecided.unwrap_or(level), upper: level });
                }
                Some(false) => {}
                None => undecided = undecided.or(Some(level)),
            }
        }
        Err(LimitError::TooDeep)
    }

    /// Whether all of them are within the threshold at this level, where that is known.
    fn compare_each(
        &self,
        among: &[Polygons<'_>],
        level: u32,
        threshold: &Rational,
    ) -> Result<Option<bool>, LimitError> {
        let mut all = Some(true);
        for polygons in among {
            match self.compare_among(polygons, level, threshold)? {
                Comparison::Within => {}
                Comparison::Exceeds(_) => return Ok(Some(false)),
                Comparison::Undecided(_) => all = None,
            }
        }
        Ok(all)
    }
}
