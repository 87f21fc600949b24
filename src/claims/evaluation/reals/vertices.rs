//! Eigenvalues and weights around a vertex or on a face.

use super::exponents::KnownReals;
use crate::cap::Cap;
use crate::evaluation::arguments::{index, within};
use crate::evaluation::functions::{QUANTITIES, name_of};
use crate::evaluation::options::Options;
use crate::exact::{Rational, Real as _, RealCyclotomic, RealExpression, Scalar as _};
use crate::formula::{Call, CallError, RealValue, Value};
use crate::scheme::{Instance, LocalRules, SchemeError};
use crate::spectrum::{CurvaturePart, MAX_COMPONENT, Spectrum, SpectrumError};
use std::cmp::Ordering;

/// The valences that are asked for.
const VALENCES: std::ops::RangeInclusive<i64> = 3..=100;

/// The rules of a scheme at a valence.
type AtValence<'a> =
    dyn Fn(&[Instance<RealCyclotomic>], usize) -> Result<LocalRules, SchemeError> + 'a;

/// The value of such a function of a ring, whose valence is the first argument; `rules` gives those of a valence.
pub(crate) fn of_ring<V: Value>(
    known: &KnownReals,
    ring: &[Instance<V>],
    rules: &AtValence<'_>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
) -> Result<RealValue, CallError> {
    let [valence, rest @ ..] = call.arguments else { return Err(usage(call.function)) };
    let valence = within("a valence", valence, VALENCES)?;
    let ring = numbers(ring)?;
    let rules = rules(&ring, valence).map_err(|error| match error.cap() {
        Some(cap) => CallError::BeyondCap(cap),
        None => CallError::Misuse(error.to_string()),
    })?;
    let spectrum = known.spectrum((ring, valence), || spectrum(&rules))?;
    match (call.function, rest) {
        ("eigenvalue", [block, number]) => {
            let block = index("the number of a block", block)?;
            let block =
                usize::try_from(block).ok().filter(|block| *block < valence).ok_or_else(|| {
                    let last = valence - 1;
                    CallError::Misuse(format!(
                        "at valence {valence} the blocks are 0 to {last}, and not {block}"
                    ))
                })?;
            let number = within("the number of an eigenvalue", number, 1..=1_000)?;
            eigenvalue(&spectrum, block, number)
        }
        ("subdominant", []) => subdominant(&spectrum).map(|value| value.clone().into()),
        ("curvature", []) => curvature(&spectrum, options.part()?),
        ("limit_weight", []) => {
            let (first, _) = orbit(&rules, options.take("orbit"))?;
            let weights = spectrum.limit.as_ref().ok_or_else(|| {
                CallError::Undefined("the points of this ring have no limit, or not one".to_owned())
            })?;
            Ok(RealExpression::from(weights[first].clone()).into())
        }
        ("tangent_weight", [point]) => {
            let second = options.is_second_tangent()?;
            let (first, count) = orbit(&rules, options.take("orbit"))?;
            let point = within("the number of a point", point, 0..=100)?;
            subdominant(&spectrum)?;
            let tangents = spectrum.tangents.as_ref().ok_or_else(|| {
                CallError::Undefined("the eigenvalue of the tangents is not simple".to_owned())
            })?;
            Ok(tangents[usize::from(second)][first + point % count].clone().into())
        }
        _ => Err(usage(call.function)),
    }
}

fn usage(function: &str) -> CallError {
    let usage = QUANTITIES.iter().map(|(usage, _)| *usage);
    let mut usage = usage.filter(|usage| name_of(usage) == function);
    CallError::Misuse(format!("the form is {}", usage.next().unwrap_or(function)))
}

/// The scheme with numbers as parameters.
fn numbers<V: Value>(ring: &[Instance<V>]) -> Result<Vec<Instance<RealCyclotomic>>, CallError> {
    let number = |(name, value): (&String, &V)| match value.number() {
        Some(number) => Ok((name.clone(), number)),
        None => Err(CallError::Misuse(format!("the parameter `{name}` is {value}, and no number"))),
    };
    let instance = |one: &Instance<V>| {
        let parameters = one.parameters.iter().map(number).collect::<Result<_, CallError>>()?;
        Ok(Instance { name: one.name.clone(), parameters })
    };
    ring.iter().map(instance).collect()
}

