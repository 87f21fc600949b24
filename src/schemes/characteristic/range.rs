//! The values of a parameter in the rules at one valence for which the surface is C¹.

use super::ball::Ball;
use super::bernstein::Form;
use super::family::Family;
use super::positive::{affine, positive};
use super::ring::{jacobian, outer_curve, ring_pieces};
use super::rules::{Reason, difference};
use super::verdict::Verdict;
use super::vertex::Vertex;
use crate::exact::{
    Adjugate, Enclosure, Interval, IntervalSet, Polynomial, Rational, RealCyclotomic,
    RealExpression, Scalar as _,
};
use crate::scheme::LocalRules;
use crate::spectrum::{SpectrumError, surroundings};
use std::ops::Bound;

/// The most bisections of a piece of the ring.
const MAX_BISECTIONS: usize = 3;

/// The parts into which the values of an eigenvalue of block 0 are divided.
const PARTS: i64 = 256;

/// Where surfaces are C¹, and where not.
#[derive(Clone, Debug)]
pub struct VertexRange {
    /// The regular part.
    pub family: Family,
    /// The valence.
    pub order: usize,
    /// The values for which the surface of generic data is proved C¹.
    pub inside: IntervalSet,
    /// Values for which it is refuted.
    pub outside: IntervalSet,
}

/// Why there is no such range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VertexRangeError {
    /// The spectrum of the rules of the catalogue.
    #[error(transparent)]
    Spectrum(#[from] SpectrumError),
    /// The rules have no known regular part, or more than the vertex or face has weights of its own.
    #[error(
        "the rules have no regular part that is known here, or other weights than those of the vertex or the face are their own"
    )]
    Rules(Reason),
    /// A weight is not a polynomial of degree 1 in the parameter.
    #[error("a weight is not a polynomial of degree 1 in `{0}`")]
    Degree(String),
    /// An end of the range is a number of a field that is too large.
    #[error("an end of the range is beyond reach")]
    Field,
}

use VertexRangeError::Field;

/// c_0 + c_1·w.
type Affine = [RealExpression; 2];

/// The range of a parameter in the weights of the vertex, or of a face. The weights have degree 1 in it.
///
/// # Errors
/// See [`VertexRangeError`].
///
/// # Panics
/// Never.
///
/// ```
/// use subcert::characteristic::vertex_range;
/// use subcert::scheme::parse_rules_in_parameter;
///
/// let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/loop-beta.toml");
/// let ring = parse_rules_in_parameter(file, "beta", Some(6))?;
/// let range = vertex_range(&ring, "beta")?;
/// // 5/8 − 6β is between −1/2 and 1/2.
/// assert_eq!(range.inside.describe("beta"), "1/48 < beta < 3/16");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn vertex_range(
    ring: &LocalRules<Polynomial>,
    variable: &str,
) -> Result<VertexRange, VertexRangeError> {
    let names: Vec<&str> = ring.orbits().iter().map(|orbit| orbit.name.as_str()).collect();
    let family = Family::of_orbits(&names).ok_or(VertexRangeError::Rules(Reason::RegularPart))?;
    let order = ring.orbits().last().map_or(0, |orbit| orbit.count);
    let model = surroundings(family.scheme(), Some(order))?.ring;
    let constant = model.map(|weight| Polynomial::constant(weight.clone()));
    if constant.point_count() != ring.point_count() {
        return Err(VertexRangeError::Rules(Reason::RegularPart));
    }
    if let Some(reason) = difference(ring, &constant) {
        return Err(VertexRangeError::Rules(reason));
    }
    let [inside, outside] = match family {
        Family::Biquadratic => of_face(ring, variable, order)?,
        _ => of_vertex(ring, variable, family, &model)?,
    };
    Ok(VertexRange { family, order, inside, outside })
}

/// The coefficients of a polynomial of degree 1 at most.
fn linear(p: &Polynomial, variable: &str) -> Result<[RealCyclotomic; 2], VertexRangeError> {
    let found = p.coefficients_in(variable).filter(|found| found.len() <= 2);
    let mut found = found.ok_or_else(|| VertexRangeError::Degree(variable.to_owned()))?;
    found.resize(2, RealCyclotomic::from(0));
    Ok([found[0].clone(), found[1].clone()])
}

/// Where all of these are positive.
fn all_positive(conditions: &[Affine]) -> Result<IntervalSet, VertexRangeError> {
    let mut set = IntervalSet::everything();
    for [constant, slope] in conditions {
        set = set.intersection(&affine(constant, slope).ok_or(Field)?);
    }
    Ok(set)
}

/// Σ f_i·p_i of polynomials of degree 1.
fn combination(terms: &[(&RealExpression, &[RealCyclotomic; 2])]) -> Affine {
    [0, 1].map(|i| {
        terms.iter().fold(RealExpression::zero(), |sum, (factor, p)| {
            sum.plus(&factor.times(&RealExpression::from(p[i].clone())))
        })
    })
}

