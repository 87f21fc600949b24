//! The space on which convergence is decided. THEOREMS.md, 148.

#![warn(clippy::arithmetic_side_effects)]

use super::attractor;
use super::moments::{point, power, powers};
use super::motion::{Motion, UNIT};
use super::operator::{Function, Operator};
use crate::numbers::{Echelon, Meter, Row, int};
use crate::schemes::{Dilation, Vector};
use crate::text::{Checked, Reason, Stop, require};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// The most dimensions of a space.
pub const MAX_DIMENSIONS: usize = 96;

/// Checks that parts are translations by one vector of each class, 0 among them, and gives these.
pub fn digits(dilation: &Dilation, parts: &[Motion]) -> Checked<Vec<Vector>> {
    let still = parts.iter().all(|part| part.turn == UNIT);
    require(still, Reason::Lattice("the parts are translations"))?;
    let digits: Vec<Vector> = parts.iter().map(|part| part.by).collect();
    let classes = digits.iter().map(|digit| dilation.class(*digit));
    let classes = classes.collect::<Result<BTreeSet<Vector>, Stop>>()?;
    let count = dilation.arity();
    let complete = digits.len() as u64 == count && classes.len() as u64 == count;
    require(complete, Reason::Lattice("there is one digit of each class"))?;
    require(digits.contains(&[0; 3]), Reason::Lattice("0 is a digit"))?;
    Ok(digits)
}

/// The reduced basis of the functions v on the integer points of the attractor M^{−1}(X + supp a − E) with Σ v_ββ^μ = 0 for
/// |μ| < K, by the places where its vectors begin.
pub fn space(
    operator: &Operator<'_>,
    (support, digits): (&[Vector], &[Vector]),
    order: usize,
) -> Checked<BTreeMap<Vector, Function>> {
    let window = attractor::points(operator.meter, operator.dilation, (support, digits))?;
    without_moments((operator.meter, operator.dilation.d), &window, order)
}

/// The same on the functions of these places.
pub fn without_moments(
    (meter, d): (&Meter, usize),
    window: &[Vector],
    order: usize,
) -> Checked<BTreeMap<Vector, Function>> {
    // The last places first: then each other place is that where one vector begins, and in no other vector.
    let mut conditions: Echelon<'_, Reverse<Vector>> = Echelon::new(meter);
    for powers in powers(d, order) {
        let entry = |place: &Vector| Ok((Reverse(*place), power(meter, &point(*place), powers)?));
        let row = window.iter().map(entry).collect::<Result<Row<Reverse<Vector>>, Stop>>()?;
        conditions.add(row)?;
    }
    let conditions = conditions.reduced()?;
    let free = window.iter().filter(|place| !conditions.contains_key(&Reverse(**place)));
    let mut basis: BTreeMap<Vector, Function> =
        free.map(|place| (*place, Function::from([(*place, int(1))]))).collect();
    require(!basis.is_empty(), Reason::Lattice("the space is not 0"))?;
    if basis.len() > MAX_DIMENSIONS {
        return Err(Stop::Capped("the dimensions of a space").into());
    }
    for (Reverse(last), row) in conditions {
        for (Reverse(place), x) in row {
            if let Some(vector) = basis.get_mut(&place) {
                vector.insert(last, -x);
            }
        }
    }
    Ok(basis)
}
