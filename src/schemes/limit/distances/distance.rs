//! The distance of a polygon from its limit, bounded from above and below.

use super::cell::{Cell, Splitting};
use super::middles::middles;
use super::polygon::{ControlPolygon, Polygons};
use super::remainder::Remainders;
use super::search::{Best, Search};
use crate::bound::{Budget, Share};
use crate::exact::{Enclosure, Integer, Rational};
use crate::limit::error::{LimitError, MAX_LEVEL, positive};
use crate::limit::functional::Functional;
use crate::limit::natural::Parametrisation;
use crate::limit::value::Limit;
use crate::limit::window::determined;

/// The greatest number of cells that the computation of one distance splits.
pub const MAX_CELLS: u32 = 1 << 18;

/// A distance ‖P^∞ − P^k‖_∞, and a parameter at which it is attained, or nearly so.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Distance {
    /// An enclosure of the distance.
    pub enclosure: Enclosure,
    /// A t at which |P^∞(t) − P^k(t)| is the lower end of the enclosure. For the distance
    /// constant, the polygon is the extremal polygon of [`Limit::error`] at t.
    pub parameter: Rational,
}

/// The true distances of polygons from their limits.
///
/// The distance constant is `C_k = sup ‖P^∞ − P^k‖_∞` over the control polygons with
/// max|Δ| ≤ 1: the least number for which `‖P^∞ − P^k‖_∞ ≤ C_k max|Δ|` always.
///
/// It is the supremum over t of the norm of P^∞(t) − P^k(t) as a functional of Δ. The
/// intervals between neighbouring points of a level are split again and again. The exact
/// values at their ends bound the supremum from below. Together with a bound of P^∞
/// between the ends they bound it from above. Only intervals that may contain the
/// supremum are split.
///
/// Source: `proofs/THEOREMS.md`, 5–9, 81 and 88.
///
/// ```
/// use subcert::exact::{Enclosure, Rational};
/// use subcert::limit::{Distances, Limit};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("b-spline:degree=3")?;
/// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
/// // The cubic B-spline curve is within (1/3)·4^−k of its polygons, and no nearer.
/// let constant = distances.constant(2, &Rational::new(1, 1000))?;
/// assert_eq!(constant.enclosure, Enclosure::exact(Rational::new(1, 48)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Distances {
    limit: Limit,
    shift: Rational,
    remainders: Remainders,
    splitting: Splitting,
    cells: u32,
    budget: Budget,
}

impl Distances {
    /// The distances from this limit of the polygons with x^k_i at i/n^k. Each is computed
    /// with at most [`MAX_CELLS`] cells.
    ///
    /// # Errors
    /// When the window of differences that determines P^∞ − P^0 between two points is
    /// wider than [`MAX_WINDOW`](crate::limit::MAX_WINDOW).
    pub fn new(limit: &Limit) -> Result<Distances, LimitError> {
        Distances::placed(limit, Parametrisation::Indexed)
    }

