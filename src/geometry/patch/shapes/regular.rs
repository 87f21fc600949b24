//! Regular pieces: where their points are, and the second differences that bound them.
//!
//! At a smooth boundary points are added outside, which the rules of the boundary continue:
//! 2v − e for Catmull–Clark, v + w − a for Loop (`proofs/THEOREMS.md`, 92).

use crate::exact::Rational;
use crate::mesh::{Connectivity, MeshScheme, Star};
use crate::patch::number::{Number, Row, index};
use std::collections::BTreeMap;

/// A point of a grid or of a triangular lattice.
pub(super) type Place = (i32, i32);

/// The points of a regular piece by their places: rows over the points of the neighbourhood.
pub(super) struct Layout<W> {
    pub(crate) scheme: MeshScheme,
    pub(super) at: BTreeMap<Place, Row<W>>,
}

/// Second differences, as rows: in each direction, and (Loop) across edges.
#[derive(Clone, Debug)]
pub(crate) struct Bends<W> {
    pub(crate) directions: Vec<Vec<Row<W>>>,
    pub(crate) across: Vec<Row<W>>,
}

/// The directions of the triangular lattice, counter-clockwise.
const LATTICE: [Place; 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];

/// The corners of the four quadrilaterals around the point (1, 1), of which the first is between (2, 1)
/// and (1, 2).
const AROUND_CORNER: [[Place; 4]; 4] = [
    [(1, 1), (2, 1), (2, 2), (1, 2)],
    [(1, 1), (1, 2), (0, 2), (0, 1)],
    [(1, 1), (0, 1), (0, 0), (1, 0)],
    [(1, 1), (1, 0), (2, 0), (2, 1)],
];

/// The same from the quadrilateral at (0, 0) on, which is corner 0 of a piece around a vertex; corner 1 is
/// at (2, 0).
const AROUND_CENTRE: [[Place; 4]; 4] = [
    [(1, 1), (0, 1), (0, 0), (1, 0)],
    [(1, 1), (1, 0), (2, 0), (2, 1)],
    [(1, 1), (2, 1), (2, 2), (1, 2)],
    [(1, 1), (1, 2), (0, 2), (0, 1)],
];

/// Σ of rows with factors, sorted by point.
pub(super) fn weighted<W: Number>(terms: &[(W, &Row<W>)]) -> Row<W> {
    let mut sum: BTreeMap<u32, W> = BTreeMap::new();
    for (factor, row) in terms {
        for (index, weight) in *row {
            let term = factor.times(weight);
            sum.entry(*index).and_modify(|total| total.accumulate(&term)).or_insert(term);
        }
    }
    sum.into_iter().filter(|(_, weight)| !weight.vanishes()).collect()
}

/// p/q.
pub(crate) fn number<W: Number>(p: i64, q: i64) -> W {
    W::from_rational(&Rational::new(p, q))
}

fn one<W: Number>(point: usize) -> Row<W> {
    vec![(index(point), number(1, 1))]
}

impl<W: Number> Layout<W> {
    /// The places of the points of a piece on `corners` points; `None` where it is not regular.
    pub(crate) fn of(
        scheme: MeshScheme,
        connectivity: &Connectivity,
        corners: usize,
    ) -> Option<Layout<W>> {
        let mut layout = Layout { scheme, at: BTreeMap::new() };
        match scheme {
            MeshScheme::CatmullClark | MeshScheme::Bajaj => {
                (corners == 4).then_some(())?;
                (0..4).try_for_each(|i| layout.grid_corner(connectivity, i))?;
            }
            MeshScheme::DooSabin => layout.grid_centre(connectivity)?,
            MeshScheme::Loop | MeshScheme::LoopWarren => {
                (0..3).try_for_each(|i| layout.lattice_corner(connectivity, i))?;
            }
        }
        Some(layout)
    }

    fn put(&mut self, place: Place, point: usize) {
        self.at.entry(place).or_insert_with(|| one(point));
    }

    /// Σ of the points at these places, put at another place.
    fn put_sum(&mut self, place: Place, terms: &[(i64, Place)]) {
        let rows: Vec<(W, &Row<W>)> =
            terms.iter().map(|(factor, place)| (number(*factor, 1), &self.at[place])).collect();
        let row = weighted(&rows);
        self.at.entry(place).or_insert(row);
    }

