//! Schemes.

use crate::algebraic::Algebraic;
use crate::error::{of_scheme, plain, with_remedy};
use crate::facts::written;
use crate::geometry::known_level;
use crate::number::{Fraction, fraction, quotient, rational, rationals};
use crate::run::{aside, at_once};
use pyo3::prelude::*;
use std::ops::Bound as End;
use std::sync::{Arc, Mutex, PoisonError};
use subcert::bound::{
    Budget, Constants, Operator, Order, ParameterRange, Terms, displacement, polynomial_rules,
    surface_factor,
};
use subcert::exact::{Interval, Rational, RealAlgebraic};
use subcert::facts::{CurveFacts, LimitFacts, SchemeFacts};
use subcert::float::{CertifyOptions, certify};
use subcert::limit::{
    ControlPolygon, Distances, Functional, Limit, LimitError, Parametrisation, TwoSidedDepth,
    natural_shift,
};
use subcert::oracle::{Boundary, refine_polygon};
use subcert::patch::{CurveSets, SetKind};
use subcert::report::json::FactsForm;
use subcert::scheme::{AnyScheme, Mask, Scheme, catalogue, parse_any_scheme, parse_parametric};

/// Constants of at most so many classes times coefficients are computed without a thread.
const SMALL: u64 = 20_000;

/// A point that is far from the other set: whose it is, its parameter, its coordinates, a lower bound of the distance.
type FarPoint = (String, Fraction, Vec<f64>, f64);

/// The steps that a distance may take.
const STEPS: u64 = 1_000_000_000;

/// The names of the schemes of the catalogue.
#[pyfunction]
pub fn scheme_names() -> Vec<String> {
    catalogue().iter().map(|entry| entry.name.clone()).collect()
}

/// A scheme, with its constants as far as they are known.
#[pyclass(frozen, module = "subcert", name = "_Native")]
pub struct Native {
    scheme: Scheme,
    /// For each direction.
    constants: Arc<Mutex<Vec<Constants>>>,
}

/// A mask as `masks` gives it: its coefficients as pairs of integers, and its offset.
type Given<'py> = (Vec<Vec<(Bound<'py, PyAny>, Bound<'py, PyAny>)>>, i64);

/// A distance: its interval, and a parameter at which the lower end is the value.
type Distance = (Fraction, Fraction, Option<Fraction>);

/// Level, the greatest level that is too few, the distance at the level.
type Depth = (u32, Option<u32>, Distance);

/// A parameter, and the control points with their weights in the limit there.
type Stencil = (Fraction, Vec<(i64, Fraction)>);

/// Name, f64 value, exact value, proven bound of the error.
type Quantity = (String, f64, Fraction, Option<f64>);

impl Native {
    fn of(scheme: Scheme) -> Native {
        let constants = scheme.masks().into_iter().cloned().map(Constants::new).collect();
        Native { scheme, constants: Arc::new(Mutex::new(constants)) }
    }

    fn is_small(&self, c: u32) -> bool {
        let work = |mask: &Mask| {
            let arity = u64::try_from(mask.arity()).unwrap_or(u64::MAX);
            let width = u64::try_from(mask.width()).unwrap_or(u64::MAX);
            arity.saturating_pow(c).saturating_mul(width)
        };
        self.scheme.masks().into_iter().all(|mask| work(mask) <= SMALL)
    }

    /// A constant for blocks of c levels, with the same one along each direction of a surface.
    fn constant(
        &self,
        py: Python<'_>,
        c: u32,
        constant: fn(&[Constants], u32) -> PyResult<Rational>,
    ) -> PyResult<Fraction> {
        if c == 0 {
            return Err(plain("c counts levels from 1 on"));
        }
        if self.is_small(c) {
            let known = self.constants.lock().unwrap_or_else(PoisonError::into_inner);
            return at_once(|| Ok(fraction(&constant(&known, c)?)));
        }
        let new = |mask: &Mask| Constants::new(mask.clone());
        let fresh: Vec<Constants> = self.scheme.masks().into_iter().map(new).collect();
        aside(py, move || Ok(fraction(&constant(&fresh, c)?)))
    }

    pub(crate) fn mask(&self) -> PyResult<Mask> {
        match &self.scheme {
            Scheme::Curve(mask) => Ok(mask.clone()),
            Scheme::Tensor(..) => Err(with_remedy(
                "this is for curves, and the scheme is a tensor product",
                "take one of its two schemes",
            )),
        }
    }
}

