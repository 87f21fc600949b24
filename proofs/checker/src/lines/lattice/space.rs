//! The space of the values of the limit function at the translates of points of a tile, and its accuracy. THEOREMS.md, 149.

#![warn(clippy::arithmetic_side_effects)]

use super::moments::{Affine, powers};
use super::motion::Motion;
use super::operator::{Function, Operator};
use crate::numbers::{Echelon, Q, Row, int};
use crate::schemes::{Vector, plus, times};
use crate::text::{Checked, Reason, Stop, require};
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// The most dimensions of the span of all values.
const MAX_DIMENSIONS: usize = 256;

/// How far accuracy is looked for beyond the sum rules.
const BEYOND: usize = 5;

/// A vector Σ c_iZ(x_i), Z(x) = (Φ(x), (x^μ)_{|μ|<k}): Φ(x) is the function φ(x + α) of α. The moments Σ c_ix_i^μ stand by the numbers of
/// the μ.
#[derive(Clone)]
struct Known {
    values: Function,
    moments: BTreeMap<usize, Q>,
}

/// Columns: moments before the places, places, moments behind them.
type Column = (u8, Vector);

const BEFORE: u8 = 0;
const PLACES: u8 = 1;
const BEHIND: u8 = 2;

impl Known {
    /// The row with the first of the moments in columns of this kind.
    fn row(&self, kind: u8, count: usize) -> Row<Column> {
        let values = self.values.iter().map(|(place, v)| ((PLACES, *place), v.clone()));
        let moments = self.moments.range(..count);
        let column = |i: usize| (kind, [i64::try_from(i).unwrap_or(i64::MAX), 0, 0]);
        values.chain(moments.map(|(i, moment)| (column(*i), moment.clone()))).collect()
    }

    /// What a row with moments stands for.
    fn of(row: Row<Column>) -> Known {
        let (mut values, mut moments) = (Function::new(), BTreeMap::new());
        for ((kind, place), x) in row {
            if kind == PLACES {
                values.insert(place, x);
            } else {
                moments.insert(usize::try_from(place[0]).unwrap_or(usize::MAX), x);
            }
        }
        Known { values, moments }
    }
}

