//! The rules on the inner ring, and their Fourier blocks.

use super::ball::Ball;
use super::lattice::Part;
use crate::numbers::{Number, Q, Value, count, int};
use crate::schemes::LocalRules;
use crate::text::{Checked, Reason, Stop, require};
use std::ops::Range;

/// The inner ring.
pub struct Inner {
    /// Its regular part.
    pub part: Part,
    /// The valence n.
    pub order: usize,
    /// Whether points other than the vertex, or the face, have rules of their own.
    pub own: bool,
    /// For each orbit: its first point, and its number of points.
    orbits: Vec<(usize, usize)>,
    weights: Vec<Vec<Value>>,
}

const OUTER: Reason = Reason::Vertex(
    "points other than the vertex, or other than those next to it where the points around these are declared, have the \
     rules of the regular part",
);

const RING: Reason = Reason::Vertex(
    "the orbits are those of a regular part, the weights are the same in all \
                                     sectors and their own mirror image",
);

/// cos(2π·turn).
fn cosine(turn: &Q) -> Result<Ball, Stop> {
    Ball::of(&Number::cosine(turn)?)
}

impl Inner {
    /// The rules of a ring, if its orbits are those of a regular part. The weights have to be the same in all sectors,
    /// and their own mirror image.
    pub fn read(ring: &LocalRules<'_>) -> Checked<Inner> {
        let mut orbits: Vec<(usize, usize)> = Vec::new();
        let mut names: Vec<&str> = Vec::new();
        for (place, name) in ring.names.iter().enumerate() {
            let name = name.split('[').next().unwrap_or_default();
            if names.last() == Some(&name) {
                if let Some((_, count)) = orbits.last_mut() {
                    *count += 1;
                }
            } else {
                names.push(name);
                orbits.push((place, 1));
            }
        }
        let declared = Part::declared_by(&names);
        let part = Part::of_orbits(&names).or(declared).ok_or(RING)?;
        let order = orbits.last().map_or(0, |(_, count)| *count);
        let counts = names.iter().zip(&orbits);
        let fits = |(name, (_, count)): (&&str, &(usize, usize))| {
            *count == if *name == "vertex" { 1 } else { order }
        };
        require(order >= 3 && counts.into_iter().all(fits), RING)?;
        let weights = ring.weights.clone();
        let mut inner = Inner { part, order, own: false, orbits, weights };
        require(inner.is_regular(part.inner().len()..inner.orbits.len()), OUTER)?;
        // The points next to the vertex depend on none of the others.
        inner.orbits.truncate(part.inner().len());
        let count = inner.orbits.last().map_or(0, |(first, count)| first + count);
        let mut rows = inner.weights[..count].iter();
        require(rows.all(|row| row[count..].iter().all(Value::is_zero)), OUTER)?;
        require(inner.is_symmetric(), RING)?;
        inner.own = part != Part::Biquadratic && !inner.is_regular(1..inner.orbits.len());
        require(declared.is_some() || !inner.own, OUTER)?;
        Ok(inner)
    }

    /// The point of an orbit in a sector.
    fn point(&self, orbit: usize, sector: usize) -> usize {
        let (first, count) = self.orbits[orbit];
        first + sector % count
    }

    /// Twice the angle of the first point of an orbit, in sectors.
    fn offset(&self, orbit: usize) -> usize {
        usize::from(self.part == Part::Bicubic && orbit == 2)
    }

    /// The weight of the point in a sector of an orbit in the first point of another.
    fn weight(&self, a: usize, b: usize, sector: usize) -> &Value {
        &self.weights[self.point(a, 0)][self.point(b, sector)]
    }

    fn is_symmetric(&self) -> bool {
        let (n, all) = (self.order, 0..self.orbits.len());
        all.clone().all(|a| {
            all.clone().all(|b| {
                (0..n).all(|d| {
                    let weight = self.weight(a, b, d);
                    let turned = (0..n).all(|s| {
                        let (row, column) = (self.point(a, s), self.point(b, d + s));
                        self.weights[row][column] == *weight
                    });
                    // The mirror of sector 0 takes the angle d + β/2 to α − d − β/2.
                    let mirrored = (2 * n + self.offset(a) - self.offset(b) - d) % n;
                    turned && *self.weight(a, b, mirrored) == *weight
                })
            })
        })
    }

    /// Whether the weights in the points of some orbits, in all sectors, are those of the regular part.
    fn is_regular(&self, orbits: Range<usize>) -> bool {
        let order = i32::try_from(self.order).unwrap_or(i32::MAX);
        let places = self.part.places();
        for (a, s) in orbits.flat_map(|a| (0..self.order).map(move |s| (a, s))) {
            let mut row = vec![int(0); self.weights.len()];
            for (place, weight) in self.part.rule(places[a]) {
                let (home, turns) = self.part.turned(place);
                let Some(orbit) =
                    places[..self.orbits.len()].iter().position(|known| *known == home)
                else {
                    return false;
                };
                let sector = usize::try_from(turns.rem_euclid(order)).unwrap_or(0);
                row[self.point(orbit, sector + s)] += weight;
            }
            let own = &self.weights[self.point(a, s)];
            if !row.into_iter().zip(own).all(|(regular, own)| Value::from(regular) == *own) {
                return false;
            }
        }
        true
    }

    /// Whether the rules are those of the points of a lattice, around the vertex too (THEOREMS.md, 143).
    pub fn is_regular_part(&self) -> bool {
        self.part.valence() == Some(self.order) && self.is_regular(0..self.orbits.len())
    }

    /// Block k in real form: the entries Σ_d m_{(a,0),(b,d)} cos(2πk(d + β/2 − α/2)/n), of all orbits for k = 0, otherwise of
    /// those of n points. It is similar to the Fourier block.
    pub fn block(&self, k: usize) -> Result<Vec<Vec<Ball>>, Stop> {
        let orbits = || (0..self.orbits.len()).filter(|&a| k == 0 || self.orbits[a].1 > 1);
        let entry = |(a, b): (usize, usize)| -> Result<Ball, Stop> {
            let mut sum = Ball::from(0);
            for d in 0..self.orbits[b].1 {
                let weight = self.weight(a, b, d);
                if !weight.is_zero() {
                    let angle = count(2 * d + self.offset(b)) - count(self.offset(a));
                    let turn = angle * count(k) / count(2 * self.order);
                    sum = sum.plus(&Ball::of(weight.number()?)?.times(&cosine(&turn)?));
                }
            }
            Ok(sum)
        };
        orbits().map(|a| orbits().map(|b| entry((a, b))).collect()).collect()
    }

    /// cos(2πk/n).
    pub fn cosine(&self, k: usize) -> Result<Ball, Stop> {
        cosine(&(count(k) / count(self.order)))
    }

    /// cos(πk/n).
    pub fn half_cosine(&self, k: usize) -> Result<Ball, Stop> {
        cosine(&(count(k) / count(2 * self.order)))
    }
}
