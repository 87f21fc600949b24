//! Functions of masks on Z^d (proofs/format/lattice.md).

#![warn(clippy::arithmetic_side_effects)]

mod distances;
mod flow;
mod moments;
mod powers;

use super::call::{Call, NO_FUNCTION, number, within, wrong};
use crate::formulas::MAX_INTEGER;
use crate::numbers::{Meter, Q, Value};
use crate::schemes::{Dilation, Lattice, Vector, plus};
use crate::text::Stop;
use moments::Moments;
use std::collections::BTreeMap;
use std::rc::Rc;

pub use moments::exponents;
pub use powers::constant;

/// The order of the sum rules of a mask of rational numbers.
pub fn sum_rules(meter: &Meter, lattice: &Lattice) -> Result<usize, Stop> {
    Moments::new(meter, lattice)?.sum_rules()
}

/// The order up to which coefficients of which each class has the same sum satisfy the equations of sum rules.
pub fn equal_moments(
    meter: &Meter,
    dilation: &Dilation,
    coefficients: &[(Vector, Q)],
) -> Result<usize, Stop> {
    Moments::of(meter, dilation, coefficients)?.sum_rules()
}

/// The functions in which masks on Z^d stand.
const FUNCTIONS: [&str; 11] = [
    "approximation_order",
    "arity",
    "coefficient",
    "contraction",
    "generation",
    "interpolating",
    "norm",
    "reproduction",
    "same",
    "sum_rules",
    "symmetric",
];

/// The value of such a function; `None` if the call is none, or not about a mask on Z^d.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    if !FUNCTIONS.contains(&call.function) {
        return Ok(None);
    }
    let Some(lattice) = called(call)? else { return Ok(None) };
    if let ("coefficient", places) = (call.function, call.arguments) {
        return coefficient(&lattice, places).map(Some);
    }
    let (meter, truth) = (call.library.meter, |is: bool| Value::int(is.into()));
    // All other functions are of masks of rational numbers.
    lattice.rational()?;
    let moments = || Moments::new(meter, &lattice);
    Ok(Some(match (call.function, call.arguments) {
        ("arity", []) => Value::from(Q::from_integer(lattice.dilation.arity().into())),
        ("interpolating", []) => truth(is_interpolating(&lattice)?),
        ("symmetric", []) => truth(is_symmetric(&lattice)?),
        ("sum_rules", []) => number(moments()?.sum_rules()?),
        ("generation", []) => number(moments()?.sum_rules()?.saturating_sub(1)),
        ("reproduction", []) => number(moments()?.reproduction()?),
        ("approximation_order", []) if call.choose("data", &["sampled", "adapted"])? == 1 => {
            number(moments()?.sum_rules()?)
        }
        ("approximation_order", []) => number(moments()?.reproduction()?.saturating_add(1)),
        ("same", []) => {
            truth(other(call)?.is_some_and(|other| {
                lattice.dilation == other.dilation && lattice.mask == other.mask
            }))
        }
        ("contraction" | "norm", level @ ([] | [_])) => {
            let c = level.first().map_or(Ok(1), |c| within(c, 0, MAX_INTEGER))?;
            constant(meter, &lattice, call.function == "norm", c)?.into()
        }
        (function, arguments) => {
            let count = arguments.len();
            return wrong(format!(
                "there is no `{function}` of {count} arguments of a mask on Z^d"
            ));
        }
    }))
}

/// The mask on Z^d that a call is about.
fn called(call: &mut Call<'_>) -> Result<Option<Rc<Lattice>>, Stop> {
    let (library, scope) = (call.library, call.scope);
    match call.names() {
        None => Ok(scope.lattice.clone()),
        Some(name) if library.is_lattice(name) => {
            let reference = call.reference()?.unwrap_or_default();
            if library.depending(&reference, scope)?.is_some() {
                return Err(NO_FUNCTION);
            }
            library.lattice(&reference, scope).map(Some)
        }
        Some(_) => Ok(None),
    }
}

/// The mask on Z^d that the option `with` names; `None` if it names another scheme.
fn other(call: &mut Call<'_>) -> Result<Option<Rc<Lattice>>, Stop> {
    let Some(name) = call.option("with") else { return wrong("the option `with` is missing") };
    let mut closed = call.library.closed();
    closed.reading = call.scope.reading;
    if call.library.is_lattice(name) {
        let other = call.library.lattice(name, &closed)?;
        return other.rational().map(|_| Some(other));
    }
    call.library.resolve_any(name, &closed).map(|_| None)
}

/// a(α).
fn coefficient(lattice: &Lattice, places: &[Value]) -> Result<Value, Stop> {
    let d = lattice.dilation.d;
    if places.len() != d {
        return wrong(format!("`coefficient` takes {d} integers of this mask"));
    }
    let mut place = [0; 3];
    for (i, value) in place.iter_mut().zip(places) {
        *i = value.integer(MAX_INTEGER)?;
    }
    Ok(lattice.mask.get(&place).cloned().unwrap_or_else(|| Value::int(0)))
}

/// Whether a class has one coefficient that is not 0.
fn is_interpolating(lattice: &Lattice) -> Result<bool, Stop> {
    let mut counts = BTreeMap::<Vector, usize>::new();
    for place in lattice.mask.keys() {
        let count = counts.entry(lattice.dilation.class(*place)?).or_default();
        *count = count.saturating_add(1);
    }
    Ok(counts.values().any(|count| *count == 1))
}

/// Whether a(s − α) = a(α) for all α. Then the last place in lexicographic order is s less the first one.
fn is_symmetric(lattice: &Lattice) -> Result<bool, Stop> {
    let mask = &lattice.mask;
    let (Some((first, _)), Some((last, _))) = (mask.first_key_value(), mask.last_key_value())
    else {
        return wrong("the symbol is 0");
    };
    let sum = plus(*first, 1, *last)?;
    for (place, a) in mask {
        if mask.get(&plus(sum, -1, *place)?) != Some(a) {
            return Ok(false);
        }
    }
    Ok(true)
}
