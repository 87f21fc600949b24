//! The least level whose mesh is within a tolerance of the limit surface as a set of points.

use super::level::Geometry;
use super::levels::{Levels as _, distances};
use super::patch::FaceSurface;
use super::place::{FaceDepth, GeometricDepth};
use crate::exact::Rational;
use crate::mesh::MeshError;
use crate::patch::mesh::distances::MeshDistances;
use crate::patch::mesh::levels::Source;

impl MeshDistances {
    /// The least level k with H_k ≤ ε, where
    ///
    /// H_k = max(sup_{p ∈ S} d(p, M_k), sup_{q ∈ M_k} d(q, S))
    ///
    /// is the Hausdorff distance of the mesh M_k of level k from the limit surface S, d the Euclidean distance of a
    /// point from a set. `surface` says what a face with four vertices or more is. A Doo–Sabin surface with
    /// boundary is compared with the quarters of faces at inner vertices.
    ///
    /// Source: `proofs/THEOREMS.md`, 160 to 163.
    ///
    /// # Errors
    /// When the tolerance is not positive or too small, or this is a solid. What caps leave open is open:
    /// then [`level`](GeometricDepth::level) may be `None`.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::mesh::{MeshScheme, PolygonMesh};
    /// use subcert::patch::{FaceSurface, MeshDistances};
    ///
    /// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
    /// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
    /// let mesh = PolygonMesh::new(points.to_vec(), faces)?;
    /// let distances = MeshDistances::new(mesh, MeshScheme::Loop)?;
    /// let tolerance = Rational::new(1, 20);
    /// let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear)?;
    /// let level = depth.level.expect("nothing stops the search");
    /// assert!(level <= distances.depth(&tolerance)?.level);
    /// assert_eq!(depth.too_few, Some(level - 1));
    /// # Ok::<(), subcert::mesh::MeshError>(())
    /// ```
    pub fn geometric_depth(
        &self,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<GeometricDepth, MeshError> {
        Geometry::new(self, surface, tolerance)?.depth()
    }

    /// For each face of the control mesh a lower and an upper bound of the distance, at a level, of its part of the mesh
    /// and its part of the limit from the whole other set: with upper bounds ε, ε/2, ε/4 or ε/8, or infinite
    /// where ε is none. Holes are neither: they have 0.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn geometric_distances(
        &self,
        level: u32,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<Vec<[f64; 2]>, MeshError> {
        let mut bounds =
            distances(level, tolerance, |tolerance| Geometry::new(self, surface, tolerance))?;
        if let Source::Surface { mesh, .. } = &self.model.source {
            for hole in mesh.tags().holes(mesh.connectivity()) {
                bounds[hole] = [0.0; 2];
            }
        }
        Ok(bounds)
    }

    /// What each face of the control mesh needs: its part of the mesh of a level, and its part of the limit, are
    /// within the tolerance of the whole other set.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth), and where a face may need too many levels.
    pub fn geometric_faces(
        &self,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<Vec<FaceDepth>, MeshError> {
        Geometry::new(self, surface, tolerance)?.faces()
    }
}