    /// The distances of the polygons with x^k_i at its natural parameter (i + s)/n^k,
    /// with s from [`natural_shift`](crate::limit::natural_shift).
    ///
    /// # Errors
    /// As [`Distances::shifted`].
    ///
    /// ```
    /// use subcert::exact::{Enclosure, Rational};
    /// use subcert::limit::{Distances, Limit};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("chaikin")?;
    /// let distances = Distances::natural(&Limit::new(scheme.masks()[0])?)?;
    /// // The quadratic B-spline curve is within 4^−(k+1) of its polygons, and no nearer.
    /// let constant = distances.constant(2, &Rational::new(1, 10_000))?;
    /// assert_eq!(constant.enclosure, Enclosure::exact(Rational::new(1, 64)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn natural(limit: &Limit) -> Result<Distances, LimitError> {
        Distances::placed(limit, Parametrisation::Natural)
    }

    /// The distances of the polygons in the given parametrisation.
    ///
    /// # Errors
    /// As [`Distances::shifted`].
    pub fn placed(
        limit: &Limit,
        parametrisation: Parametrisation,
    ) -> Result<Distances, LimitError> {
        Distances::shifted(limit, &parametrisation.shift(limit.mask()))
    }

    /// The distances of the polygons with x^k_i at (i + shift)/n^k.
    ///
    /// # Errors
    /// As [`Distances::new`], and when the digits of the shift do not repeat soon enough for
    /// [`Limit::at`].
    pub fn shifted(limit: &Limit, shift: &Rational) -> Result<Distances, LimitError> {
        let middles = middles(limit, shift)?;
        let splitting = Splitting::new(limit, shift, &middles)?;
        let remainders = Remainders::new(limit, shift, &middles)?;
        let (limit, shift) = (limit.clone(), shift.clone());
        let (cells, budget) = (MAX_CELLS, Budget::unlimited());
        Ok(Distances { limit, shift, remainders, splitting, cells, budget })
    }

    /// These distances with another cap on the number of cells.
    #[must_use]
    pub fn with_cells(self, cells: u32) -> Distances {
        Distances { cells, ..self }
    }

    /// These distances with a budget, which other computations may share.
    #[must_use]
    pub fn with_budget(self, budget: Budget) -> Distances {
        Distances { budget, ..self }
    }

    /// The budget.
    #[must_use]
    pub fn budget(&self) -> &Budget {
        &self.budget
    }

    /// The number of differences on which a cell depends.
    pub(crate) fn window(&self) -> usize {
        self.splitting.size
    }

    /// A text that states the caps of a search.
    #[must_use]
    pub fn caps(&self) -> String {
        self.budget.caps(self.cells, "a level")
    }

    /// The limit.
    #[must_use]
    pub fn limit(&self) -> &Limit {
        &self.limit
    }

    /// The shift s of the points at (i + s)/n^k.
    #[must_use]
    pub fn shift(&self) -> &Rational {
        &self.shift
    }

    /// P^∞(t) − P^k(t) as a functional of Δ.
    ///
    /// # Errors
    /// As [`Limit::error`].
    pub fn error(&self, level: u32, t: &Rational) -> Result<Functional, LimitError> {
        self.limit.error_from(level, t, &self.shift)
    }

    /// An enclosure of C_k of at most this width.
    ///
    /// # Errors
    /// When k is above 128, the width is not positive, or the width is not reached within
    /// the cap on cells and within 96 levels beyond k.
    pub fn constant(&self, level: u32, width: &Rational) -> Result<Distance, LimitError> {
        self.enclose(&self.any_polygon(), level, width)
    }

    /// An enclosure of ‖P^∞ − P^k‖_∞ of at most this width, for this control polygon.
    ///
    /// # Errors
    /// As [`Distances::constant`], and when the polygon is too short.
    ///
    /// ```
    /// use subcert::exact::{Enclosure, Rational};
    /// use subcert::limit::{ControlPolygon, Distances, Limit};
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("chaikin")?;
    /// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
    /// let square = ControlPolygon::closed(&[0, 4, 4, 0].map(Rational::from));
    /// let distance = distances.of_polygon(&square, 1, &Rational::new(1, 1000))?;
    /// assert_eq!(distance.enclosure, Enclosure::exact(Rational::one()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_polygon(
        &self,
        polygon: &ControlPolygon,
        level: u32,
        width: &Rational,
    ) -> Result<Distance, LimitError> {
        self.enclose(&self.this_polygon(polygon)?, level, width)
    }

    fn enclose(
        &self,
        among: &Polygons,
        level: u32,
        width: &Rational,
    ) -> Result<Distance, LimitError> {
        positive("the width", width)?;
        let share = self.budget.share();
        let (mut search, mut best) = self.search(among, level, &share)?;
        let mut upper = self.unsearched(among, level);
        if self.looks_at_roots(among, &share) {
            upper = search.bound(&mut best).min(upper);
        }
        upper = search.narrowed(upper, width, &mut best);
        let enclosure = Enclosure::new(best.value.clone(), upper);
        if enclosure.width() > *width {
            return Err(LimitError::TooFine { cells: self.cells, reached: Box::new(enclosure) });
        }
        Ok(Distance { enclosure, parameter: best.parameter })
    }

    /// The search for the distance at level k, and a first lower bound of it.
    pub(crate) fn search<'a>(
        &'a self,
        among: &'a Polygons,
        level: u32,
        share: &'a Share<'a>,
    ) -> Result<(Search<'a>, Best), LimitError> {
        if level > MAX_LEVEL {
            return Err(LimitError::Level(level));
        }
        // The first point of level k in the first cell, or both ends of what an open polygon determines.
        let points = Rational::from(self.limit.mask().arity()).pow(level.cast_signed());
        let node = self.shift.fract() / points;
        let first = Rational::from(among.roots[0].index.clone()) + node;
        let ends = among.range.iter().flatten().cloned();
        let tried = ends.chain(among.range.is_none().then_some(first));
        let mut best = Best { value: Rational::from(-1), parameter: Rational::zero() };
        for parameter in tried {
            let error = self.error(level, &parameter)?;
            let value = match among.only {
                Some(polygon) => error.apply(|i| polygon.difference(i)).abs(),
                None => error.norm(),
            };
            if value > best.value {
                best = Best { value, parameter };
            }
        }
        let (splitting, remainders) = (&self.splitting, &self.remainders);
        let search = Search::new(splitting, remainders, among, level, self.cells, share);
        Ok((search, best))
    }

    /// Takes the steps for bounding the cells of level 0; `false` if they do not remain.
    pub(super) fn looks_at_roots(&self, among: &Polygons, share: &Share) -> bool {
        share.take(self.splitting.cost_of_roots(&among.roots[0], among.roots.len()))
    }

    /// An upper bound of C_k without a search. It does not increase with the level.
    #[must_use]
    pub fn at_most(&self, level: u32) -> Rational {
        self.remainders.of_all(level)
    }

    /// An upper bound of the distance at level k without a search.
    pub(crate) fn unsearched(&self, among: &Polygons, level: u32) -> Rational {
        let of_all = self.remainders.of_all(level);
        among.only.map_or(of_all.clone(), |polygon| of_all * polygon.spread())
    }

    /// All polygons: a single cell stands for all cells, and its differences are the
    /// unit vectors.
    pub(crate) fn any_polygon(&self) -> Polygons<'static> {
        let size = self.splitting.size;
        let unit = |at: usize| (0..size).map(|i| Integer::from(u32::from(i == at))).collect();
        let rows = (0..size).map(unit).collect();
        let roots = vec![Cell::root(Integer::zero(), rows, Integer::one())];
        Polygons { roots, range: None, only: None }
    }

    /// This polygon only.
    pub(super) fn this_polygon<'a>(
        &self,
        polygon: &'a ControlPolygon,
    ) -> Result<Polygons<'a>, LimitError> {
        let Splitting { first, size, .. } = self.splitting;
        let (numbers, range) = if polygon.is_closed() {
            let count = i64::try_from(polygon.count()).unwrap_or(i64::MAX);
            if count == 0 {
                return Err(LimitError::TooFew { needed: 1 });
            }
            (-first..count - first, None)
        } else {
            let [start, end] = determined(self.limit.mask(), &self.shift, polygon.count())?;
            let whole = |x: Integer| x.to_i64().expect("offsets and polygons are capped");
            // Cells begin at i + {s}/n^k. One more has the first part of the range.
            let before = i64::from(!self.shift.is_integer());
            (whole(start.floor()) - before..-whole((-&end).floor()), Some([start, end]))
        };
        let roots = polygon.cells(numbers, first, size);
        Ok(Polygons { roots, range, only: Some(polygon) })
    }
}
