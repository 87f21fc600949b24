//! Functions of masks on Z^d.

use crate::cap::Cap;
use crate::evaluation::arguments::{index, level};
use crate::evaluation::options::{Data, Options};
use crate::exact::Rational;
use crate::formula::{Call, CallError, Value};
use crate::lattice::{LatticeConstants, is_interpolating, reproduction, sum_rules, symmetries};
use crate::scheme::LatticeMask;

/// The value of a function of a mask on Z^d. `other` gives the mask that a name stands for, if it is one on Z^d.
///
/// # Errors
/// When there is no such value, or no such function of masks on Z^d.
pub(crate) fn of_lattice<V: Value + PartialEq>(
    mask: &LatticeMask<V>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    other: impl Fn(&str) -> Result<Option<LatticeMask<V>>, CallError>,
) -> Result<V, CallError> {
    let number = |value: u32| V::from_rational(&Rational::from(value));
    let truth = |holds: bool| number(u32::from(holds));
    Ok(match (call.function, call.arguments) {
        ("coefficient", place) if place.len() == mask.dimension() => {
            let mut at = [0; 3];
            for (at, x) in at.iter_mut().zip(place) {
                *at = index("a place in the mask", x)?;
            }
            mask.coefficients().get(&at).cloned().unwrap_or_else(V::zero)
        }
        ("arity", []) => {
            V::from_rational(&Rational::from(rational(mask)?.dilation().class_count()))
        }
        ("same", []) => {
            let Some(name) = options.take("with") else {
                let message = "name the other scheme: `same(with = NAME)`";
                return Err(CallError::Misuse(message.to_owned()));
            };
            rational(mask)?;
            let other = other(&name)?;
            other.as_ref().map(rational).transpose()?;
            truth(other.is_some_and(|other| {
                mask.dilation() == other.dilation() && mask.coefficients() == other.coefficients()
            }))
        }
        ("interpolating", []) => truth(is_interpolating(&rational(mask)?)),
        ("symmetric", []) => truth(is_symmetric(&rational(mask)?)),
        ("sum_rules", []) => number(sum_rules(&rational(mask)?)),
        ("generation", []) => number(sum_rules(&rational(mask)?) - 1),
        ("reproduction", []) => number(reproduction(&rational(mask)?)),
        ("approximation_order", []) => match options.data()? {
            Data::Sampled => number(reproduction(&rational(mask)?) + 1),
            Data::Adapted => number(sum_rules(&rational(mask)?)),
        },
        ("contraction", c @ ([] | [_])) => {
            let mask = rational(mask)?;
            let found = after(&mask, c)?.contraction();
            let found = found.map_err(|error| CallError::Misuse(error.to_string()))?;
            V::from_rational(&found.value)
        }
        ("norm", c @ ([] | [_])) => V::from_rational(&after(&rational(mask)?, c)?.norm()),
        (function, arguments) => {
            return Err(CallError::Misuse(format!(
                "`{function}` with {} arguments is no function of masks on Z^d; these have coefficient(i, j), arity(), interpolating(), symmetric(), \
                 sum_rules(), generation(), reproduction(), approximation_order(), contraction(c), norm(c) and same(with = NAME)",
                arguments.len()
            )));
        }
    })
}

/// The mask, whose coefficients are rational.
fn rational<V: Value>(mask: &LatticeMask<V>) -> Result<LatticeMask, CallError> {
    let what = "the number of coefficients of a mask on Z^d that are no rational numbers";
    mask.rational().ok_or(CallError::BeyondCap(Cap::new(what, 0)))
}

/// Whether −I is among the symmetries.
fn is_symmetric(mask: &LatticeMask) -> bool {
    let d = mask.dimension();
    let minus =
        |g: &[[i64; 3]; 3]| (0..d).all(|i| (0..d).all(|j| g[i][j] == if i == j { -1 } else { 0 }));
    symmetries(mask).iter().any(minus)
}

/// The constants after c steps.
fn after<'m, V: Value>(mask: &'m LatticeMask, c: &[V]) -> Result<LatticeConstants<'m>, CallError> {
    let mut constants = LatticeConstants::new(mask);
    for _ in 0..c.first().map_or(Ok(1), level)? {
        constants.advance().map_err(CallError::BeyondCap)?;
    }
    Ok(constants)
}
