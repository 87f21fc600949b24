//! Points and cells.

use super::check::check;
use super::complex::Complex;
use super::cube::FILE_ORDER;
use super::error::SolidError;
use crate::mesh::{MeshError, Point, PolygonMesh};
use std::collections::BTreeSet;

/// The boundary of a hexahedral mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidBoundary<S> {
    /// The faces of one cell, counter-clockwise from outside, cell by cell, as `boundary_faces` has them.
    pub mesh: PolygonMesh<S>,
    /// The numbers of its points in the solid, in ascending order.
    pub points: Vec<usize>,
    /// The cell of each face.
    pub cells: Vec<usize>,
}

/// A hexahedral mesh: points of space, and hexahedra on them that make up a solid.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::HexMesh;
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// assert_eq!(mesh.boundary_faces().len(), 6);
/// assert_eq!(mesh.cells(), [[0, 1, 3, 2, 4, 5, 7, 6]]);
/// # Ok::<(), subcert::solid::SolidError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HexMesh<S> {
    points: Vec<Point<S>>,
    complex: Complex,
}

impl<S> HexMesh<S> {
    /// The mesh of these points and cells. A cell has its corners in the order of VTK and MEDIT:
    /// around the bottom, then around the top, each above one of the bottom.
    ///
    /// # Errors
    /// When there is no cell, or there are more than [`MAX_POINTS`](super::MAX_POINTS) points; when a
    /// cell has a corner twice, or one that does not exist; when a face has three cells, or two that do
    /// not fit or are on the same side of it; when the cells of a point fill no ball, and at the
    /// boundary no part of one bounded by a disc; when a point is in no cell or in more than
    /// [`MAX_CELLS_AT_POINT`](super::MAX_CELLS_AT_POINT).
    pub fn new(points: Vec<Point<S>>, cells: &[[usize; 8]]) -> Result<Self, SolidError> {
        let cells = cells.iter().map(|cell| FILE_ORDER.map(|corner| cell[corner])).collect();
        let complex = Complex::new(points.len(), cells)?;
        check(&complex)?;
        Ok(HexMesh { points, complex })
    }

    /// A mesh that is a solid because it refines one.
    pub(super) fn refined(points: Vec<Point<S>>, complex: Complex) -> Self {
        HexMesh { points, complex }
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[Point<S>] {
        &self.points
    }

    /// The cells, each with its corners in the order of VTK and MEDIT.
    #[must_use]
    pub fn cells(&self) -> Vec<[usize; 8]> {
        let cells = self.complex.cells.iter();
        cells.map(|corners| FILE_ORDER.map(|corner| corners[corner])).collect()
    }

    /// The corners of the faces of one cell, counter-clockwise from outside.
    #[must_use]
    pub fn boundary_faces(&self) -> Vec<[usize; 4]> {
        let boundary = self.complex.faces.iter().filter(|face| face.other.is_none());
        boundary.map(|face| face.corners).collect()
    }

    /// The boundary as a closed surface of quadrilaterals.
    ///
    /// Bajaj's scheme refines it as the scheme [`Bajaj`](crate::mesh::MeshScheme::Bajaj) refines
    /// polygon meshes: its points do not depend on those inside.
    ///
    /// # Errors
    /// When all faces have two cells, as those of a hypercube: there is no boundary.
    ///
    /// # Panics
    /// Never: all points of a face of the boundary are points of the boundary.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::solid::HexMesh;
    ///
    /// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
    /// let cube = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
    /// let boundary = cube.boundary()?;
    /// assert_eq!((boundary.mesh.faces().len(), boundary.cells[5]), (6, 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn boundary(&self) -> Result<SolidBoundary<S>, MeshError>
    where
        S: Clone,
    {
        let outer = self.complex.faces.iter().filter(|face| face.other.is_none());
        let (corners, cells): (Vec<[usize; 4]>, Vec<usize>) =
            outer.map(|face| (face.corners, face.cell.0)).unzip();
        let points: Vec<usize> =
            corners.iter().flatten().copied().collect::<BTreeSet<usize>>().into_iter().collect();
        let number = |point: &usize| points.binary_search(point).expect("a point of the boundary");
        let faces = corners.iter().map(|face| face.iter().map(number).collect()).collect();
        let own = points.iter().map(|&point| self.points[point].clone()).collect();
        let mesh = PolygonMesh::new(own, faces)?;
        Ok(SolidBoundary { mesh, points, cells })
    }

    /// The ends of the edges.
    #[must_use]
    pub fn edges(&self) -> &[[usize; 2]] {
        &self.complex.edges
    }

    pub(crate) fn complex(&self) -> &Complex {
        &self.complex
    }

    /// The same mesh with coordinates of another kind.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> HexMesh<T> {
        let points = self.points.iter().map(|point| point.each_ref().map(&mut map)).collect();
        HexMesh { points, complex: self.complex.clone() }
    }

    /// The same cells on other points.
    ///
    /// # Panics
    /// When there are not as many.
    #[must_use]
    pub fn with_points<T>(&self, points: Vec<Point<T>>) -> HexMesh<T> {
        assert_eq!(points.len(), self.points.len(), "a point for each point");
        HexMesh { points, complex: self.complex.clone() }
    }
}