/// At a vertex, λ and the characteristic map do not depend on the weights of the vertex: the roots of block 0 but 1 have to
/// be below λ.
fn of_vertex(
    ring: &LocalRules<Polynomial>,
    variable: &str,
    family: Family,
    model: &LocalRules,
) -> Result<[IntervalSet; 2], VertexRangeError> {
    let known = Vertex::of_ring(model.clone())?;
    let (Verdict::Proved { .. }, Some(second)) = (&known.verdict, &known.second) else {
        return Err(VertexRangeError::Rules(Reason::Sign));
    };
    let value = &second.value;
    let mut first = vec![0];
    for orbit in ring.orbits() {
        first.push(first[first.len() - 1] + orbit.count);
    }
    let sum = |a: usize, b: usize| {
        let terms = (first[b]..first[b + 1]).map(|point| ring.weights().entry(first[a], point));
        terms.fold(Polynomial::zero(), |sum, weight| sum.plus(weight))
    };
    let orbits = 0..ring.orbits().len();
    let matrix: Vec<Vec<Polynomial>> =
        orbits.clone().map(|a| orbits.clone().map(|b| sum(a, b)).collect()).collect();
    // Divided by x − 1; the leading coefficient is 1.
    let whole = Adjugate::of(&matrix).characteristic;
    let mut carried = Polynomial::zero();
    let mut quotient = Vec::new();
    for c in whole[1..].iter().rev() {
        carried = carried.plus(c);
        quotient.push(linear(&carried, variable)?);
    }
    quotient.reverse();
    let one = RealExpression::from(Rational::one());
    let minus = |x: &RealExpression| RealExpression::zero().minus(x);
    let at = |x: &RealExpression| {
        let (mut power, mut terms) = (one.clone(), Vec::new());
        for p in &quotient {
            terms.push((power.clone(), p));
            power = power.times(x);
        }
        combination(&terms.iter().map(|(power, p)| (power, *p)).collect::<Vec<_>>())
    };
    let lowered = |[c, s]: Affine| [minus(&c), minus(&s)];
    let (above, below) = (at(value), at(&minus(value)));
    let mut conditions = vec![above.clone()];
    let (upper, lower);
    if family == Family::BoxSpline {
        // The root r of x − r: λ − r > 0 and r + λ > 0.
        conditions.push(lowered(below.clone()));
        upper = vec![lowered(above), at(&one)];
        // −1 < r < −λ.
        lower = vec![below, lowered(at(&minus(&one)))];
    } else {
        // Jury's conditions for x² − ax + b and the radius λ.
        let [constant, middle] = [&quotient[0], &quotient[1]];
        let square = value.times(value);
        conditions.push(below.clone());
        let less = combination(&[(&minus(&one), constant)]);
        conditions.push([square.plus(&less[0]), less[1].clone()]);
        // A root from λ to 1, and the other one nearer to 0: a > 0.
        let a = combination(&[(&minus(&one), middle)]);
        upper = vec![lowered(above), at(&one), a.clone()];
        lower = vec![lowered(below), at(&minus(&one)), lowered(a)];
    }
    let inside = all_positive(&conditions)?;
    let ends = (RealExpression::from(Rational::from(-1)), minus(value));
    let mut outside = IntervalSet::default();
    if one_sign(family, model, value, &one) {
        outside = outside.union(&all_positive(&upper)?);
    }
    if one_sign(family, model, &ends.0, &ends.1) {
        outside = outside.union(&all_positive(&lower)?);
    }
    // A root that is not below 1 in absolute value: the surface is not even continuous.
    let mut shrinking = vec![at(&one)];
    if family == Family::BoxSpline {
        shrinking.push(lowered(at(&minus(&one))));
    } else {
        shrinking.push(at(&minus(&one)));
        let less = combination(&[(&minus(&one), &quotient[0])]);
        shrinking.push([one.plus(&less[0]), less[1].clone()]);
    }
    outside = outside.union(&IntervalSet::everything().without(&all_positive(&shrinking)?));
    Ok([inside, outside])
}

/// Whether the eigenfunction of block 0 has one sign on the outer curve for all eigenvalues between two numbers.
fn one_sign(
    family: Family,
    model: &LocalRules,
    low: &RealExpression,
    high: &RealExpression,
) -> bool {
    let (low, high) = (Ball::of(low).lower(), Ball::of(high).upper());
    let step = (&high - &low) / Rational::from(PARTS);
    let inner = super::inner::Inner::new(
        family,
        model,
        model.orbits().last().map_or(3, |orbit| orbit.count),
    );
    let one = Ball::from_rational(&Rational::one());
    (0..PARTS).all(|i| {
        let from = &low + &(&step * &Rational::from(i));
        let value = Ball::within(&Enclosure::new(from.clone(), from + &step));
        let net = family.net(&one, &value, &inner.still_by_edges(&value));
        let curve = outer_curve(&net, &ring_pieces(&net, &value));
        [1, -1].iter().any(|side| curve.iter().all(|x| x.sign() == Some(*side)))
    })
}

