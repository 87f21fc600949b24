//! Bajaj's scheme: every hexahedron is divided into eight, then every point is moved to the mean of
//! the centroids around it.

use super::average::refined_points;
use super::complex::Complex;
use super::cube::{Middle, middle};
use super::error::SolidError;
use super::hexes::HexMesh;
use super::{MAX_POINTS, MAX_SOLID_LEVEL};
use crate::exact::Rational;
use std::borrow::Cow;

/// The most binary digits of all coordinates of a refined mesh together.
const MAX_BITS: u64 = 4_000_000_000;

/// The mesh after `level` levels of Bajaj's scheme (Bajaj, Schaefer, Warren and Xu 2002).
///
/// Each hexahedron is divided at the middles of its edges, the centroids of its faces and its own. Each of
/// these points, and each vertex, moves to the mean of the centroids of the new hexahedra that have
/// it; at the boundary, of the new quadrilaterals of the boundary that have it. The points of the next
/// level are the vertices, the edges, the faces and the cells, in this order. Cell 8c + i is the part
/// of cell c at its corner i; corner i is at (i & 1, i >> 1 & 1, i >> 2) of the cell.
///
/// # Errors
/// When the level is above [`MAX_SOLID_LEVEL`], or there would be too many points, or too long numbers.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, refine_solid};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// let refined = refine_solid(&mesh, 1)?;
/// // Three quadrilaterals of the boundary have their centroids a quarter away in two directions.
/// assert_eq!((refined.points().len(), refined.cells().len()), (27, 8));
/// assert_eq!(refined.points()[0], [1, 1, 1].map(|p| Rational::new(p, 6)));
/// # Ok::<(), subcert::solid::SolidError>(())
/// ```
pub fn refine_solid(mesh: &HexMesh<Rational>, level: u32) -> Result<HexMesh<Rational>, SolidError> {
    if level > MAX_SOLID_LEVEL {
        let reason = format!("level {level} is too high; at most {MAX_SOLID_LEVEL} is");
        return Err(SolidError::TooMuch { reason });
    }
    let points = count(mesh.complex(), level);
    if points > MAX_POINTS {
        return Err(SolidError::TooManyPoints { points });
    }
    let mut refined = Cow::Borrowed(mesh);
    for _ in 0..level {
        check_bits(&refined)?;
        let points = refined_points(refined.complex(), refined.points());
        let cells = refined_cells(refined.complex());
        let complex = Complex::new(points.len(), cells)?;
        refined = Cow::Owned(HexMesh::refined(points, complex));
    }
    Ok(refined.into_owned())
}

/// The number of points after `level` levels.
fn count(complex: &Complex, level: u32) -> usize {
    let (mut points, mut edges) = (complex.points, complex.edges.len());
    let (mut faces, mut cells) = (complex.faces.len(), complex.cells.len());
    // Each number grows at most by a factor of 8, so that 12 levels of 2^24 do not overflow.
    for _ in 0..level {
        points += edges + faces + cells;
        edges = 2 * edges + 4 * faces + 6 * cells;
        faces = 4 * faces + 12 * cells;
        cells *= 8;
    }
    points
}

/// Refuses points of too long numbers: as many as one level has, each as long as the longest.
pub(crate) fn check_bits(mesh: &HexMesh<Rational>) -> Result<(), SolidError> {
    let bits = |x: &Rational| x.numerator().bits().max(x.denominator().bits());
    let longest = mesh.points().iter().flatten().map(bits).max().unwrap_or(0);
    let count = u64::try_from(count(mesh.complex(), 1)).unwrap_or(u64::MAX);
    if longest.saturating_mul(3 * count) > MAX_BITS {
        let reason = format!(
            "{count} points with coordinates of up to {longest} binary digits are too many; take a \
             lower level, or round the coordinates"
        );
        return Err(SolidError::TooMuch { reason });
    }
    Ok(())
}

/// The number of a point of the next level.
fn number(complex: &Complex, cell: usize, middle: Middle) -> usize {
    let (vertices, edges, faces) = (complex.points, complex.edges.len(), complex.faces.len());
    match middle {
        Middle::Corner(corner) => complex.cells[cell][corner],
        Middle::Edge(edge) => vertices + complex.cell_edges[cell][edge],
        Middle::Face(face) => vertices + edges + complex.cell_faces[cell][face],
        Middle::Cell => vertices + edges + faces + cell,
    }
}

/// The corners of part `part` of a cell, in the next level.
pub(crate) fn part_corners(complex: &Complex, cell: usize, part: usize) -> [usize; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| number(complex, cell, middle(part, corner)))
}

/// The cells of the next level.
pub(super) fn refined_cells(complex: &Complex) -> Vec<[usize; 8]> {
    let parts = (0..complex.cells.len()).flat_map(|cell| (0..8).map(move |part| (cell, part)));
    parts.map(|(cell, part)| part_corners(complex, cell, part)).collect()
}
