//! What is drawn of a scheme, with exact coordinates: values of the basic limit function, a refined polygon, maps of
//! parameters, rings.

use super::family_drawing::FamilyDrawing;
use super::lattice_shape::LatticeShape;
use super::scheme::{SchemeFacts, valences};
use crate::characteristic::Vertex;
use crate::exact::{FieldElement, Rational};
use crate::lattice::LatticeSmoothness;
use crate::scheme::{
    AnyScheme, LatticeMask, Mask, Scheme, SchemeError, names_ring, parse_algebraic,
    parse_any_scheme, parse_scheme,
};
use crate::smoothness::{BasicError, BasicValues, Coefficient, Sides, Smoothness};
use crate::spectrum::SpectrumError;
use crate::stop::Stop;

/// The least number of values of a function that is drawn, where a cap does not stop it.
const MIN_VALUES: usize = 160;

/// The most derivatives that are drawn.
pub const MAX_DERIVATIVES: usize = 3;

/// The sample polygon is refined so many times.
pub const LEVELS: usize = 5;

/// The corners of the sample polygon, which is closed.
pub const SAMPLE: [[i64; 2]; 6] = [[0, 1], [1, 5], [4, 3], [7, 6], [9, 2], [5, 0]];

/// The most points of a level of the sample polygon, and of its limit.
const MAX_POINTS: usize = 20_000;

/// The same over a field of irrational numbers.
const MAX_FIELD_POINTS: usize = 800;

/// The least number of points of its limit, where the cap does not stop it.
const MIN_LIMIT: usize = 300;

/// The valences of rings that are drawn of rules that state none.
const VALENCES: [usize; 3] = [3, 5, 7];

/// What is drawn of a scheme.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Of a mask, with rational or with irrational coefficients.
    pub curve: Option<CurveDrawing>,
    /// Of a mask on Z^d, or why nothing is drawn.
    pub lattice: Option<Result<LatticeShape, String>>,
    /// Where in its open parameters the limits are smooth.
    pub family: Option<FamilyDrawing>,
    /// The characteristic rings of rules around a vertex or on a face, with their valences.
    pub rings: Vec<(usize, Result<Vertex, SpectrumError>)>,
}

/// What is drawn of a mask.
#[derive(Clone, Debug)]
pub enum CurveDrawing {
    /// With rational coefficients.
    Rational(CurveShape),
    /// With irrational coefficients.
    Algebraic(CurveShape<FieldElement>),
}

/// The basic limit function with its derivatives, and a refined polygon.
#[derive(Clone, Debug)]
pub struct CurveShape<F = Rational> {
    /// φ, φ′, …, as far as they are proven to be continuous, up to [`MAX_DERIVATIVES`].
    pub functions: Vec<BasicValues<F>>,
    /// Why there are no more; `None` where the cap ends them.
    pub end: Option<String>,
    /// The points of the levels of the polygon, up to [`LEVELS`], as far as the caps allow.
    pub levels: Vec<Vec<[F; 2]>>,
    /// Points of its limit, in their order; `None` where the scheme is not proven to converge.
    pub limit: Option<Vec<[F; 2]>>,
}

