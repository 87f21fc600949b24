//! Points and faces.

use super::connectivity::Connectivity;
use super::error::MeshError;
use super::point::Point;

/// A polygon mesh: points of space, and faces on them.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::PolygonMesh;
///
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|point| point.map(Rational::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// assert_eq!(mesh.connectivity().edges().len(), 3);
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolygonMesh<S> {
    points: Vec<Point<S>>,
    connectivity: Connectivity,
}

impl<S> PolygonMesh<S> {
    /// The mesh of these points and faces.
    ///
    /// # Errors
    /// As [`Connectivity::new`].
    pub fn new(points: Vec<Point<S>>, faces: Vec<Vec<usize>>) -> Result<Self, MeshError> {
        let connectivity = Connectivity::new(points.len(), faces)?;
        Ok(PolygonMesh { points, connectivity })
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[Point<S>] {
        &self.points
    }

    /// The faces, each with its vertices counter-clockwise.
    #[must_use]
    pub fn faces(&self) -> &[Vec<usize>] {
        self.connectivity.faces()
    }

    /// Edges, boundary, and the faces around each point.
    #[must_use]
    pub fn connectivity(&self) -> &Connectivity {
        &self.connectivity
    }

    /// The same mesh with coordinates of another kind.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> PolygonMesh<T> {
        let points = self.points.iter().map(|point| point.each_ref().map(&mut map)).collect();
        PolygonMesh { points, connectivity: self.connectivity.clone() }
    }

    /// The same faces on other points.
    ///
    /// # Panics
    /// When the number of points differs.
    #[must_use]
    pub fn with_points<T>(&self, points: Vec<Point<T>>) -> PolygonMesh<T> {
        assert_eq!(points.len(), self.points.len(), "a point for each point");
        PolygonMesh { points, connectivity: self.connectivity.clone() }
    }
}
