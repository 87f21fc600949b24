//! Smoothness, spectra, joint spectral radii, and where limits are smooth.

use crate::algebraic::Algebraic;
use crate::error::{of_scheme, plain, with_remedy};
use crate::number::{Fraction, fraction, rationals};
use crate::real::{Real, of_cyclotomic, of_expression};
use crate::run::aside;
use crate::scheme::{Ends, Native, ends};
use pyo3::prelude::*;
use subcert::bound::polynomial_rules;
use subcert::characteristic::Vertex;
use subcert::exact::{Enclosed, Interval, RealCyclotomic};
use subcert::joint::{MatrixSet, joint_radius};
use subcert::report::{verdict_name, verdict_reason};
use subcert::scheme::{names_ring, notes, open_parameters, parse_parametric};
use subcert::smoothness::{Hoelder, Smoothness, smooth_range as computed};
use subcert::spectrum::{
    ComplexEigenvalues, Curvature, Sector, Spectrum, SpectrumError, surroundings,
};

/// The exponent as a formula, two numbers around it, and whether it is attained.
pub(crate) type Exponent = (Option<String>, Fraction, Fraction, Option<bool>);

/// Arity, order of the sum rules, degree of reproduction, natural shift, independence of the shifts, the proven order,
/// the least order that fails, the exponent.
type Known = (
    usize,
    usize,
    usize,
    Option<Fraction>,
    Option<bool>,
    Option<usize>,
    Option<usize>,
    Option<Exponent>,
);

/// Value, imaginary part, multiplicity, blocks.
type Eigenvalue = (Real, Option<Real>, usize, Vec<usize>);

/// The weight of each point.
type Stencil = Vec<(String, Real)>;

/// The blocks of complex eigenvalues that are not computed, and two numbers around the greatest of their absolute values.
type Complex = (Vec<usize>, Fraction, Fraction);

/// Order, eigenvalues, complex ones, whether 1 is simple, λ, μ, the curvature, the limit, the tangents, notes.
type Spectral = (
    usize,
    Vec<Eigenvalue>,
    Vec<Complex>,
    bool,
    Option<Real>,
    Option<Real>,
    Option<&'static str>,
    Option<Stencil>,
    Option<Vec<Stencil>>,
    Vec<String>,
);