#[pymethods]
impl Native {
    /// The scheme that a text names, as on the command line.
    #[staticmethod]
    fn named(text: &str) -> PyResult<Native> {
        match parse_any_scheme(text).map_err(|error| of_scheme(&error))? {
            AnyScheme::Uniform(scheme) => Ok(Native::of(scheme)),
            AnyScheme::Lattice(_) => Err(with_remedy(
                &format!("`{text}` is a mask on Z^d, or a product of three"),
                "Lattice is for it, and scheme and nets take its name",
            )),
            AnyScheme::LocalRules(_) => Err(with_remedy(
                &format!("`{text}` is a scheme around a vertex or on a face"),
                "spectrum, smoothness and sector are for it, and meshes take its name, as in mesh_depth",
            )),
        }
    }

    /// The scheme of a mask.
    #[staticmethod]
    fn of_mask(rows: Vec<Vec<Bound<'_, PyAny>>>, offset: i64) -> PyResult<Native> {
        let rows: Vec<Vec<Rational>> =
            rows.iter().map(|row| rationals(row)).collect::<PyResult<_>>()?;
        Ok(Native::of(Scheme::Curve(Mask::new(rows, offset).map_err(plain)?)))
    }

    /// The scheme of the masks that `masks` gives.
    #[staticmethod]
    fn of_masks(masks: Vec<Given<'_>>) -> PyResult<Native> {
        let mask = |(rows, offset): &Given<'_>| {
            let rows = rows.iter().map(|row| row.iter().map(quotient).collect());
            Mask::new(rows.collect::<PyResult<_>>()?, *offset).map_err(plain)
        };
        let mut masks = masks.iter().map(mask).collect::<PyResult<Vec<Mask>>>()?;
        match (masks.pop(), masks.pop(), masks.is_empty()) {
            (Some(mask), None, _) => Ok(Native::of(Scheme::Curve(mask))),
            (Some(second), Some(first), true) => Ok(Native::of(Scheme::Tensor(first, second))),
            _ => Err(plain("a scheme has one mask or two")),
        }
    }

    /// The masks: rows of coefficients, and the offset.
    #[getter]
    fn masks(&self) -> Vec<(Vec<Vec<Fraction>>, i64)> {
        let mask = |mask: &Mask| {
            let rows = mask.rules().rows().iter();
            (rows.map(|row| row.iter().map(fraction).collect()).collect(), mask.offset())
        };
        self.scheme.masks().into_iter().map(mask).collect()
    }

    /// T_c of a curve; the greater T_c·Λ_c of the two directions of a surface.
    fn contraction(&self, py: Python<'_>, c: u32) -> PyResult<Fraction> {
        self.constant(py, c, |constants, c| match constants {
            [one] => one.norm(Operator::Difference, c, Order::Adjoint).map_err(plain),
            [first, second] => {
                let [left, right] = [first.tensor_with(second, c), second.tensor_with(first, c)];
                Ok(left.map_err(plain)?.max(right.map_err(plain)?))
            }
            _ => Err(plain("a scheme of more than two directions")),
        })
    }

    /// Λ_c; the product of both directions of a surface.
    fn norm(&self, py: Python<'_>, c: u32) -> PyResult<Fraction> {
        self.constant(py, c, |constants, c| {
            let mut norms =
                constants.iter().map(|one| one.norm(Operator::Scheme, c, Order::Adjoint));
            norms.try_fold(Rational::one(), |product, norm| Ok(product * norm.map_err(plain)?))
        })
    }

    /// σ at the scheme's own offset.
    fn displacement(&self) -> PyResult<Fraction> {
        at_once(|| {
            Ok(fraction(&match &self.scheme {
                Scheme::Curve(mask) => displacement(mask, Terms::Each),
                Scheme::Tensor(first, second) => surface_factor(first, second),
            }))
        })
    }

    /// For each direction, the natural shift s: point i of level k is at (i + s)/n^k up to a term that
    /// vanishes; `None` where the mask takes lines to no lines.
    fn natural_shifts(&self) -> Vec<Option<Fraction>> {
        let shift = |mask: &Mask| {
            let natural = natural_shift(mask);
            natural.keeps_lines.then(|| fraction(&natural.shift))
        };
        self.scheme.masks().into_iter().map(shift).collect()
    }

    /// Where the limit is a combination of control points, and their weights: at 0, and at the natural shift, where
    /// x_0 tends to.
    fn limit_stencils(&self, py: Python<'_>) -> PyResult<Vec<Stencil>> {
        let mask = self.mask()?;
        aside(py, move || {
            let limit = Limit::new(&mask).map_err(plain)?;
            let LimitFacts { at_zero, at_shift } = LimitFacts::of(&limit).map_err(plain)?;
            let weights = |stencil: &Functional| {
                stencil.terms().map(|(i, weight)| (i, fraction(weight))).collect()
            };
            let zero = (fraction(&Rational::zero()), weights(&at_zero));
            let moved = at_shift.map(|(at, stencil)| (fraction(&at), weights(&stencil)));
            Ok([zero].into_iter().chain(moved).collect())
        })
    }

    /// All facts of the mask of a curve, as the JSON that `subcert scheme` writes, under this name.
    fn facts_json(&self, py: Python<'_>, name: String) -> PyResult<String> {
        let mask = self.mask()?;
        aside(py, move || {
            let facts = SchemeFacts::Rational(Box::new(CurveFacts::of_rational(&mask)));
            written(&FactsForm::of(&name, &facts), None)
        })
    }

    /// The depth of all control polygons of this spread.
    fn depth(
        &self,
        py: Python<'_>,
        tolerance: &Bound<'_, PyAny>,
        spread: &Bound<'_, PyAny>,
        natural: bool,
    ) -> PyResult<Depth> {
        let (tolerance, spread, mask) = (rational(tolerance)?, rational(spread)?, self.mask()?);
        aside(py, move || {
            let distances = distances(&mask, natural)?;
            let depth = distances.depth(&spread, &tolerance).map_err(plain)?;
            let width = &tolerance / &(&spread * &Rational::from(1000));
            let distance = distances.constant(depth.upper, &width);
            found(depth, distance, &spread)
        })
    }

    /// The depth of one control polygon: one list for each coordinate.
    fn polygon_depth(
        &self,
        py: Python<'_>,
        tolerance: &Bound<'_, PyAny>,
        coordinates: Vec<Vec<Bound<'_, PyAny>>>,
        closed: bool,
        natural: bool,
    ) -> PyResult<Depth> {
        let (tolerance, mask) = (rational(tolerance)?, self.mask()?);
        let polygon = |points: &Vec<Bound<'_, PyAny>>| {
            let points = rationals(points)?;
            Ok(if closed { ControlPolygon::closed(&points) } else { ControlPolygon::open(&points) })
        };
        let polygons: Vec<ControlPolygon> =
            coordinates.iter().map(polygon).collect::<PyResult<_>>()?;
        aside(py, move || {
            let distances = distances(&mask, natural)?;
            let depth = distances.depth_of_points(&polygons, &tolerance).map_err(plain)?;
            let width = &tolerance / &Rational::from(1000);
            let of = |polygon| distances.of_polygon(polygon, depth.upper, &width);
            let greatest = polygons.iter().map(of).reduce(|left, right| {
                let (left, right) = (left?, right?);
                let first = left.enclosure.lower() >= right.enclosure.lower();
                Ok(if first { left } else { right })
            });
            let greatest =
                greatest.ok_or_else(|| plain("a control polygon without coordinates"))?;
            found(depth, greatest, &Rational::one())
        })
    }

    /// The depth of one control polygon by the distance of sets: one list for each coordinate.
    fn geometric_depth(
        &self,
        py: Python<'_>,
        tolerance: &Bound<'_, PyAny>,
        coordinates: Vec<Vec<Bound<'_, PyAny>>>,
        closed: bool,
    ) -> PyResult<(u32, Option<u32>, Option<FarPoint>)> {
        let (tolerance, mask) = (rational(tolerance)?, self.mask()?);
        let coordinates: Vec<Vec<Rational>> =
            coordinates.iter().map(|own| rationals(own)).collect::<PyResult<_>>()?;
        if coordinates.len() < 2 {
            return Err(plain("points of two coordinates or more have a distance of sets"));
        }
        aside(py, move || {
            let limit = Limit::new(&mask).map_err(plain)?;
            let mut sets = CurveSets::new(&limit, &coordinates, closed).map_err(plain)?;
            let found = sets.depth(&tolerance).map_err(plain)?;
            let level = known_level(&found)?;
            let place = found.beyond.map(|place| {
                let of = if place.from == SetKind::Mesh { "polygon" } else { "limit" };
                (of.to_owned(), fraction(&place.parameter), place.point, place.distance)
            });
            Ok((level, found.too_few, place))
        })
    }

    /// The points of a polygon after some levels: one list for each coordinate.
    fn refine(
        &self,
        py: Python<'_>,
        coordinates: Vec<Vec<Bound<'_, PyAny>>>,
        levels: u32,
        closed: bool,
    ) -> PyResult<Vec<Vec<Fraction>>> {
        let mask = self.mask()?;
        let read = coordinates.iter().map(|points| rationals(points));
        let coordinates: Vec<Vec<Rational>> = read.collect::<PyResult<_>>()?;
        let boundary = if closed { Boundary::Closed } else { Boundary::Open };
        let small = coordinates.iter().all(|points| points.len() <= 64) && levels <= 4;
        let work = move || {
            let refined = |points: &Vec<Rational>| {
                let refined = refine_polygon(mask.rules(), points, levels, boundary);
                Ok(refined.map_err(plain)?.iter().map(fraction).collect())
            };
            coordinates.iter().map(refined).collect()
        };
        if small { at_once(work) } else { aside(py, work) }
    }

    /// The f64 constants beside the exact ones.
    fn certify(&self, py: Python<'_>, levels: u32) -> PyResult<Vec<Quantity>> {
        let scheme = self.scheme.clone();
        aside(py, move || {
            let options = CertifyOptions { max_block: levels, ..Default::default() };
            let found = certify(&scheme, &options).map_err(plain)?;
            let quantity =
                |x: subcert::float::Quantity| (x.name, x.value, fraction(&x.exact), x.bound);
            Ok(found.quantities.into_iter().map(quantity).collect())
        })
    }
}

