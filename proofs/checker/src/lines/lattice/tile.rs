//! Tiles that parts of a motion group cut into smaller ones. THEOREMS.md, 149.

#![warn(clippy::arithmetic_side_effects)]

use super::attractor;
use super::differences::digits;
use super::motion::{Motion, Point, UNIT, divided};
use crate::numbers::{Meter, Q, int, solve};
use crate::schemes::{Dilation, Vector, plus, times};
use crate::text::{Checked, Reason, Stop, require};
use num_traits::{Signed as _, Zero as _};
use std::collections::BTreeSet;

/// A simplex that is a tile.
struct Simplex {
    name: &'static str,
    /// The directions that its group permutes, up to their signs; the first d of them are a basis.
    directions: &'static [Vector],
    /// Its corners, times [`UNITS`].
    corners: &'static [Vector],
}

/// The parts of 1 that coordinates of corners are.
const UNITS: i64 = 6;

/// The simplices: the fundamental domains of groups that reflections generate.
const SIMPLICES: [Simplex; 4] = [
    Simplex {
        name: "square",
        directions: &[[1, 0, 0], [0, 1, 0]],
        corners: &[[0, 0, 0], [3, 0, 0], [3, 3, 0]],
    },
    Simplex {
        name: "hexagon +",
        directions: &[[1, 0, 0], [0, 1, 0], [1, 1, 0]],
        corners: &[[0, 0, 0], [3, 0, 0], [4, 2, 0]],
    },
    Simplex {
        name: "hexagon -",
        directions: &[[1, 0, 0], [0, 1, 0], [1, -1, 0]],
        corners: &[[0, 0, 0], [3, 0, 0], [2, 2, 0]],
    },
    Simplex {
        name: "cube",
        directions: &[[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        corners: &[[0, 0, 0], [3, 0, 0], [3, 3, 0], [3, 3, 3]],
    },
];

/// Rational numbers by their places.
pub type Coefficients = Vec<(Vector, Q)>;

/// A tile, with the coefficients of a mask, moved so that the group of the tile fixes the limit function.
pub struct Tile {
    /// The matrices of the group.
    pub group: BTreeSet<[Vector; 3]>,
    /// The simplex that it is; none of digits.
    simplex: Option<&'static Simplex>,
    /// Those of the powers of a parameter; of a mask of numbers, one.
    pub masks: Vec<Coefficients>,
}

impl Tile {
    /// The tile of this name with these parts.
    pub fn of(
        dilation: &Dilation,
        masks: Vec<Coefficients>,
        name: &str,
        parts: &[Motion],
    ) -> Checked<Tile> {
        if name == "digits" {
            digits(dilation, parts)?;
            return Ok(Tile { group: BTreeSet::from([UNIT]), simplex: None, masks });
        }
        let simplex = SIMPLICES.iter().find(|simplex| simplex.name == name);
        let simplex = simplex.ok_or(Reason::Malformed("a tile"))?;
        let fits = simplex.corners.len() == dilation.d.saturating_add(1);
        require(fits, Reason::Lattice("the tile has the dimension of the mask"))?;
        let group = simplex.group(dilation.d)?;
        let commutes = kept(dilation, &group)?;
        require(commutes, Reason::Lattice("the dilation keeps the group of the tile"))?;
        let masks = centred(dilation, masks)?;
        for mask in &masks {
            let coefficients: BTreeSet<&(Vector, Q)> = mask.iter().collect();
            for turn in &group {
                for (place, a) in mask {
                    let symmetric = coefficients.contains(&(times(turn, *place)?, a.clone()));
                    require(symmetric, Reason::Lattice("the group of the tile keeps the mask"))?;
                }
            }
        }
        simplex.check_parts(dilation, &group, parts)?;
        Ok(Tile { group, simplex: Some(simplex), masks })
    }

    /// The motions to the neighbours of the tile, and to itself.
    pub fn neighbours(
        &self,
        meter: &Meter,
        dilation: &Dilation,
        parts: &[Motion],
    ) -> Checked<Vec<Motion>> {
        if let Some(simplex) = self.simplex {
            return Ok(simplex.neighbours(&self.group)?);
        }
        // A − A is the attractor of E − E.
        let digits = digits(dilation, parts)?;
        let places = attractor::points(meter, dilation, (&digits, &digits))?;
        Ok(places.into_iter().map(|by| Motion { turn: UNIT, by }).collect())
    }
}

impl Simplex {
    /// The rows of the matrices that permute the directions and their opposites.
    fn group(&self, d: usize) -> Result<BTreeSet<[Vector; 3]>, Stop> {
        let mut signed = Vec::new();
        for direction in self.directions {
            signed.extend([*direction, plus([0; 3], -1, *direction)?]);
        }
        let known: BTreeSet<Vector> = signed.iter().copied().collect();
        // The unit vectors are among the directions, and their images are the columns.
        let third = if d == 2 { &UNIT[2..] } else { &signed[..] };
        let mut group = BTreeSet::new();
        for x in &signed {
            for y in &signed {
                for z in third {
                    let rows = [0, 1, 2].map(|i: usize| [x[i], y[i], z[i]]);
                    let images = signed.iter().map(|direction| times(&rows, *direction));
                    let images = images.collect::<Result<BTreeSet<Vector>, Stop>>()?;
                    if images == known {
                        group.insert(rows);
                    }
                }
            }
        }
        Ok(group)
    }

    /// The motions that take a corner to a corner. Where an image of the tile meets it, a common face is fixed, and so is a corner of it.
    fn neighbours(&self, group: &BTreeSet<[Vector; 3]>) -> Result<Vec<Motion>, Stop> {
        let mut found = BTreeSet::new();
        for turn in group {
            for from in self.corners {
                for to in self.corners {
                    let by = plus(*to, -1, times(turn, *from)?)?;
                    if by.iter().all(|x| x.checked_rem(UNITS) == Some(0)) {
                        let by = by.map(|x| x.checked_div(UNITS).unwrap_or(0));
                        found.insert(Motion { turn: *turn, by });
                    }
                }
            }
        }
        Ok(found.into_iter().collect())
    }

    /// Checks that the parts are m different motions that take the tile to parts of its dilation. They have the volume of all of it, as
    /// no two images of the tile by different motions overlap.
    fn check_parts(
        &self,
        dilation: &Dilation,
        group: &BTreeSet<[Vector; 3]>,
        parts: &[Motion],
    ) -> Checked<()> {
        let different: BTreeSet<&Motion> = parts.iter().collect();
        let all = parts.len() as u64 == dilation.arity() && different.len() == parts.len();
        require(all, Reason::Lattice("there are as many different parts as classes"))?;
        let own = parts.iter().all(|part| group.contains(&part.turn));
        require(own, Reason::Lattice("the group of the tile has the matrices of the parts"))?;
        for part in parts {
            for corner in self.corners {
                let corner = corner.map(|x| Q::new(x.into(), UNITS.into()));
                let within = self.contains(dilation.d, &divided(dilation, &part.at(&corner)));
                require(within, Reason::Lattice("the parts are in the tile"))?;
            }
        }
        Ok(())
    }

    /// Whether a point is in the simplex: a sum of multiples of the corners by numbers that are not negative and sum to 1.
    fn contains(&self, d: usize, point: &Point) -> bool {
        let row = |i: usize| {
            let corners = self.corners.iter().map(|corner| Q::new(corner[i].into(), UNITS.into()));
            corners.chain([point[i].clone()]).collect()
        };
        let ones = vec![int(1); self.corners.len().saturating_add(1)];
        let rows: Vec<Vec<Q>> = (0..d).map(row).chain([ones]).collect();
        solve(rows).is_some_and(|factors| factors.iter().all(|factor| !factor.is_negative()))
    }
}

/// Whether MHM^{−1} = H: for each h there is a g with Mh = gM. Different h have different g.
fn kept(dilation: &Dilation, group: &BTreeSet<[Vector; 3]>) -> Result<bool, Stop> {
    let columns = |one: &[Vector; 3], other: &[Vector; 3]| -> Result<Vec<Vector>, Stop> {
        UNIT.iter().map(|unit| times(one, times(other, *unit)?)).collect()
    };
    let rows = dilation.rows();
    let turned = group.iter().map(|turn| columns(turn, rows));
    let turned = turned.collect::<Result<BTreeSet<_>, Stop>>()?;
    for turn in group {
        if !turned.contains(&columns(rows, turn)?) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The coefficients a(γ + (M − I)τ), τ = (M − I)^{−1}m_1 integer. Then (M − I)τ = m_1, the mean of the places, which is that of the first of
/// several masks: a mean that depends on the parameter is that of no symmetric mask.
fn centred(dilation: &Dilation, masks: Vec<Coefficients>) -> Checked<Vec<Coefficients>> {
    let m = int(dilation.adjugate().1).abs();
    let mut mean = [0; 3].map(int);
    for (place, a) in masks.first().into_iter().flatten() {
        for (sum, x) in mean.iter_mut().zip(place) {
            *sum += a * int(*x) / &m;
        }
    }
    let rows = dilation.rows().iter().zip(UNIT).zip(&mean).take(dilation.d);
    let equation = |((row, unit), mean): ((&Vector, Vector), &Q)| -> Vec<Q> {
        let less = row.iter().zip(unit).map(|(x, one)| int(*x) - int(one));
        less.take(dilation.d).chain([mean.clone()]).collect()
    };
    let shift = solve(rows.map(equation).collect());
    let whole = shift.is_some_and(|shift| shift.iter().all(Q::is_integer));
    let integers = mean.each_ref().map(|x| i64::try_from(x.to_integer()));
    let ([Ok(x), Ok(y), Ok(z)], true) = (integers, whole) else {
        return Err(Reason::Lattice("the natural shift is integer").into());
    };
    let moved = |(place, a): (Vector, Q)| Ok((plus(place, -1, [x, y, z])?, a));
    let all = |mask: Coefficients| {
        mask.into_iter().filter(|(_, a)| !a.is_zero()).map(moved).collect::<Checked<Coefficients>>()
    };
    masks.into_iter().map(all).collect()
}