    /// The 3 × 3 points around corner i of a quadrilateral.
    fn grid_corner(&mut self, connectivity: &Connectivity, i: usize) -> Option<()> {
        let turn = |(a, b): Place| match i {
            0 => (a, b),
            1 => (3 - b, a),
            2 => (3 - a, 3 - b),
            _ => (b, 3 - a),
        };
        let star = connectivity.star(i);
        let own = star.faces.iter().position(|&face| face == 0)?;
        if star.faces.len() != if star.boundary { 2 } else { 4 } {
            return None;
        }
        for r in 0..star.faces.len() {
            let vertices = &connectivity.faces()[star.faces[r]];
            if vertices.len() != 4 {
                return None;
            }
            for (k, &place) in AROUND_CORNER[(r + 4 - own) % 4].iter().enumerate() {
                self.put(turn(place), vertices[(star.corners[r] + k) % 4]);
            }
        }
        if star.boundary {
            for a in 0..3 {
                // The row or column beyond the boundary.
                let [out, edge, inside] =
                    [0, 1, 2].map(|b| turn(if own == 0 { (a, b) } else { (b, a) }));
                self.put_sum(out, &[(2, edge), (-1, inside)]);
            }
        }
        Some(())
    }

    /// The 3 × 3 points of the four quadrilaterals around a vertex; the corners of the piece are in
    /// the directions of the faces.
    fn grid_centre(&mut self, connectivity: &Connectivity) -> Option<()> {
        let star = from_first(connectivity, 0);
        if star.faces.len() != 4 {
            return None;
        }
        for (r, places) in AROUND_CENTRE.iter().enumerate() {
            let vertices = &connectivity.faces()[star.faces[r]];
            if vertices.len() != 4 {
                return None;
            }
            for (k, &place) in places.iter().enumerate() {
                self.put(place, vertices[(star.corners[r] + k) % 4]);
            }
        }
        Some(())
    }

    /// The six points around corner i of a triangle.
    fn lattice_corner(&mut self, connectivity: &Connectivity, i: usize) -> Option<()> {
        let centre = [(0, 0), (1, 0), (0, 1)][i];
        let star = connectivity.star(i);
        let own = star.faces.iter().position(|&face| face == 0)?;
        if star.faces.len() != if star.boundary { 3 } else { 6 } {
            return None;
        }
        let place = |r: usize| {
            let (a, b) = LATTICE[(2 * i + r + 6 - own) % 6];
            (centre.0 + a, centre.1 + b)
        };
        self.put(centre, i);
        for (r, &point) in star.neighbours.iter().enumerate() {
            self.put(place(r), point);
        }
        if star.boundary {
            self.put_sum(place(4), &[(1, centre), (1, place(3)), (-1, place(2))]);
            self.put_sum(place(5), &[(1, centre), (1, place(0)), (-1, place(1))]);
        }
        Some(())
    }

    fn sum(&self, terms: &[(i64, Place)]) -> Option<Row<W>> {
        let mut rows = Vec::with_capacity(terms.len());
        for (factor, place) in terms {
            rows.push((number(*factor, 1), self.at.get(place)?));
        }
        Some(weighted(&rows))
    }

    /// The second differences.
    pub(super) fn bends(&self) -> Bends<W> {
        let directions: &[Place] = match self.scheme {
            MeshScheme::CatmullClark | MeshScheme::Bajaj | MeshScheme::DooSabin => {
                &[(1, 0), (0, 1)]
            }
            MeshScheme::Loop | MeshScheme::LoopWarren => &LATTICE[..3],
        };
        let straight = |&(a, b): &Place| {
            let bend = |&(x, y): &Place| {
                self.sum(&[(1, (x - a, y - b)), (-2, (x, y)), (1, (x + a, y + b))])
            };
            self.at.keys().filter_map(bend).collect()
        };
        let mut across = Vec::new();
        if directions.len() == 3 {
            for &(x, y) in self.at.keys() {
                for r in 0..3 {
                    let [wing, (a, b), other] =
                        [(r + 5) % 6, r, r + 1].map(|r| (x + LATTICE[r].0, y + LATTICE[r].1));
                    let terms = [(1, (x, y)), (1, (a, b)), (-1, wing), (-1, other)];
                    across.extend(self.sum(&terms));
                }
            }
        }
        Bends { directions: directions.iter().map(straight).collect(), across }
    }
}

/// The star of a vertex from the first face on.
pub(super) fn from_first(connectivity: &Connectivity, vertex: usize) -> Star {
    let mut star = connectivity.star(vertex);
    let start = star.faces.iter().position(|&face| face == 0).unwrap_or(0);
    if !star.boundary {
        star.neighbours.rotate_left(start);
        star.edges.rotate_left(start);
        star.faces.rotate_left(start);
        star.corners.rotate_left(start);
    }
    star
}
