//! The regular parts: lattices, and the rules that their directions give.

use crate::numbers::{Q, int};
use num_traits::Zero;
use std::collections::BTreeMap;

/// A place of a lattice: as seen from sector 0.
pub type Place = (i32, i32);

/// A regular part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The vertex is at (0, 0); a sector has the places (a, b), a ≥ 1, b ≥ 0.
    Bicubic,
    /// As before; the places (1, 0) and (0, 1) are neighbours.
    BoxSpline,
    /// A sector has the places (a, b), a, b ≥ 0, and (0, 0) is its corner of the face.
    Biquadratic,
}

impl Part {
    /// The part of a ring with these orbits.
    pub fn of_orbits(names: &[&str]) -> Option<Part> {
        match names {
            ["vertex", "edge", "face"] => Some(Part::Bicubic),
            ["vertex", "edge"] => Some(Part::BoxSpline),
            ["face"] => Some(Part::Biquadratic),
            _ => None,
        }
    }

    /// The part of a ring whose orbits declare the points around those next to the vertex as well.
    pub fn declared_by(names: &[&str]) -> Option<Part> {
        match names {
            ["vertex", "edge", "face", "outer", "left", "right", "corner"] => Some(Part::Bicubic),
            ["vertex", "edge", "corner", "outer"] => Some(Part::BoxSpline),
            _ => None,
        }
    }

    /// The places of sector 0 on which the surface next to the vertex or on the face depends, in the order of the
    /// orbits that may declare them.
    pub fn places(self) -> &'static [Place] {
        match self {
            Part::Bicubic => &[(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (1, 2), (2, 2)],
            Part::BoxSpline => &[(0, 0), (1, 0), (1, 1), (2, 0)],
            Part::Biquadratic => &[(0, 0), (0, 1), (1, 0), (1, 1)],
        }
    }

    /// Its name in certificates.
    pub fn name(self) -> &'static str {
        match self {
            Part::Bicubic => "bicubic",
            Part::BoxSpline => "box-spline",
            Part::Biquadratic => "biquadratic",
        }
    }

    /// The valence of the points of the lattice; `None` around a face.
    pub fn valence(self) -> Option<usize> {
        match self {
            Part::Bicubic => Some(4),
            Part::BoxSpline => Some(6),
            Part::Biquadratic => None,
        }
    }

    /// The directions of the box spline, and the place that its coefficients are counted from.
    fn directions(self) -> (&'static [Place], Place) {
        match self {
            Part::Bicubic => {
                (&[(1, 0), (1, 0), (1, 0), (1, 0), (0, 1), (0, 1), (0, 1), (0, 1)], (2, 2))
            }
            Part::BoxSpline => (&[(1, 0), (1, 0), (0, 1), (0, 1), (-1, 1), (-1, 1)], (0, 2)),
            Part::Biquadratic => (&[(1, 0), (1, 0), (1, 0), (0, 1), (0, 1), (0, 1)], (1, 1)),
        }
    }

    /// The weights of the old places in a new place: the coefficients of 2^{2−d}·Π(1 + z^v) over the d directions v.
    pub fn rule(self, (a, b): Place) -> Vec<(Place, Q)> {
        let (directions, (x, y)) = self.directions();
        let mut mask: BTreeMap<Place, Q> = BTreeMap::from([((0, 0), int(4))]);
        for &(u, v) in directions {
            let mut next: BTreeMap<Place, Q> = BTreeMap::new();
            for ((i, j), c) in mask {
                for place in [(i, j), (i + u, j + v)] {
                    *next.entry(place).or_insert_with(Q::zero) += &c / int(2);
                }
            }
            mask = next;
        }
        // x'_α = Σ a_{α − 2β + s} x_β.
        let mut rule = Vec::new();
        for ((i, j), c) in mask {
            let (p, q) = (a + x - i, b + y - j);
            if p % 2 == 0 && q % 2 == 0 {
                rule.push(((p / 2, q / 2), c));
            }
        }
        rule
    }

    /// The place in sector 0 that a turn by so many sectors takes to this place.
    pub fn turned(self, (mut a, mut b): Place) -> (Place, i32) {
        let mut turns = 0;
        loop {
            let within = match self {
                Part::Biquadratic => a >= 0 && b >= 0,
                _ => (a >= 1 && b >= 0) || (a, b) == (0, 0),
            };
            if within {
                return ((a, b), turns);
            }
            // Back by one sector if b ≥ 0, otherwise on by one.
            let on = b < 0;
            turns += if on { -1 } else { 1 };
            (a, b) = match (self, on) {
                (Part::Bicubic, true) => (-b, a),
                (Part::Bicubic, false) => (b, -a),
                (Part::Biquadratic, true) => (-1 - b, a),
                (Part::Biquadratic, false) => (b, -1 - a),
                (Part::BoxSpline, true) => (-b, a + b),
                (Part::BoxSpline, false) => (a + b, -a),
            };
        }
    }

    /// The places of sector 0 in the inner ring, in the order of the orbits.
    pub fn inner(self) -> &'static [Place] {
        match self {
            Part::Bicubic => &self.places()[..3],
            Part::BoxSpline => &self.places()[..2],
            Part::Biquadratic => &self.places()[..1],
        }
    }

    /// The other places of sector 0 on which the surface next to the vertex or on the face depends.
    pub fn outer(self) -> &'static [Place] {
        &self.places()[self.inner().len()..]
    }
}