impl Drawing {
    /// What is drawn of a scheme of the catalogue, a file, or a mask. The region is that of a map of two parameters, in which
    /// `boxes` boxes are examined for each order of smoothness.
    ///
    /// # Errors
    /// When there is no such scheme, or it is a tensor product, or it has parameters without a value that are neither one nor
    /// two in which its coefficients are polynomials.
    ///
    /// ```
    /// use subcert::facts::Drawing;
    ///
    /// let region = || [[-1, 1].map(Into::into), [-1, 1].map(Into::into)];
    /// let drawing = Drawing::of("chaikin", &region(), 100)?;
    /// assert!(drawing.curve.is_some() && drawing.family.is_none() && drawing.rings.is_empty());
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    pub fn of(scheme: &str, region: &Sides, boxes: usize) -> Result<Drawing, SchemeError> {
        let family = || FamilyDrawing::of(scheme, region, boxes);
        let none = Drawing { curve: None, lattice: None, family: None, rings: Vec::new() };
        match parse_any_scheme(scheme) {
            Ok(AnyScheme::Uniform(Scheme::Tensor(first, second))) => {
                let product = LatticeMask::product(&[&first, &second]);
                let drawn = product.map_err(|error| error.to_string());
                let lattice = Some(drawn.and_then(|mask| lattice_shape(&mask, None)));
                Ok(Drawing { lattice, ..none })
            }
            Ok(AnyScheme::Uniform(Scheme::Curve(mask))) => {
                let curve = Some(CurveDrawing::Rational(CurveShape::of(&mask, None)));
                Ok(Drawing { curve, family: family(), ..none })
            }
            Ok(AnyScheme::Lattice(mask)) => {
                let lattice = Some(lattice_shape(&mask, None));
                Ok(Drawing { lattice, family: family(), ..none })
            }
            Ok(AnyScheme::LocalRules(_)) => match SchemeFacts::of(scheme)? {
                SchemeFacts::Surface(rings) => Ok(Drawing { rings, ..none }),
                _ => Ok(none),
            },
            Err(error) => {
                if names_ring(scheme)? {
                    let ring = |n| (n, Vertex::of(scheme, Some(n)));
                    let drawn = drawn(&valences(scheme, error)?).into_iter();
                    return Ok(Drawing { rings: drawn.map(ring).collect(), ..none });
                }
                if let Ok(mask) = parse_algebraic(scheme) {
                    let curve = Some(CurveDrawing::Algebraic(CurveShape::of(&mask, None)));
                    return Ok(Drawing { curve, ..none });
                }
                let family = family().ok_or(error)?;
                Ok(Drawing { family: Some(family), ..none })
            }
        }
    }
}

impl Drawing {
    /// What is drawn of a scheme whose facts are known: the same without a family.
    ///
    /// # Errors
    /// When there is no such scheme.
    pub fn of_facts(scheme: &str, facts: &SchemeFacts) -> Result<Drawing, SchemeError> {
        let (mut curve, mut lattice, mut rings) = (None, None, Vec::new());
        match facts {
            SchemeFacts::Rational(facts) => {
                let mask = Mask::try_from(parse_scheme(scheme)?)
                    .map_err(|_| SchemeError::TensorProduct { scheme: scheme.to_owned() })?;
                let shape = CurveShape::of(&mask, facts.smoothness.as_ref().ok());
                curve = Some(CurveDrawing::Rational(shape));
            }
            SchemeFacts::Algebraic(facts) => {
                let mask = parse_algebraic(scheme)?;
                let shape = CurveShape::of(&mask, facts.smoothness.as_ref().ok());
                curve = Some(CurveDrawing::Algebraic(shape));
            }
            SchemeFacts::Lattice(facts) => {
                lattice = Some(lattice_shape(&facts.mask, facts.smoothness.converges));
            }
            SchemeFacts::Surface(all) => {
                let drawn = drawn(&all.iter().map(|(n, _)| *n).collect::<Vec<usize>>());
                rings = all.iter().filter(|(n, _)| drawn.contains(n)).cloned().collect();
            }
        }
        Ok(Drawing { curve, lattice, family: None, rings })
    }
}

/// What is drawn of a mask on Z^d; `converges` says whether its scheme does, where that is known.
fn lattice_shape(mask: &LatticeMask, converges: Option<bool>) -> Result<LatticeShape, String> {
    let found =
        converges.or_else(|| LatticeSmoothness::convergence(mask, &Stop::default()).converges);
    match found {
        Some(true) => LatticeShape::of(mask),
        Some(false) => Err("the scheme diverges for some data".to_owned()),
        None => Err("it is open whether the scheme converges".to_owned()),
    }
}