fn distances(mask: &Mask, natural: bool) -> PyResult<Distances> {
    let placed = if natural { Parametrisation::Natural } else { Parametrisation::Indexed };
    let limit = Limit::new(mask).map_err(plain)?;
    let distances = Distances::placed(&limit, placed).map_err(plain)?;
    Ok(distances.with_cells(u32::MAX).with_budget(Budget::new(STEPS)))
}

/// A depth with the distance there, times a factor.
fn found(
    depth: TwoSidedDepth,
    distance: Result<subcert::limit::Distance, LimitError>,
    factor: &Rational,
) -> PyResult<Depth> {
    let (enclosure, parameter) = match distance {
        Ok(distance) => (distance.enclosure, Some(fraction(&distance.parameter))),
        // The caps leave it wide.
        Err(LimitError::TooFine { reached, .. }) => (*reached, None),
        Err(error) => return Err(plain(error)),
    };
    let [lower, upper] =
        [enclosure.lower(), enclosure.upper()].map(|end| fraction(&(end * factor)));
    Ok((depth.upper, depth.lower.checked_sub(1), (lower, upper, parameter)))
}

/// An open interval; `None` for an end at infinity.
pub(crate) type Ends = (Option<Algebraic>, Option<Algebraic>);

/// Where in a parameter T_c < 1, for c = 1, …, `levels`, and where for any of them.
#[pyfunction]
pub fn parameter_range(
    py: Python<'_>,
    text: &str,
    parameter: &str,
    levels: u32,
) -> PyResult<(Vec<Vec<Ends>>, Vec<Ends>)> {
    let difference = parse_parametric(text, parameter).map_err(plain)?.difference();
    let difference = polynomial_rules(&difference, parameter).map_err(plain)?;
    aside(py, move || {
        let range = ParameterRange::new(&difference, levels).map_err(plain)?;
        let of = |intervals: &[Interval]| intervals.iter().map(ends).collect::<Vec<Ends>>();
        let each = range.levels.iter().map(|set| of(set.intervals())).collect();
        Ok((each, of(range.union.intervals())))
    })
}

pub(crate) fn ends(interval: &Interval) -> Ends {
    let end = |bound: &End<RealAlgebraic>| match bound {
        End::Included(x) | End::Excluded(x) => Some(Algebraic(x.clone())),
        End::Unbounded => None,
    };
    (end(&interval.low), end(&interval.high))
}