/// The spectrum of a ring.
fn spectrum(rules: &LocalRules) -> Result<Spectrum, CallError> {
    Spectrum::known(rules, None).map_err(|error| match error {
        SpectrumError::TooLarge { .. } => CallError::BeyondCap(Cap::new(
            "the number of orbits that depend on each other",
            MAX_COMPONENT as u64,
        )),
        SpectrumError::Complex { .. } | SpectrumError::Multiple { .. } => complex(),
        other => CallError::Misuse(other.to_string()),
    })
}

fn complex() -> CallError {
    CallError::BeyondCap(Cap::new("the degree of a polynomial whose complex roots are computed", 3))
}

/// The greatest real eigenvalue of a block, the second one, and so on.
fn eigenvalue(spectrum: &Spectrum, block: usize, number: usize) -> Result<RealValue, CallError> {
    let real = spectrum.eigenvalues.iter().filter(|one| one.imaginary.is_none());
    let mut own: Vec<&RealExpression> = real
        .flat_map(|one| one.blocks.iter().filter(|k| **k == block).map(|_| &one.real))
        .collect();
    own.sort_by(|a, b| b.cmp(a));
    let found = own.get(number - 1);
    found.map(|value| RealValue::from((*value).clone())).ok_or_else(|| {
        CallError::Undefined(format!(
            "block {block} at valence {} has {} real eigenvalue(s), and no number {number}",
            spectrum.order,
            own.len()
        ))
    })
}

fn subdominant(spectrum: &Spectrum) -> Result<&RealExpression, CallError> {
    spectrum.conditions.subdominant.as_ref().ok_or_else(|| {
        CallError::Undefined(format!(
            "at valence {} there is no subdominant eigenvalue: a positive one of block 1, simple there, that only 1 exceeds in \
             absolute value",
            spectrum.order
        ))
    })
}

/// The greatest absolute value μ of other eigenvalues, of all blocks or of some, over λ².
fn curvature(spectrum: &Spectrum, part: CurvaturePart) -> Result<RealValue, CallError> {
    let lambda = subdominant(spectrum)?;
    let square = lambda.times(lambda);
    let one = RealExpression::from(Rational::one());
    let block = match part {
        CurvaturePart::Both => None,
        CurvaturePart::Elliptic => Some(0),
        CurvaturePart::Hyperbolic => Some(2),
    };
    let belongs = |blocks: &[usize]| block.is_none_or(|block| blocks.contains(&block));
    let others = spectrum.eigenvalues.iter().filter(|other| {
        belongs(&other.blocks)
            && (other.imaginary.is_some() || other.real != one && other.real != *lambda)
    });
    let most = others.map(|other| &other.modulus).max();
    let hidden = spectrum.complex.iter().filter(|hidden| belongs(&hidden.blocks));
    for hidden in hidden {
        let bound = RealExpression::from(hidden.greatest[1].clone());
        if most.is_none_or(|most| *most < bound) {
            return Err(complex());
        }
    }
    let Some(most) = most else {
        return Err(CallError::Undefined(format!(
            "at valence {} there are no other eigenvalues in these blocks",
            spectrum.order
        )));
    };
    Ok(match most.cmp(&square) {
        Ordering::Equal => one.into(),
        _ => most.over(&square).into(),
    })
}

/// The first point of an orbit, and how many it has; of the first orbit without a name.
fn orbit(rules: &LocalRules, asked: Option<String>) -> Result<(usize, usize), CallError> {
    let mut first = 0;
    for known in rules.orbits() {
        if asked.as_ref().is_none_or(|name| *name == known.name) {
            return Ok((first, known.count));
        }
        first += known.count;
    }
    let names: Vec<&str> = rules.orbits().iter().map(|orbit| &orbit.name[..]).collect();
    let asked = asked.unwrap_or_default();
    let message = format!("the ring has no orbit `{asked}`; its orbits are {}", names.join(", "));
    Err(CallError::Misuse(message))
}