/// Which of these valences are drawn: [`VALENCES`], or else the first.
fn drawn(valences: &[usize]) -> Vec<usize> {
    let found: Vec<usize> = VALENCES.into_iter().filter(|n| valences.contains(n)).collect();
    if found.is_empty() { valences.iter().take(1).copied().collect() } else { found }
}

impl<F: Coefficient> CurveShape<F> {
    /// What is drawn of a mask; `known` is its smoothness, where it is known.
    #[must_use]
    pub fn of(mask: &Mask<F>, known: Option<&Smoothness<F>>) -> CurveShape<F> {
        let smoothness = match known {
            Some(known) => Ok(known.clone()),
            None => Smoothness::of(mask).map_err(|error| error.to_string()),
        };
        let (mut functions, mut end) = (Vec::new(), None);
        match &smoothness {
            Err(error) => end = Some(error.clone()),
            Ok(smoothness) => {
                for m in 0..=MAX_DERIVATIVES {
                    match drawn_values(smoothness, m) {
                        Ok(values) => functions.push(values),
                        Err(error) => {
                            end = Some(error.to_string());
                            break;
                        }
                    }
                }
            }
        }
        let sample = SAMPLE.map(|point| point.map(|x| F::from_rational(&Rational::from(x))));
        let rational = mask.rules().rows().iter().flatten().all(|c| c.generator().is_none());
        let most = if rational { MAX_POINTS } else { MAX_FIELD_POINTS };
        let mut levels = vec![sample.to_vec()];
        while levels.len() <= LEVELS && last(&levels).len() * mask.arity() <= most {
            levels.push(refined(mask, last(&levels)));
        }
        let limit = smoothness.ok().and_then(|smoothness| {
            let at_integers = BasicValues::of(&smoothness, 0, 0).ok()?;
            let mut points = last(&levels).clone();
            // A level that is drawn has enough points, or the next one does.
            while points.len() < MIN_LIMIT && points.len() * mask.arity() <= most {
                points = refined(mask, &points);
            }
            let enough = levels.iter().find(|level| level.len() >= MIN_LIMIT);
            Some(limit_points(&at_integers, enough.unwrap_or(&points)))
        });
        CurveShape { functions, end, levels, limit }
    }
}

fn last<T>(levels: &[Vec<T>]) -> &Vec<T> {
    levels.last().expect("the control polygon")
}

/// Values that are as many as a picture needs, if the cap allows.
fn drawn_values<F: Coefficient>(
    smoothness: &Smoothness<F>,
    m: usize,
) -> Result<BasicValues<F>, BasicError> {
    // The equations at whole numbers are solved for each call: the level is chosen before.
    let enough = |level: &u32| {
        BasicValues::count(smoothness, *level).is_none_or(|count| count >= MIN_VALUES)
    };
    let mut level = (0..64).find(enough).unwrap_or(0);
    loop {
        match BasicValues::of(smoothness, m, level) {
            Err(BasicError::TooMany(_)) if level > 0 => level -= 1,
            found => return found,
        }
    }
}

fn refined<F: Coefficient>(mask: &Mask<F>, points: &[[F; 2]]) -> Vec<[F; 2]> {
    let [x, y] = [0, 1].map(|axis| {
        let line: Vec<F> = points.iter().map(|point| point[axis].clone()).collect();
        mask.rules().refine_closed(&line)
    });
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

/// Where the points of a closed polygon go: P^∞(j) = Σ_i φ(i) x_{j−i}.
fn limit_points<F: Coefficient>(at_integers: &BasicValues<F>, points: &[[F; 2]]) -> Vec<[F; 2]> {
    let count = points.len();
    let at = |j: i64| {
        let count = i64::try_from(count).expect("it fits in memory");
        &points[usize::try_from(j.rem_euclid(count)).expect("0 ≤ it")]
    };
    let limit = |j: i64| {
        [0, 1].map(|axis| {
            let terms = (at_integers.first..).zip(&at_integers.values);
            terms.fold(F::zero(), |sum, (i, value)| sum.plus(&value.times(&at(j - i)[axis])))
        })
    };
    (0..).take(count).map(limit).collect()
}
