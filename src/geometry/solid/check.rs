//! Whether cells make up a solid with a boundary surface.

use super::complex::Complex;
use super::error::SolidError;
use super::{MAX_CELLS_AT_POINT, MAX_POINTS};

/// Checks that the cells around every point fill a ball, or at the boundary a part of one that is
/// bounded by a disc.
///
/// The cells, faces and edges at a point are the triangles, edges and vertices of a surface around it.
/// The triangles hang together by their edges, and V − E + F is 2 (a sphere), or 1 where there is a
/// boundary (a disc). A surface that touches itself at vertices has less: separated there, each
/// vertex more would raise V − E + F above 2, or above 1 with a boundary.
pub(super) fn check(complex: &Complex) -> Result<(), SolidError> {
    if complex.points > MAX_POINTS {
        return Err(SolidError::TooManyPoints { points: complex.points });
    }
    if complex.cells.is_empty() {
        return Err(SolidError::Empty);
    }
    let mut characters = vec![0_i64; complex.points];
    for &point in complex.edges.iter().flatten() {
        characters[point] += 1;
    }
    for &point in complex.faces.iter().flat_map(|face| &face.corners) {
        characters[point] -= 1;
    }
    let mut first = vec![usize::MAX; complex.points];
    let mut counts = vec![0_usize; complex.points];
    for (cell, corners) in complex.cells.iter().enumerate() {
        for &point in corners {
            characters[point] += 1;
            counts[point] += 1;
            first[point] = first[point].min(cell);
        }
    }
    let (boundary, _) = complex.boundary();
    for point in 0..complex.points {
        let cells = counts[point];
        if cells == 0 {
            return Err(SolidError::Isolated { point });
        }
        if cells > MAX_CELLS_AT_POINT {
            return Err(SolidError::Crowded { point, cells });
        }
        let whole = characters[point] == if boundary[point] { 1 } else { 2 };
        if !whole || reached(complex, point, first[point]) != cells {
            return Err(SolidError::Loose { point, cell: first[point] });
        }
    }
    Ok(())
}

/// How many cells at a point are reached from one through faces at the point.
fn reached(complex: &Complex, point: usize, start: usize) -> usize {
    let mut met = vec![start];
    let mut next = 0;
    while let Some(&cell) = met.get(next) {
        next += 1;
        for (face, &number) in complex.cell_faces[cell].iter().enumerate() {
            if complex.faces[number].corners.contains(&point) {
                let other = complex.across(cell, face);
                met.extend(other.filter(|other| !met.contains(other)));
            }
        }
    }
    met.len()
}
