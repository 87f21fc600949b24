//! Limit points of vertices.

use super::complex::Complex;
use super::hexes::HexMesh;
use crate::exact::Rational;
use crate::mesh::{Point, combination};

/// The limit point of every vertex of a hexahedral mesh under Bajaj's scheme.
///
/// Inside it is the mean, over the cells of the vertex, of their trilinear interpolants at a third of
/// the way from the vertex in each direction: Σ (8v + 4Σe + 2Σf + c)/27 over the cells, with the
/// neighbours e of v in the cell, the opposite corners f of its faces, and its opposite corner c. At
/// the boundary it is the mean of the bilinear interpolants of the faces there: Σ (4v + 2Σe + f)/9.
///
/// Source: `proofs/THEOREMS.md`, 100.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, solid_limit_points};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// // Three squares at the vertex: a third of two of the coordinates in each.
/// let limit = &solid_limit_points(&mesh)[0];
/// assert_eq!(*limit, [2, 2, 2].map(|p| Rational::new(p, 9)));
/// # Ok::<(), subcert::solid::SolidError>(())
/// ```
#[must_use]
pub fn solid_limit_points(mesh: &HexMesh<Rational>) -> Vec<Point<Rational>> {
    let point = |row: Vec<(usize, Rational)>| {
        combination(row.iter().map(|(point, weight)| (weight, &mesh.points()[*point])))
    };
    let vertices: Vec<usize> = (0..mesh.points().len()).collect();
    limit_rows(mesh.complex(), &vertices).into_iter().map(point).collect()
}

/// The weights of the limit points of these vertices, some points more than once. Of a part of a solid,
/// those of vertices are right of which all cells are there.
pub(crate) fn limit_rows(complex: &Complex, vertices: &[usize]) -> Vec<Vec<(usize, Rational)>> {
    let (boundary, _) = complex.boundary();
    let mut rows: Vec<Vec<(usize, Rational)>> = vec![Vec::new(); complex.points];
    let mut counts = vec![0_usize; complex.points];
    let mut wanted = vec![false; complex.points];
    for &vertex in vertices {
        wanted[vertex] = true;
    }
    for corners in &complex.cells {
        for (i, &vertex) in corners.iter().enumerate() {
            if wanted[vertex] && !boundary[vertex] {
                counts[vertex] += 1;
                let weight = |j: usize| Rational::new(8 >> (i ^ j).count_ones(), 27);
                rows[vertex].extend((0..8).map(|j| (corners[j], weight(j))));
            }
        }
    }
    for face in complex.faces.iter().filter(|face| face.other.is_none()) {
        for (i, &vertex) in face.corners.iter().enumerate() {
            if wanted[vertex] {
                counts[vertex] += 1;
                let weights = [4, 2, 1, 2].map(|weight| Rational::new(weight, 9));
                let weighted = weights.into_iter().enumerate();
                rows[vertex]
                    .extend(weighted.map(|(j, weight)| (face.corners[(i + j) % 4], weight)));
            }
        }
    }
    let mean = |&vertex: &usize| {
        let share = Rational::new(1, counts[vertex].max(1));
        let row = std::mem::take(&mut rows[vertex]);
        row.into_iter().map(|(point, weight)| (point, &weight * &share)).collect()
    };
    vertices.iter().map(mean).collect()
}
