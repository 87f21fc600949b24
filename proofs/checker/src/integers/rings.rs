//! The functions of rings at all valences from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::evaluate::Evaluator;
use super::function::Function;
use super::polynomial::{Polynomial, T};
use super::ring::Ring;
use super::spectrum::{Spectrum, eigenvalue};
use super::weights::{limit, tangent};
use crate::functions::call::Call;
use crate::text::Stop;

/// The functions, with the numbers of their arguments.
const NAMES: [(&str, usize); 5] = [
    ("curvature", 1),
    ("eigenvalue", 3),
    ("limit_weight", 1),
    ("subdominant", 1),
    ("tangent_weight", 2),
];

/// The parts of `curvature`.
const PARTS: [&str; 3] = ["both", "elliptic", "hyperbolic"];

/// The greatest number of a point of which a weight is asked.
const MAX_POINT: i64 = 100;

const NO_RING: Stop = Stop::Integers("a function of the valence of no ring");
const ARGUMENT: Stop =
    Stop::Integers("an argument that is no integer, or too great for some valence");

/// The value of such a function; `None` if the call is none whose first argument is the integer of the claim.
pub fn of(
    evaluator: &Evaluator<'_>,
    call: &mut Call<'_>,
    arguments: &[Function],
) -> Result<Option<Function>, Stop> {
    let functions = evaluator.functions;
    let valence = arguments.first().and_then(Function::polynomial);
    let is_known = NAMES.contains(&(call.function, arguments.len()));
    if !is_known || valence != Some(Polynomial::variable(T)) {
        return Ok(None);
    }
    let own = evaluator.claim.and_then(|claim| claim.own);
    let reference = call.reference()?.or_else(|| own.map(str::to_owned)).ok_or(NO_RING)?;
    if !evaluator.library.is_ring(&reference) {
        return Err(NO_RING);
    }
    let ring = Ring::new(evaluator, &reference)?;
    let integer = |place: usize, least: i64, most: i64| {
        let found = arguments.get(place).and_then(Function::integer);
        found.filter(|found| (least..=most).contains(found)).ok_or(ARGUMENT)
    };
    Ok(Some(match call.function {
        "eigenvalue" => {
            // Blocks up to t/2.
            let k = integer(1, 0, functions.signs.from / 2)?.unsigned_abs();
            let j = usize::try_from(integer(2, 1, MAX_POINT)?).map_err(|_| ARGUMENT)?;
            eigenvalue(functions, &ring, k, j)?
        }
        "subdominant" => Spectrum::new(functions, &ring)?.subdominant()?,
        "curvature" => {
            let part = call.choose("part", &PARTS)?;
            Spectrum::new(functions, &ring)?.curvature(part)?
        }
        "limit_weight" => limit(functions, &ring, orbit(call, &ring)?)?,
        _ => {
            let (orbit, j) = (orbit(call, &ring)?, integer(1, 0, MAX_POINT)?);
            let second = call.choose("tangent", &["first", "second"])? == 1;
            let lambda = Spectrum::new(functions, &ring)?.subdominant()?;
            tangent(functions, &ring, &lambda, (orbit, j, second))?
        }
    }))
}

/// The place of the orbit that a call names, or 0.
fn orbit(call: &mut Call<'_>, ring: &Ring) -> Result<usize, Stop> {
    let first = ring.orbits.first().map_or("", |(name, _)| name);
    let name = call.word("orbit", first);
    let place = ring.orbits.iter().position(|(orbit, _)| *orbit == name);
    place.ok_or_else(|| Stop::Wrong(format!("the ring has no orbit `{name}`")))
}
