//! The least level whose polygon is within a tolerance of the curve as a set of points.

use super::super::geometric::{GeometricDepth, LEAST_SHARE, SetKind};
use super::cells::{Cells, Shape};
use super::find::{Finder, MAX_POINTS};
use super::level::{CurveNearness, FarPoint, LevelSearch};
use super::points::RefinedPoints;
use crate::bound::Budget;
use crate::exact::Rational;
use crate::float::{lower, nearest};
use crate::limit::{Limit, LimitError};
use crate::patch::range::beyond;

/// The highest level that is looked at.
const MAX_LEVEL: u32 = 24;

/// How many pieces of a curve are looked at without another budget.
pub const MAX_CURVE_PIECES: u64 = 60_000_000;

/// How many levels a control polygon needs as a set of points.
pub type CurveDepth = GeometricDepth<CurvePlace>;

/// A point of one set that is far from all of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePlace {
    /// The set that has the point: [`SetKind::Mesh`] is the polygon.
    pub from: SetKind,
    /// Its natural parameter.
    pub parameter: Rational,
    /// The point, to f64.
    pub point: Vec<f64>,
    /// A lower bound of its distance from the other set.
    pub distance: f64,
}

/// A control polygon of points, its refinements and its limit curve as sets of points.
pub struct CurveSets {
    finder: Finder,
    scale: Rational,
    centre: Vec<f64>,
    width: Rational,
}

impl CurveSets {
    /// The sets of the polygon whose points have these coordinates: all x, then all y, and so on. An open polygon, and its
    /// limit, are compared where the given points determine the limit, at all levels between the same natural parameters:
    /// those of [`determined`](crate::limit::determined).
    ///
    /// # Errors
    /// When the scheme is not shown to converge, does not take lines to lines, or the points are too few.
    ///
    /// # Panics
    /// When there are no coordinates, or not as many of each.
    pub fn new(
        limit: &Limit,
        coordinates: &[Vec<Rational>],
        closed: bool,
    ) -> Result<CurveSets, LimitError> {
        let count = coordinates[0].len();
        assert!(coordinates.iter().all(|own| own.len() == count), "as many of each coordinate");
        let ends = |own: &Vec<Rational>| {
            let low = own.iter().min().cloned().unwrap_or_else(Rational::zero);
            let high = own.iter().max().cloned().unwrap_or_else(Rational::zero);
            (low, high)
        };
        let half = Rational::new(1, 2);
        let (mut width, mut middles) = (Rational::zero(), Vec::new());
        for own in coordinates {
            let (low, high) = ends(own);
            width = width.max(&high - &low);
            middles.push(&(&low + &high) * &half);
        }
        if let Some(reason) = beyond(coordinates.iter().flatten(), &width) {
            return Err(LimitError::Sets { reason });
        }
        // In units of the width, so that no number is too large or too small.
        let scale = if width.is_zero() { Rational::one() } else { width.clone() };
        let unit = &scale;
        let scaled = |i: usize| {
            let own = coordinates.iter().zip(&middles);
            own.map(move |(own, middle)| nearest(&((&own[i] - middle) / unit)))
        };
        let control: Vec<f64> = (0..count).flat_map(scaled).collect();
        let shape = Shape::new(limit, count, closed)?;
        let at_zero = limit.at(&Rational::zero())?;
        let rules = limit.mask().rules();
        let (dimensions, growth) = (coordinates.len(), shape.growth());
        let points = RefinedPoints::new(rules, &at_zero, control, dimensions, closed, growth);
        let finder = Finder::new(Cells::new(shape, points, 1.0), Budget::new(MAX_CURVE_PIECES));
        let centre = middles.iter().map(nearest).collect();
        Ok(CurveSets { finder, scale, centre, width })
    }

    /// These sets with a budget of pieces, which others may share; it is [`MAX_CURVE_PIECES`] without it.
    #[must_use]
    pub fn with_budget(mut self, budget: Budget) -> CurveSets {
        self.finder.budget = budget;
        self
    }

    /// The natural parameters between which an open polygon and its limit are compared; `None` for a closed one.
    #[must_use]
    pub fn range(&self) -> Option<&[Rational; 2]> {
        self.finder.cells.shape.range.as_ref()
    }