/// On a face, the eigenvalue λ of block 1 has to be above those of the other blocks and above 1/4, and below 1; and the Jacobian,
/// whose coefficients are polynomials in λ, has to be positive.
fn of_face(
    ring: &LocalRules<Polynomial>,
    variable: &str,
    n: usize,
) -> Result<[IntervalSet; 2], VertexRangeError> {
    let cosine = |j: usize| {
        RealCyclotomic::cosine(&Rational::new(j % n, n))
            .expect("no more points than a ring may have")
    };
    let eigenvalue = |k: usize| {
        (0..n).fold(Polynomial::zero(), |sum, d| {
            sum.plus(&Polynomial::constant(cosine(k * d)).times(ring.weights().entry(0, d)))
        })
    };
    let value = eigenvalue(1);
    let [constant, slope] = linear(&value, variable)?;
    let expression = |p: [RealCyclotomic; 2]| p.map(RealExpression::from);
    let less = |p: i64, q: i64, sign: i64| {
        let sign = RealCyclotomic::from(sign);
        let end = RealCyclotomic::from(Rational::new(p, q));
        expression([constant.minus(&end).times(&sign), slope.times(&sign)])
    };
    let mut conditions = vec![less(1, 4, 1), less(1, 1, -1)];
    for k in 2..=n / 2 {
        let [c, s] = linear(&eigenvalue(k), variable)?;
        conditions.push(expression([constant.minus(&c), slope.minus(&s)]));
        conditions.push(expression([constant.plus(&c), slope.plus(&s)]));
    }
    let ordered = all_positive(&conditions)?;
    let mut shrinking = Vec::new();
    for k in 1..=n / 2 {
        let [c, s] = linear(&eigenvalue(k), variable)?;
        let (c, s) = (RealExpression::from(c), RealExpression::from(s));
        let one = RealExpression::from(Rational::one());
        shrinking.push([one.minus(&c), RealExpression::zero().minus(&s)]);
        shrinking.push([one.plus(&c), s]);
    }
    let diverging = IntervalSet::everything().without(&all_positive(&shrinking)?);
    if ordered.is_empty() {
        return Ok([ordered, diverging]);
    }
    let net = Family::Biquadratic.eigenvector(&Polynomial::constant(cosine(1)), &value);
    let pieces = ring_pieces(&net, &value);
    // Without a hull, λ does not depend on the parameter.
    let (low, high) = ordered.hull().unwrap_or_else(|| (Rational::zero(), Rational::one()));
    let set = |p: &Polynomial| -> Result<IntervalSet, VertexRangeError> {
        positive(&p.coefficients_in(variable).ok_or(Field)?, &low, &high).ok_or(Field)
    };
    let mut inside = ordered.clone();
    for form in &outer_curve(&net, &pieces) {
        inside = inside.intersection(&set(form)?);
    }
    let (mut above, mut below) = (IntervalSet::default(), IntervalSet::default());
    for piece in &pieces {
        let signs = signs(&jacobian(piece), &ordered, &set, MAX_BISECTIONS)?;
        inside = inside.intersection(&signs[0]);
        above = above.union(&signs[1]);
        below = below.union(&signs[2]);
    }
    let outside = ordered.intersection(&above).intersection(&below).union(&diverging);
    Ok([inside, outside])
}

/// The values for which J is positive on a part, for which it is positive at a corner of it or of a part of it, and negative.
fn signs(
    form: &Form<Polynomial>,
    within: &IntervalSet,
    set: &impl Fn(&Polynomial) -> Result<IntervalSet, VertexRangeError>,
    left: usize,
) -> Result<[IntervalSet; 3], VertexRangeError> {
    let (mut above, mut below) = (IntervalSet::default(), IntervalSet::default());
    for corner in form.corners() {
        above = above.union(&set(corner)?.intersection(within));
        below = below.union(&set(&Polynomial::zero().minus(corner))?.intersection(within));
    }
    let mut inside = within.clone();
    for coefficient in form.coefficients() {
        if inside.is_empty() {
            break;
        }
        inside = inside.intersection(&set(coefficient)?);
    }
    let open = within.without(&inside).without(&below);
    if left > 0 && has_length(&open) {
        let mut both = open.clone();
        for half in form.halves() {
            let found = signs(&half, &open, set, left - 1)?;
            both = both.intersection(&found[0]);
            above = above.union(&found[1]);
            below = below.union(&found[2]);
        }
        inside = inside.union(&both);
    }
    Ok([inside, above, below])
}

/// Whether a set is more than single points.
fn has_length(set: &IntervalSet) -> bool {
    let point = |interval: &Interval| match (&interval.low, &interval.high) {
        (Bound::Included(low), Bound::Included(high)) => low == high,
        _ => false,
    };
    !set.intervals().iter().all(point)
}
