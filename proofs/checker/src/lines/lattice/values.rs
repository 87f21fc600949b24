//! Values of the limit function.

#![warn(clippy::arithmetic_side_effects)]

use super::attractor;
use super::motion::{Motion, UNIT};
use super::operator::{Function, Operator};
use crate::numbers::{Echelon, Q, Row, int};
use crate::schemes::Vector;
use crate::text::{Checked, Reason, require};
use num_traits::One as _;
use std::collections::BTreeMap;

/// φ at the integers. It is 0 but in the attractor Y = M^{−1}(Y + supp a), where it is the only solution of
/// Σ_β a(Mα − β)φ(β) = φ(α), Σφ(α) = 1.
pub fn values(operator: &Operator<'_>, support: &[Vector]) -> Checked<Function> {
    let places = attractor::points(operator.meter, operator.dilation, (support, &[[0; 3]]))?;
    let numbers: BTreeMap<Vector, usize> = places.iter().copied().zip(0..).collect();
    let still = Motion { turn: UNIT, by: [0; 3] };
    // Equation α, with the right side behind all unknowns.
    let mut equations: BTreeMap<Vector, Row<usize>> = BTreeMap::new();
    for (place, i) in &numbers {
        let column = operator.image(&still, &Function::from([(*place, Q::one())]))?;
        let own = (*place, int(-1));
        for (at, a) in column.into_iter().chain([own]) {
            if numbers.contains_key(&at) {
                *equations.entry(at).or_default().entry(*i).or_default() += a;
            }
        }
    }
    let count = places.len();
    let mut all = Echelon::new(operator.meter);
    let sum = (0..=count).map(|i| (i, Q::one())).collect();
    for equation in equations.into_values().chain([sum]) {
        all.add(equation)?;
    }
    let unique = all.firsts().copied().eq(0..count);
    require(unique, Reason::Lattice("the values at the integers are the only ones"))?;
    let reduced = all.reduced()?;
    let value = |(i, row): (usize, Row<usize>)| Some((*places.get(i)?, row.get(&count)?.clone()));
    Ok(reduced.into_iter().filter_map(value).collect())
}