    /// The least level k with H_k ≤ ε, where
    ///
    /// H_k = max(sup_{p ∈ P^∞} d(p, P^k), sup_{q ∈ P^k} d(q, P^∞))
    ///
    /// is the Hausdorff distance of the polygon P^k of level k from the limit curve P^∞, d the Euclidean distance of a
    /// point from a set. Points are computed in f64 with bounds of their errors; what these and the caps leave open is
    /// open: then `level` is more than `too_few` + 1, or `None`.
    ///
    /// Source: `proofs/THEOREMS.md`, 164 and 165.
    ///
    /// # Errors
    /// When the tolerance is not positive, or too small.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Limit;
    /// use subcert::patch::CurveSets;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = Limit::new(parse_scheme("chaikin")?.masks()[0])?;
    /// let square = [[0, 4, 4, 0], [0, 0, 4, 4]].map(|own| own.map(Rational::from).to_vec());
    /// let mut sets = CurveSets::new(&chaikin, &square, true)?;
    /// // A corner of the square is √2/2 from the curve; that of the octagon at level 1 is less than 1/5 from it.
    /// let depth = sets.depth(&Rational::new(1, 2))?;
    /// assert_eq!((depth.level, depth.too_few), (Some(1), Some(0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn depth(&mut self, tolerance: &Rational) -> Result<CurveDepth, LimitError> {
        let scaled = self.scaled(tolerance)?;
        let (mut places, mut certain) = (Vec::new(), true);
        for level in 0..=MAX_LEVEL {
            if !self.finder.cells.is_numbered(level + 1) {
                break;
            }
            self.finder.spend(4);
            let mut search = LevelSearch { finder: &mut self.finder, level, tolerance: scaled };
            match search.examine() {
                CurveNearness::Near => return Ok(CurveDepth::new(level, places)),
                CurveNearness::Far(far) if certain => places.push(self.place(&far)),
                CurveNearness::Far(_) => {}
                CurveNearness::Open => certain = false,
            }
            self.finder.tidy();
            self.finder.rest = 0;
            if self.finder.is_at_its_end() {
                break;
            }
        }
        let reason = format!(
            "it needs more than {MAX_LEVEL} levels, or more than {} pieces of the curve or {MAX_POINTS} points, or is too near to \
             call",
            self.finder.budget.total()
        );
        Ok(CurveDepth::ended(None, reason, places))
    }

    /// Whether H_k ≤ ε at one level; `None` where that is not decided.
    ///
    /// # Errors
    /// When the tolerance is not positive, or too small.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Limit;
    /// use subcert::patch::CurveSets;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = Limit::new(parse_scheme("chaikin")?.masks()[0])?;
    /// let square = [[0, 4, 4, 0], [0, 0, 4, 4]].map(|own| own.map(Rational::from).to_vec());
    /// let mut sets = CurveSets::new(&chaikin, &square, true)?;
    /// assert_eq!(sets.is_within(0, &Rational::new(1, 2))?, Some(false));
    /// assert_eq!(sets.is_within(0, &Rational::new(3, 4))?, Some(true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_within(
        &mut self,
        level: u32,
        tolerance: &Rational,
    ) -> Result<Option<bool>, LimitError> {
        let tolerance = self.scaled(tolerance)?;
        if level > MAX_LEVEL || !self.finder.cells.is_numbered(level + 1) {
            return Ok(None);
        }
        self.finder.tidy();
        let known = LevelSearch { finder: &mut self.finder, level, tolerance }.examine();
        Ok(match known {
            CurveNearness::Near => Some(true),
            CurveNearness::Far(_) => Some(false),
            CurveNearness::Open => None,
        })
    }

    /// The tolerance in the units of the search.
    fn scaled(&self, tolerance: &Rational) -> Result<f64, LimitError> {
        if tolerance.sign() <= 0 {
            let (what, value) = ("the tolerance", tolerance.to_string());
            return Err(LimitError::NotPositive { what, value });
        }
        let least = &self.width * &Rational::new(1, 1 << LEAST_SHARE);
        if *tolerance < least {
            return Err(LimitError::Sets {
                reason: format!(
                    "a tolerance is at least 2^-{LEAST_SHARE} of the greatest width of the polygon"
                ),
            });
        }
        Ok(lower(&(tolerance / &self.scale)))
    }

    fn place(&self, far: &FarPoint) -> CurvePlace {
        let (level, i) = far.at;
        let shape = &self.finder.cells.shape;
        let points = Rational::from(shape.arity.pow(level));
        let own = match far.from {
            SetKind::Limit => Rational::from(i),
            SetKind::Mesh => {
                let share = crate::float::exact(far.share).unwrap_or_else(Rational::zero);
                &(&Rational::from(i) + &share) + &shape.shift
            }
        };
        let scale = nearest(&self.scale);
        let point = far.point.iter().zip(&self.centre).map(|(x, centre)| x * scale + centre);
        CurvePlace {
            from: far.from,
            parameter: own / points,
            point: point.collect(),
            distance: far.distance * scale * (1.0 - 1e-14),
        }
    }
}
