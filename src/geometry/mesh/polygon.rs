//! Points and faces.

use super::connectivity::Connectivity;
use super::crease::Tags;
use super::error::MeshError;
use super::point::Point;
use super::texture::Texture;

/// A polygon mesh: points of space, and faces on them; what is sharp, and texture coordinates.
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
    tags: Tags,
    texture: Option<Texture>,
    isolated: Vec<Point<S>>,
}

impl<S> PolygonMesh<S> {
    /// The mesh of these points and faces.
    ///
    /// # Errors
    /// As [`Connectivity::new`].
    pub fn new(points: Vec<Point<S>>, faces: Vec<Vec<usize>>) -> Result<Self, MeshError> {
        let connectivity = Connectivity::new(points.len(), faces)?;
        let (tags, texture, isolated) = (Tags::default(), None, Vec::new());
        Ok(PolygonMesh { points, connectivity, tags, texture, isolated })
    }

    /// The same mesh with these creases, corners and holes.
    #[must_use]
    pub fn with_tags(self, tags: Tags) -> PolygonMesh<S> {
        PolygonMesh { tags, ..self }
    }

    /// The same mesh with texture coordinates.
    ///
    /// # Errors
    /// When they are for other faces.
    pub fn with_texture(self, texture: Option<Texture>) -> Result<PolygonMesh<S>, MeshError> {
        if let Some(texture) = &texture {
            texture.check(self.faces())?;
        }
        Ok(PolygonMesh { texture, ..self })
    }

    /// The same mesh with these points, which no face has: no rule moves them.
    #[must_use]
    pub fn with_isolated(self, isolated: Vec<Point<S>>) -> PolygonMesh<S> {
        PolygonMesh { isolated, ..self }
    }

    /// The points that no face has. They have no number; files have them after the others.
    #[must_use]
    pub fn isolated(&self) -> &[Point<S>] {
        &self.isolated
    }

    /// The points of faces.
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

    /// Creases, corners and holes.
    #[must_use]
    pub fn tags(&self) -> &Tags {
        &self.tags
    }

    /// The texture coordinates, if there are any.
    #[must_use]
    pub fn texture(&self) -> Option<&Texture> {
        self.texture.as_ref()
    }

    /// The same mesh with coordinates of another kind.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> PolygonMesh<T> {
        let mut all = |points: &[Point<S>]| -> Vec<Point<T>> {
            points.iter().map(|point| point.each_ref().map(&mut map)).collect()
        };
        let isolated = all(&self.isolated);
        self.on(all(&self.points)).with_isolated(isolated)
    }

    fn on<T>(&self, points: Vec<Point<T>>) -> PolygonMesh<T> {
        let (tags, texture) = (self.tags.clone(), self.texture.clone());
        let (connectivity, isolated) = (self.connectivity.clone(), Vec::new());
        PolygonMesh { points, connectivity, tags, texture, isolated }
    }

    /// The same faces on other points, without isolated ones.
    ///
    /// # Panics
    /// When the number of points differs.
    #[must_use]
    pub fn with_points<T>(&self, points: Vec<Point<T>>) -> PolygonMesh<T> {
        assert_eq!(points.len(), self.points.len(), "a point for each point");
        self.on(points)
    }
}