/// λ, its comparison with 1/2, whether block 2 has an eigenvalue above 1/2, the tangent.
type Across = (Real, &'static str, bool, Option<Stencil>);

/// Eigenvalues, the limit, the tangents along sharp edges, and what goes across.
type Sectoral = (Vec<Eigenvalue>, Stencil, Vec<Stencil>, Option<Across>);

/// The version of the program.
#[pyfunction]
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// The error, with the argument that gives a valence, if that is what is missing.
fn of_rules(error: &SpectrumError) -> PyErr {
    match error {
        SpectrumError::Scheme(missing) if missing.asks_for_valence() => {
            with_remedy("a valence is missing", "give it as in spectrum(valence=5)")
        }
        SpectrumError::Scheme(error) => of_scheme(error),
        other => plain(other),
    }
}

/// Whether a text names rules around a vertex or on a face.
#[pyfunction]
pub fn is_ring(text: &str) -> bool {
    names_ring(text).unwrap_or(false)
}

/// The parameters that a text leaves open.
#[pyfunction]
pub fn open_names(text: &str) -> PyResult<Vec<String>> {
    open_parameters(text).map_err(plain)
}

/// How smooth the limits of a scheme for curves are.
#[pyfunction]
pub fn smoothness(py: Python<'_>, scheme: &Native) -> PyResult<Known> {
    let mask = scheme.mask()?;
    aside(py, move || {
        let found = Smoothness::of(&mask).map_err(plain)?;
        let shift = found.shift.keeps_lines.then(|| fraction(&found.shift.shift));
        let converges = found.continuity.is_some();
        Ok((
            mask.arity(),
            found.sum_rules,
            found.reproduction,
            shift,
            converges.then_some(found.reduced.is_none()),
            found.continuity,
            found.continuity_fails,
            found.hoelder.as_ref().map(exponent),
        ))
    })
}

pub(crate) fn exponent(hoelder: &Hoelder) -> Exponent {
    let (low, high) = match &hoelder.formula {
        Some(formula) => {
            let enclosure = formula.enclosure(1);
            (fraction(enclosure.lower()), fraction(enclosure.upper()))
        }
        None => (fraction(&hoelder.lower), fraction(&hoelder.upper)),
    };
    (hoelder.formula.as_ref().map(ToString::to_string), low, high, hoelder.attained)
}

/// Whether surfaces are C¹ at a vertex or on a face: the valence, the verdict, and why.
#[pyfunction]
#[pyo3(signature = (scheme, valence = None))]
pub fn vertex_smoothness(
    py: Python<'_>,
    scheme: String,
    valence: Option<usize>,
) -> PyResult<(usize, &'static str, String)> {
    aside(py, move || {
        let vertex = Vertex::of(&scheme, valence).map_err(|error| of_rules(&error))?;
        let verdict = &vertex.verdict;
        Ok((vertex.spectrum.order, verdict_name(verdict), verdict_reason(verdict)))
    })
}

/// The eigenvalues and stencils of rules around a vertex or on a face.
#[pyfunction]
#[pyo3(signature = (scheme, valence = None))]
pub fn spectrum(py: Python<'_>, scheme: String, valence: Option<usize>) -> PyResult<Spectral> {
    aside(py, move || {
        let rings = surroundings(&scheme, valence).map_err(|error| of_rules(&error))?;
        let Spectrum { order, eigenvalues, complex, conditions, limit, tangents } =
            rings.known_spectrum().map_err(plain)?;
        let complex = complex.into_iter().map(|ComplexEigenvalues { blocks, greatest }| {
            (blocks, fraction(&greatest[0]), fraction(&greatest[1]))
        });
        let names = |values: Vec<Real>| -> Stencil {
            let named = values.into_iter().enumerate();
            named.map(|(point, value)| (rings.ring.name(point), value)).collect()
        };
        Ok((
            order,
            eigenvalues.iter().map(of_eigenvalue).collect(),
            complex.collect(),
            conditions.simple_one,
            conditions.subdominant.as_ref().map(of_expression),
            conditions.next.as_ref().map(of_expression),
            conditions.curvature.map(Curvature::name),
            limit.map(|weights| names(weights.iter().map(of_cyclotomic).collect())),
            tangents.map(|both| {
                both.iter().map(|one| names(one.iter().map(of_expression).collect())).collect()
            }),
            notes(&scheme),
        ))
    })
}

fn of_eigenvalue(one: &subcert::spectrum::Eigenvalue) -> Eigenvalue {
    let imaginary = one.imaginary.as_ref().map(of_expression);
    (of_expression(&one.real), imaginary, one.multiplicity, one.blocks.clone())
}

/// The eigenvalues and stencils between two sharp edges at a vertex.
#[pyfunction]
pub fn sector(py: Python<'_>, scheme: String, faces: usize, corner: bool) -> PyResult<Sectoral> {
    aside(py, move || {
        let found = Sector::of(&scheme, faces, corner).map_err(|error| of_rules(&error))?;
        let named = |values: Vec<Real>| -> Stencil {
            let named = values.into_iter().enumerate();
            named.map(|(point, value)| (found.name(point), value)).collect()
        };
        let exact = |weights: &[RealCyclotomic]| named(weights.iter().map(of_cyclotomic).collect());
        let across = found.across.as_ref().map(|across| {
            let stencil = across.stencil.as_ref();
            let stencil = stencil.map(|one| named(one.iter().map(of_expression).collect()));
            let value = of_expression(&across.eigenvalue);
            (value, across.comparison(), across.second_above, stencil)
        });
        Ok((
            found.eigenvalues.iter().map(of_eigenvalue).collect(),
            exact(&found.limit),
            found.along.iter().map(|one| exact(one)).collect(),
            across,
        ))
    })
}

/// The factors of a product, its root and degree, whether the radius is that, and two numbers around the radius.
type Radius = (Vec<usize>, Algebraic, usize, bool, (Fraction, Fraction));

/// The joint spectral radius of matrices.
#[pyfunction]
pub fn jsr(py: Python<'_>, matrices: Vec<Vec<Vec<Bound<'_, PyAny>>>>) -> PyResult<Radius> {
    let row = |row: &Vec<Bound<'_, PyAny>>| rationals(row);
    let matrix = |matrix: &Vec<Vec<_>>| matrix.iter().map(row).collect::<PyResult<Vec<_>>>();
    let matrices = matrices.iter().map(matrix).collect::<PyResult<Vec<_>>>()?;
    let set = MatrixSet::new(matrices).map_err(plain)?;
    aside(py, move || {
        let radius = joint_radius(&set);
        let around = (fraction(radius.root_enclosure().lower()), fraction(&radius.upper()));
        let root = Algebraic(radius.root.clone());
        Ok((radius.product.clone(), root, radius.degree, radius.exact, around))
    })
}

/// An interval, and whether its ends belong to it.
type Placed = (Ends, bool, bool);

/// Where in a parameter the limits are C^m, where not, whether finitely many values are exceptions, and the length
/// of what is in neither.
type SmoothSets = (Vec<Placed>, Vec<Placed>, bool, Option<Fraction>);

/// Where in a parameter all limits of a scheme for curves are C^m.
#[pyfunction]
pub fn smooth_range(
    py: Python<'_>,
    text: &str,
    parameter: &str,
    m: usize,
    levels: u32,
) -> PyResult<SmoothSets> {
    let mask = parse_parametric(text, parameter).map_err(plain)?;
    let rules = polynomial_rules(mask.rules(), parameter).map_err(plain)?;
    aside(py, move || {
        let found = computed(&rules, m, levels).map_err(plain)?;
        let of = |set: &[Interval]| set.iter().map(placed).collect();
        Ok((
            of(found.inside.intervals()),
            of(found.outside.intervals()),
            found.but_finitely_many,
            found.gap.as_ref().map(fraction),
        ))
    })
}

fn placed(interval: &Interval) -> Placed {
    use std::ops::Bound::Included;
    let [low, high] = [&interval.low, &interval.high].map(|end| matches!(end, Included(_)));
    (ends(interval), low, high)
}
