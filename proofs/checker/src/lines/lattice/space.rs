//! The space of the values of the limit function at the translates of points of a tile, and its accuracy. THEOREMS.md, 149.

#![warn(clippy::arithmetic_side_effects)]

use super::motion::{Motion, Point, divided};
use super::operator::{Function, Operator};
use super::values::{power, powers};
use crate::numbers::{Echelon, Row, int};
use crate::schemes::{Vector, plus, times};
use crate::text::{Checked, Reason, Stop, require};
use std::collections::BTreeMap;

/// The most dimensions of the span of all values.
const MAX_DIMENSIONS: usize = 256;

/// How far accuracy is looked for beyond the sum rules.
const BEYOND: usize = 5;

/// A point x, and Φ(x), the function φ(x + α) of α.
#[derive(Clone)]
struct Known {
    point: Point,
    values: Function,
}

/// Columns: moments before the places, places, moments behind them.
type Column = (u8, Vector);

/// |μ|.
fn degree(powers: &[u32; 3]) -> u32 {
    powers.iter().fold(0_u32, |sum, exponent| sum.saturating_add(*exponent))
}

const PLACES: u8 = 1;
const BEHIND: u8 = 2;

/// The values at points whose functionals (Φ(x), (x^μ)_{|μ|<k}) are a basis of those of all points of a set.
pub struct Space<'o, 'l> {
    operator: &'o Operator<'l>,
    parts: &'o [Motion],
    powers: Vec<[u32; 3]>,
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
        let powers = powers(operator.dilation.d, order);
        let mut space = Space { operator, parts, powers, basis: Vec::new() };
        let zero = Known { point: [0; 3].map(int), values: values.clone() };
        space.close(zero)?;
        let mut all = Echelon::new(operator.meter);
        let mut basis = Vec::new();
        for known in &space.basis {
            for motion in neighbours {
                space.keep(&mut all, &mut basis, space.moved(known, motion)?)?;
            }
        }
        loop {
            let before = basis.len();
            space.basis = basis;
            (all, basis) = (Echelon::new(operator.meter), Vec::new());
            for known in &space.basis {
                for part in parts {
                    space.keep(&mut all, &mut basis, space.image(known, part)?)?;
                }
            }
            if basis.len() == before {
                return Ok(space);
            }
        }
    }

    /// The values at the images of a point by all products of the maps x ↦ M^{−1}g(x), g a part.
    fn close(&mut self, first: Known) -> Result<(), Stop> {
        let (mut all, mut basis, mut next) = (Echelon::new(self.operator.meter), Vec::new(), 0);
        self.keep(&mut all, &mut basis, first)?;
        while let Some(known) = basis.get(next).cloned() {
            for part in self.parts {
                self.keep(&mut all, &mut basis, self.image(&known, part)?)?;
            }
            next = next.saturating_add(1);
        }
        self.basis = basis;
        Ok(())
    }

    /// T_gΦ(x) = Φ(M^{−1}g(x)).
    fn image(&self, known: &Known, part: &Motion) -> Result<Known, Stop> {
        let point = divided(self.operator.dilation, &part.at(&known.point));
        Ok(Known { point, values: self.operator.image(part, &known.values)? })
    }

    /// Φ(h(x))_α = φ(G(x + G^{−1}(α + t))): the value at β goes to Gβ − t.
    fn moved(&self, known: &Known, motion: &Motion) -> Result<Known, Stop> {
        self.operator.meter.spend(known.values.len() as u64)?;
        let to = |(place, v): (&Vector, _)| {
            Ok((plus(times(&motion.turn, *place)?, -1, motion.by)?, Clone::clone(v)))
        };
        let values = known.values.iter().map(to).collect::<Result<Function, Stop>>()?;
        Ok(Known { point: motion.at(&known.point), values })
    }

    /// Adds values, if their row is no combination of the others.
    fn keep(
        &self,
        all: &mut Echelon<'_, Column>,
        basis: &mut Vec<Known>,
        known: Known,
    ) -> Result<(), Stop> {
        if all.add(self.row(&known, (BEHIND, self.powers.len()))?)? {
            basis.push(known);
        }
        if basis.len() > MAX_DIMENSIONS {
            return Err(Stop::Capped("the dimensions of the span of all values"));
        }
        Ok(())
    }

    /// Φ(x) with the first of the moments x^μ in columns of this kind.
    fn row(&self, known: &Known, (kind, count): (u8, usize)) -> Result<Row<Column>, Stop> {
        let mut row: Row<Column> =
            known.values.iter().map(|(place, v)| ((PLACES, *place), v.clone())).collect();
        for (powers, i) in self.powers.iter().zip(0..).take(count) {
            let moment = power(self.operator.meter, &known.point, *powers)?;
            row.insert((kind, [i, 0, 0]), moment);
        }
        Ok(row)
    }

    /// The rows in reduced echelon form, with the first of the moments in columns of this kind.
    fn reduced(&self, moments: (u8, usize)) -> Result<BTreeMap<Column, Row<Column>>, Stop> {
        let mut all = Echelon::new(self.operator.meter);
        for known in &self.basis {
            all.add(self.row(known, moments)?)?;
        }
        all.reduced()
    }

    /// The least degree of a moment that the values do not determine.
    fn undetermined(&self) -> Result<Option<u32>, Stop> {
        // A row without values, whose first moments are 0 too. Those of smaller degrees come first.
        let rows = self.reduced((BEHIND, self.powers.len()))?;
        let first = rows.keys().find(|(kind, _)| *kind == BEHIND);
        let powers = first.and_then(|(_, [i, ..])| self.powers.get(usize::try_from(*i).ok()?));
        Ok(powers.map(degree))
    }

    /// The reduced basis of the values whose moments below a degree are 0, by the places where its vectors begin.
    fn without_moments(&self, degree: u32) -> Checked<BTreeMap<Vector, Function>> {
        let count = self.powers.iter().take_while(|powers| self::degree(powers) < degree).count();
        let rows = self.reduced((0, count))?.into_iter();
        let rows = rows.filter(|((kind, _), _)| *kind == PLACES);
        let function = |row: Row<Column>| row.into_iter().map(|((_, place), v)| (place, v));
        Ok(rows.map(|((_, place), row)| (place, function(row).collect())).collect())
    }
}

/// K', and the reduced basis of U'.
pub fn space(
    operator: &Operator<'_>,
    motions: (&[Motion], &[Motion]),
    values: &Function,
    sum_rules: usize,
) -> Checked<(usize, BTreeMap<Vector, Function>)> {
    for order in
        (sum_rules..sum_rules.saturating_add(BEYOND)).map(|degree| degree.saturating_add(1))
    {
        let space = Space::of(operator, motions, values, order)?;
        if let Some(degree) = space.undetermined()? {
            let basis = space.without_moments(degree)?;
            require(!basis.is_empty(), Reason::Lattice("the space is not 0"))?;
            return Ok((degree as usize, basis));
        }
    }
    Err(Stop::Capped("the accuracy beyond the sum rules").into())
}
