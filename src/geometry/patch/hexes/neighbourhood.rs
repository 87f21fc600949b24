//! The hexahedra around one of the next level, in an order that does not depend on how corners are
//! numbered.

use super::grid::Grid;
use crate::patch::shapes::neighbourhood::{Neighbourhood, Sharp};
use crate::solid::{Complex, FACES, part_corners};

/// Corner j of a hexahedron of a list is its own corner `frame[j]`.
type Frame = [usize; 8];

/// The parts of the cells of a solid: cell 8c + i is that of cell c at its corner i.
pub(super) struct Parts<'a> {
    complex: &'a Complex,
    /// The place of a point or a cell in the list, where its stamp is the present one.
    point_places: Vec<(u32, u32)>,
    cell_stamps: Vec<u32>,
    stamp: u32,
}

impl<'a> Parts<'a> {
    pub(super) fn new(complex: &'a Complex) -> Parts<'a> {
        let points = complex.points + complex.edges.len() + complex.faces.len();
        let cells = complex.cells.len();
        let point_places = vec![(0, 0); points + cells];
        Parts { complex, point_places, cell_stamps: vec![0; 8 * cells], stamp: 0 }
    }

    pub(super) fn corners(&self, part: usize) -> [usize; 8] {
        part_corners(self.complex, part / 8, part % 8)
    }

    /// The part at the other side of a face.
    fn across(&self, part: usize, face: usize) -> Option<usize> {
        let (cell, corner, axis) = (part / 8, part % 8, face / 2);
        if corner >> axis & 1 != face % 2 {
            return Some(8 * cell + (corner ^ (1 << axis)));
        }
        let vertex = self.complex.cells[cell][corner];
        let other = self.complex.across(cell, face)?;
        let corner = self.complex.cells[other].iter().position(|point| *point == vertex)?;
        Some(8 * other + corner)
    }

    /// The parts that share a corner with one, which comes first with its corners in the order of the
    /// frame. Each of the others is met through a face at a corner of the first.
    pub(super) fn around(&mut self, part: usize, frame: &Frame) -> Neighbourhood {
        self.stamp += 1;
        let stamp = self.stamp;
        let mut points = Vec::with_capacity(64);
        let mut key: Vec<u32> = Vec::with_capacity(216);
        let mut met: Vec<(usize, Frame)> = vec![(part, *frame)];
        self.cell_stamps[part] = stamp;
        let mut next = 0;
        while let Some(&(cell, frame)) = met.get(next) {
            next += 1;
            let corners = self.corners(cell);
            let labels = frame.map(|corner| {
                let known = &mut self.point_places[corners[corner]];
                if known.0 != stamp {
                    *known = (stamp, u32::try_from(points.len()).unwrap_or(u32::MAX));
                    points.push(corners[corner]);
                }
                known.1
            });
            key.extend(labels);
            for (face, local) in FACES.iter().enumerate() {
                if local.iter().all(|&corner| labels[corner] >= 8) {
                    continue;
                }
                let side = side_of(local.map(|corner| frame[corner]));
                let other = self.across(cell, side);
                let other = other.filter(|other| self.cell_stamps[*other] != stamp);
                if let Some(other) = other {
                    self.cell_stamps[other] = stamp;
                    met.push((other, self.turned(&corners, other, face, &frame)));
                }
            }
        }
        let faces = key.chunks(8).map(|cell| cell.iter().map(|&label| label as usize).collect());
        Neighbourhood { points, faces: faces.collect(), sharp: Sharp::default(), key }
    }

    /// The frame of the next cell across a face: it is in the same grid.
    fn turned(&self, corners: &[usize; 8], other: usize, face: usize, frame: &Frame) -> Frame {
        let (own, step) = (self.corners(other), 1 << (face / 2));
        let shared = FACES[face].map(|corner| {
            let point = corners[frame[corner]];
            own.iter().position(|known| *known == point).unwrap_or(0)
        });
        let through = 1 << (side_of(shared) / 2);
        let mut next = [0; 8];
        for (corner, place) in FACES[face].into_iter().zip(shared) {
            next[corner ^ step] = place;
            next[corner] = place ^ through;
        }
        next
    }
}

/// The face with these corners.
fn side_of(corners: [usize; 4]) -> usize {
    let (all, any) = corners.iter().fold((7, 0), |(all, any), corner| (all & corner, any | corner));
    let side = usize::from(all != 0);
    let axis = if side == 1 { all } else { !any }.trailing_zeros() as usize;
    2 * axis + side
}

/// The numberings of a cube that keep its edges.
pub(super) fn frames() -> Vec<Frame> {
    let axes = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let frame = |axes: [usize; 3], turned: usize| -> Frame {
        std::array::from_fn(|corner| {
            (0..3).map(|i| (corner >> i & 1) << axes[i]).sum::<usize>() ^ turned
        })
    };
    (0..48).map(|i| frame(axes[i / 8], i % 8)).collect()
}

/// The least of the neighbourhoods of a part in all frames.
pub(super) fn least(parts: &mut Parts<'_>, part: usize) -> Neighbourhood {
    let all = frames();
    let mut best = parts.around(part, &all[0]);
    if is_whole_grid(&best) {
        // It is the same in all frames.
        return best;
    }
    for frame in &all[1..] {
        let other = parts.around(part, frame);
        if other.key < best.key {
            best = other;
        }
    }
    best
}

/// Whether all cells are those of a grid of 3 × 3 × 3.
fn is_whole_grid(neighbourhood: &Neighbourhood) -> bool {
    let corners = |cell: &Vec<usize>| std::array::from_fn(|corner| cell[corner]);
    let cells: Vec<[usize; 8]> = neighbourhood.faces.iter().map(corners).collect();
    cells.len() == 27 && Grid::of(neighbourhood.points.len(), &cells).is_some()
}
