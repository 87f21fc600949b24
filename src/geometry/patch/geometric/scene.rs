//! A mesh of a level, or a part of it, with its pieces of the limit.

use super::super::number::Vector as _;
use super::patch::length;
use super::pieces::{Unit, Units};
use super::place::SetKind;
use super::shadow::Segment;
use crate::grouped::Grouped;
use crate::mesh::Point;
use std::collections::HashMap;
use std::sync::OnceLock;

/// The mesh with its units.
pub(crate) struct Scene<P> {
    pub(crate) pieces: P,
    pub(crate) units: Vec<Unit>,
    /// The units at each corner.
    at_corner: Grouped<usize>,
    /// How far lengths may be off.
    pub(super) slack: f64,
    moved: Vec<OnceLock<f64>>,
}

/// Units with the boundary of what they make up.
pub(super) struct Ring {
    pub(super) units: Vec<usize>,
    pub(super) boundary: Vec<Segment>,
}

impl<P: Units> Scene<P> {
    pub(crate) fn new(pieces: P, units: Vec<Unit>, slack: f64) -> Scene<P> {
        let count = units.iter().flat_map(|unit| &unit.corners).max().map_or(0, |most| most + 1);
        let corners = units.iter().enumerate();
        let corners =
            corners.flat_map(|(number, unit)| unit.corners.iter().map(move |&at| (at, number)));
        let at_corner = Grouped::new(count, corners);
        let moved = units.iter().map(|_| OnceLock::new()).collect();
        Scene { pieces, units, at_corner, slack, moved }
    }

    pub(super) fn is_near_by_parameter(&self, unit: usize) -> bool {
        self.pieces.is_near_by_parameter(unit, &self.units[unit])
    }

    fn moved(&self, unit: usize) -> f64 {
        *self.moved[unit].get_or_init(|| self.pieces.moved(unit, &self.units[unit]))
    }

    /// The units that are so many steps away, from corner to corner.
    pub(super) fn ring(&self, unit: usize, steps: usize) -> Ring {
        let mut units = vec![unit];
        let mut begin = 0;
        for _ in 0..steps {
            let end = units.len();
            for at in begin..end {
                for corner in &self.units[units[at]].corners {
                    for &other in self.at_corner.of(*corner) {
                        if !units.contains(&other) {
                            units.push(other);
                        }
                    }
                }
            }
            begin = end;
        }
        // A segment between two of them is met once in each direction.
        let mut segments: HashMap<[usize; 2], Segment> = HashMap::new();
        for &unit in &units {
            let Unit { corners, base, .. } = &self.units[unit];
            for i in 0..corners.len() {
                let next = (i + 1) % corners.len();
                let key = [corners[i], corners[next]];
                if segments.remove(&[key[1], key[0]]).is_none() {
                    let ends = [base[i], base[next]];
                    let moved = self.moved(unit) + self.slack;
                    segments.insert(key, Segment { ends, moved });
                }
            }
        }
        let mut boundary: Vec<([usize; 2], Segment)> = segments.into_iter().collect();
        boundary.sort_by_key(|(key, _)| *key);
        Ring { units, boundary: boundary.into_iter().map(|(_, segment)| segment).collect() }
    }

    /// The points of a unit that are tried first: limits at its corners, corners of its mesh.
    pub(super) fn unit_points(&self, unit: usize) -> Vec<(Point<f64>, SetKind)> {
        let hull = self.pieces.hull(&self.pieces.piece(unit));
        let limits = hull.limits.into_iter().map(|point| (point, SetKind::Limit));
        let corners = self.units[unit].base.iter().map(|point| (*point, SetKind::Mesh));
        limits.chain(corners).collect()
    }

    /// A point of the other set that is near, among a few of the unit.
    pub(super) fn near(&self, unit: usize, point: &Point<f64>, from: SetKind) -> Point<f64> {
        let distance = |other: &Point<f64>| length(&other.minus(point));
        let others: Vec<Point<f64>> = match from {
            SetKind::Limit => self.units[unit].patches.iter().map(|x| x.near(point)).collect(),
            SetKind::Mesh => {
                let points = self.unit_points(unit).into_iter();
                points.filter(|(_, of)| *of == SetKind::Limit).map(|(point, _)| point).collect()
            }
        };
        let nearest = others.into_iter().min_by(|x, y| distance(x).total_cmp(&distance(y)));
        nearest.unwrap_or(*point)
    }
}