/// The span of the Z(x) for all points of a set.
struct Space<'o, 'l> {
    operator: &'o Operator<'l>,
    /// The μ.
    powers: Vec<[u32; 3]>,
    /// The parts, with what they make of moments.
    parts: Vec<(&'o Motion, Affine)>,
    basis: Vec<Known>,
}

impl<'o, 'l> Space<'o, 'l> {
    /// That of the points of the tile and its neighbours which are left after many steps, with the moments below an order.
    fn of(
        operator: &'o Operator<'l>,
        (parts, neighbours): (&'o [Motion], &[Motion]),
        values: &Function,
        order: usize,
    ) -> Checked<Space<'o, 'l>> {
        let (powers, meter) = (powers(operator.dilation.d, order), operator.meter);
        let shrunk = |part| Ok((part, Affine::shrunk(meter, operator.dilation, part, &powers)?));
        let parts = parts.iter().map(shrunk).collect::<Result<_, Stop>>()?;
        let mut space = Space { operator, powers, parts, basis: Vec::new() };
        space.close(values)?;
        let mut all = Echelon::new(meter);
        for motion in neighbours {
            let affine = Affine::of(meter, motion, &space.powers)?;
            for known in &space.basis {
                space.keep(&mut all, &space.moved(known, (motion, &affine))?)?;
            }
        }
        loop {
            let basis = reduced(all)?;
            let before = basis.len();
            (space.basis, all) = (basis, Echelon::new(meter));
            let mut count = 0_usize;
            for known in &space.basis {
                for part in &space.parts {
                    let is_new = space.keep(&mut all, &space.image(known, part)?)?;
                    count = count.saturating_add(usize::from(is_new));
                }
            }
            if count == before {
                return Ok(space);
            }
        }
    }

    /// The span of Z(0) and its images by all products of the maps x ↦ M^{−1}g(x), g a part: by one factor more, until nothing is
    /// new. Between two factors the basis is reduced, so that its numbers remain short.
    fn close(&mut self, values: &Function) -> Result<(), Stop> {
        let zero = Known { values: values.clone(), moments: BTreeMap::from([(0, int(1))]) };
        let mut basis = vec![zero];
        while basis.len() > self.basis.len() {
            self.basis = basis;
            let mut all = Echelon::new(self.operator.meter);
            for known in &self.basis {
                self.keep(&mut all, known)?;
            }
            for known in &self.basis {
                for part in &self.parts {
                    self.keep(&mut all, &self.image(known, part)?)?;
                }
            }
            basis = reduced(all)?;
        }
        Ok(())
    }

    /// T_gΦ(x) = Φ(M^{−1}g(x)).
    fn image(&self, known: &Known, (part, affine): &(&Motion, Affine)) -> Result<Known, Stop> {
        let values = self.operator.image(part, &known.values)?;
        Ok(Known { values, moments: self.moments(known, affine)? })
    }

    /// Φ(h(x))_α = φ(G(x + G^{−1}(α + t))): the value at β goes to Gβ − t.
    fn moved(&self, known: &Known, (motion, affine): (&Motion, &Affine)) -> Result<Known, Stop> {
        self.operator.meter.spend(known.values.len() as u64)?;
        let to = |(place, v): (&Vector, &Q)| {
            Ok((plus(times(&motion.turn, *place)?, -1, motion.by)?, v.clone()))
        };
        let values = known.values.iter().map(to).collect::<Result<Function, Stop>>()?;
        Ok(Known { values, moments: self.moments(known, affine)? })
    }

    fn moments(&self, known: &Known, affine: &Affine) -> Result<BTreeMap<usize, Q>, Stop> {
        let moved = affine.moved(self.operator.meter, &known.moments)?;
        Ok(moved.into_iter().enumerate().filter(|(_, moment)| !moment.is_zero()).collect())
    }

    /// Adds a vector, if it is no combination of the others; says whether this is so.
    fn keep(&self, all: &mut Echelon<'_, Column>, known: &Known) -> Result<bool, Stop> {
        let is_new = all.add(known.row(BEHIND, self.powers.len()))?;
        if all.firsts().len() > MAX_DIMENSIONS {
            return Err(Stop::Capped("the dimensions of the span of all values"));
        }
        Ok(is_new)
    }

    /// The least degree of a moment that the values do not determine: that of the first moment of a vector without values. Those
    /// of smaller degrees come first.
    fn undetermined(&self) -> Option<u32> {
        let without = self.basis.iter().filter(|known| known.values.is_empty());
        let first =
            without.filter_map(|known| known.moments.first_key_value()).map(|(i, _)| *i).min();
        first.and_then(|i| self.powers.get(i)).map(degree)
    }

    /// The reduced basis of the values whose moments below a degree are 0, by the places where its vectors begin.
    fn without_moments(&self, below: u32) -> Checked<BTreeMap<Vector, Function>> {
        let count = self.powers.iter().take_while(|powers| degree(powers) < below).count();
        let mut all = Echelon::new(self.operator.meter);
        for known in &self.basis {
            all.add(known.row(BEFORE, count))?;
        }
        let rows = all.reduced()?.into_iter().filter(|((kind, _), _)| *kind == PLACES);
        Ok(rows.map(|((_, place), row)| (place, Known::of(row).values)).collect())
    }
}

/// The reduced rows. Each begins with a value, or has none.
fn reduced(all: Echelon<'_, Column>) -> Result<Vec<Known>, Stop> {
    Ok(all.reduced()?.into_values().map(Known::of).collect())
}

/// |μ|.
fn degree(powers: &[u32; 3]) -> u32 {
    powers.iter().fold(0_u32, |sum, exponent| sum.saturating_add(*exponent))
}

/// K', and the reduced basis of U'.
pub fn space(
    operator: &Operator<'_>,
    motions: (&[Motion], &[Motion]),
    values: &Function,
    sum_rules: usize,
) -> Checked<(usize, BTreeMap<Vector, Function>)> {
    for degree in sum_rules..sum_rules.saturating_add(BEYOND) {
        let space = Space::of(operator, motions, values, degree.saturating_add(1))?;
        if let Some(degree) = space.undetermined() {
            let basis = space.without_moments(degree)?;
            require(!basis.is_empty(), Reason::Lattice("the space is not 0"))?;
            return Ok((degree as usize, basis));
        }
    }
    Err(Stop::Capped("the accuracy beyond the sum rules").into())
}
