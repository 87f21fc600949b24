//! The edges and faces of cells.

use super::cube::{EDGES, FACES, edge_between};
use super::error::SolidError;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// A face of one cell or two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Face {
    /// Its corners, counter-clockwise from outside its first cell.
    pub(crate) corners: [usize; 4],
    /// Its edges: edge i is from its corner i to the next one.
    pub(crate) edges: [usize; 4],
    /// Its first cell, and which face of that cell it is.
    pub(crate) cell: (usize, usize),
    /// The same of the other cell; `None` at the boundary.
    pub(crate) other: Option<(usize, usize)>,
}

/// Cells on the points 0, …, n − 1 with their edges and faces: any part of a solid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Complex {
    pub(crate) points: usize,
    /// The corners of the cells, in the order of [`cube`](super::cube).
    pub(crate) cells: Vec<[usize; 8]>,
    /// The edges, in the order in which the cells have them first.
    pub(crate) edges: Vec<[usize; 2]>,
    pub(crate) faces: Vec<Face>,
    pub(crate) cell_edges: Vec<[usize; 12]>,
    pub(crate) cell_faces: Vec<[usize; 6]>,
}

impl Complex {
    /// # Errors
    /// When a cell has a corner twice or one that does not exist, or two cells do not fit at a face.
    pub(crate) fn new(points: usize, cells: Vec<[usize; 8]>) -> Result<Complex, SolidError> {
        for (cell, corners) in cells.iter().enumerate() {
            check_cell(cell, corners, points)?;
        }
        let mut complex = Complex {
            points,
            edges: Vec::new(),
            faces: Vec::new(),
            cell_edges: Vec::with_capacity(cells.len()),
            cell_faces: Vec::with_capacity(cells.len()),
            cells,
        };
        complex.find_edges();
        complex.find_faces()?;
        Ok(complex)
    }

    fn find_edges(&mut self) {
        let mut known: HashMap<[usize; 2], usize> = HashMap::new();
        for corners in &self.cells {
            let edges = &mut self.edges;
            let number = |ends: [usize; 2]| {
                let [from, to] = ends.map(|end| corners[end]);
                *known.entry([from.min(to), from.max(to)]).or_insert_with(|| {
                    edges.push([from, to]);
                    edges.len() - 1
                })
            };
            self.cell_edges.push(EDGES.map(number));
        }
    }

    fn find_faces(&mut self) -> Result<(), SolidError> {
        let mut known: HashMap<[usize; 4], usize> = HashMap::new();
        for (cell, points) in self.cells.iter().enumerate() {
            let mut own = [0; 6];
            for (face, local) in FACES.iter().enumerate() {
                let corners = local.map(|corner| points[corner]);
                let mut sorted = corners;
                sorted.sort_unstable();
                own[face] = match known.entry(sorted) {
                    Entry::Vacant(free) => {
                        let edge = |i: usize| edge_between(local[i], local[(i + 1) % 4]);
                        let edges = [0, 1, 2, 3].map(|i| self.cell_edges[cell][edge(i)]);
                        self.faces.push(Face { corners, edges, cell: (cell, face), other: None });
                        *free.insert(self.faces.len() - 1)
                    }
                    Entry::Occupied(found) => {
                        let index = *found.get();
                        join(&mut self.faces[index], corners, (cell, face))?;
                        index
                    }
                };
            }
            self.cell_faces.push(own);
        }
        Ok(())
    }

    /// The other cell at a face of a cell.
    pub(crate) fn across(&self, cell: usize, face: usize) -> Option<usize> {
        let shared = &self.faces[self.cell_faces[cell][face]];
        if shared.cell == (cell, face) {
            shared.other.map(|(other, _)| other)
        } else {
            Some(shared.cell.0)
        }
    }

    /// Which points are at the boundary, and which edges.
    pub(crate) fn boundary(&self) -> (Vec<bool>, Vec<bool>) {
        let (mut points, mut edges) = (vec![false; self.points], vec![false; self.edges.len()]);
        for face in self.faces.iter().filter(|face| face.other.is_none()) {
            face.corners.iter().for_each(|&point| points[point] = true);
            face.edges.iter().for_each(|&edge| edges[edge] = true);
        }
        (points, edges)
    }
}

fn check_cell(cell: usize, corners: &[usize; 8], points: usize) -> Result<(), SolidError> {
    if let Some(&point) = corners.iter().find(|point| **point >= points) {
        return Err(SolidError::NoPoint { cell, point, count: points });
    }
    let mut sorted = *corners;
    sorted.sort_unstable();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(SolidError::Twice { cell, point: pair[0] }),
        None => Ok(()),
    }
}

/// Gives a face its second cell, which has its corners in the opposite order.
fn join(face: &mut Face, corners: [usize; 4], second: (usize, usize)) -> Result<(), SolidError> {
    let (cell, first) = (second.0, face.cell.0);
    if face.other.is_some() {
        return Err(SolidError::ThirdCell { corners, cell, first });
    }
    let start = corners.iter().position(|point| *point == face.corners[0]).unwrap_or(0);
    let turned = |step: usize| [0, 1, 2, 3].map(|i| corners[(start + step * i) % 4]);
    if turned(3) == face.corners {
        face.other = Some(second);
        Ok(())
    } else if turned(1) == face.corners {
        Err(SolidError::Orientation { corners, cell, first })
    } else {
        Err(SolidError::Twisted { corners, cell, first })
    }
}
