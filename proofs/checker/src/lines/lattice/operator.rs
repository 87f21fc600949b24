//! The operators of a mask on functions of Z^d with finite support.

#![warn(clippy::arithmetic_side_effects)]

use super::motion::Motion;
use crate::numbers::{Meter, Q, Row, bits, product_steps};
use crate::schemes::{Dilation, Vector, plus, times};
use crate::text::{Checked, Reason, Stop, require};
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// The most places of a function.
const MAX_PLACES: usize = 400;

/// A function on Z^d, by its places in lexicographic order. No value is 0.
pub type Function = Row<Vector>;

/// A mask with its dilation.
pub struct Operator<'l> {
    pub meter: &'l Meter,
    pub dilation: &'l Dilation,
    /// The places of the coefficients, and these, by classes.
    classes: BTreeMap<Vector, Vec<(Vector, Q)>>,
}

impl<'l> Operator<'l> {
    /// The operators of the mask with these coefficients.
    pub fn new(
        meter: &'l Meter,
        dilation: &'l Dilation,
        mask: &[(Vector, Q)],
    ) -> Result<Operator<'l>, Stop> {
        let mut classes: BTreeMap<Vector, Vec<(Vector, Q)>> = BTreeMap::new();
        for (place, a) in mask {
            classes.entry(dilation.class(*place)?).or_default().push((*place, a.clone()));
        }
        Ok(Operator { meter, dilation, classes })
    }

    /// (T_gv)_α = Σ_β a(Mα + t − Gβ)v_β: the coefficient at γ takes v_β to the α with Mα = γ + Gβ − t.
    pub fn image(&self, part: &Motion, function: &Function) -> Result<Function, Stop> {
        let mut image = Function::new();
        for (place, v) in function {
            let from = plus(times(&part.turn, *place)?, -1, part.by)?;
            let class = self.dilation.class(plus([0; 3], -1, from)?)?;
            for (at, a) in self.classes.get(&class).into_iter().flatten() {
                let Some(to) = self.dilation.divided(plus(*at, 1, from)?)? else { continue };
                let entry = image.entry(to).or_insert_with(Q::zero);
                let length = [&*entry, a, v].map(bits).into_iter().fold(0, u64::saturating_add);
                self.meter.spend(product_steps(length))?;
                *entry += a * v;
            }
        }
        image.retain(|_, v| !v.is_zero());
        if image.len() > MAX_PLACES {
            return Err(Stop::Capped("the points of a window"));
        }
        Ok(image)
    }

    /// The matrices of fT_g for parts, on the space with this reduced basis.
    pub fn matrices(
        &self,
        parts: &[Motion],
        basis: &BTreeMap<Vector, Function>,
        factor: &Q,
    ) -> Checked<Vec<Vec<Vec<Q>>>> {
        let matrix = |part: &Motion| -> Checked<Vec<Vec<Q>>> {
            basis.values().map(|vector| self.row(part, vector, basis, factor)).collect()
        };
        parts.iter().map(matrix).collect()
    }

    /// The coordinates of the image of a vector. They are its values where the vectors of the basis begin.
    fn row(
        &self,
        part: &Motion,
        vector: &Function,
        basis: &BTreeMap<Vector, Function>,
        factor: &Q,
    ) -> Checked<Vec<Q>> {
        let mut rest = self.image(part, vector)?;
        let mut row = Vec::with_capacity(basis.len());
        for (first, other) in basis {
            let coordinate = rest.get(first).cloned().unwrap_or_else(Q::zero);
            row.push(&coordinate * factor);
            if coordinate.is_zero() {
                continue;
            }
            for (place, v) in other {
                let entry = rest.entry(*place).or_insert_with(Q::zero);
                let numbers = [&*entry, v, &coordinate].map(bits);
                let length = numbers.into_iter().fold(0, u64::saturating_add);
                self.meter.spend(product_steps(length))?;
                *entry -= v * &coordinate;
            }
        }
        let none = rest.values().all(Q::is_zero);
        require(none, Reason::Lattice("the parts keep the space"))?;
        Ok(row)
    }
}
